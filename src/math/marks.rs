//! Marks: for each element of a list, whether it is one of some.

use std::borrow::Borrow;

/// Returns for each of `count` elements whether its index is among `items`.
pub fn marked(count: usize, items: impl IntoIterator<Item = impl Borrow<u32>>) -> Vec<bool> {
    let mut marks = vec![false; count];
    items.into_iter().for_each(|item| marks[*item.borrow() as usize] = true);
    marks
}
