//! Lists of indices: sorting by integer keys, and marked elements. The standard library's sort
//! costs five to ten kilobytes of machine code for every type that is sorted; all callers with
//! integer keys share one copy.

use std::borrow::Borrow;

/// Returns the indices of `keys` in ascending order of the keys; equal keys keep their order.
pub fn argsort(keys: impl Iterator<Item = u64>) -> Vec<u32> {
    order(keys.zip(0..).collect())
}

/// Sorts `items` by integer keys; items with equal keys keep their order.
pub fn sort_by_number<T: Clone>(items: &mut Vec<T>, key: impl Fn(&T) -> u64) {
    let order = argsort(items.iter().map(key));
    *items = order.into_iter().map(|i| items[i as usize].clone()).collect();
}

#[inline(never)]
fn order(mut keyed: Vec<(u64, u32)>) -> Vec<u32> {
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, index)| index).collect()
}

/// Packs two numbers into one key, ordered by the first number, then by the second.
pub fn key_of_pair([major, minor]: [u32; 2]) -> u64 {
    u64::from(major) << 32 | u64::from(minor)
}

/// Returns a key in the order of [`f64::total_cmp`].
pub fn key_of_number(x: f64) -> u64 {
    let bits = x.to_bits();
    // Negative numbers sort before the others, by descending magnitude.
    if x.is_sign_negative() { !bits } else { bits | 1 << 63 }
}

/// Returns for each of `count` elements whether its index is among `items`.
pub fn marked(count: usize, items: impl IntoIterator<Item = impl Borrow<u32>>) -> Vec<bool> {
    let mut marks = vec![false; count];
    items.into_iter().for_each(|item| marks[*item.borrow() as usize] = true);
    marks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorts_as_the_standard_library_does_and_keeps_the_order_of_equals() {
        let numbers = [1.5, -0.0, f64::NAN, -2.0, 0.0, f64::NEG_INFINITY, 1.5, -1e-300, 3e9];
        let mut expected: Vec<usize> = (0..numbers.len()).collect();
        expected.sort_by(|&a, &b| numbers[a].total_cmp(&numbers[b]));
        let found = argsort(numbers.into_iter().map(key_of_number));
        assert_eq!(found, expected.into_iter().map(|i| i as u32).collect::<Vec<_>>());
        let pairs = [[2, 1], [1, u32::MAX], [2, 0], [1, 0], [2, 0]];
        assert_eq!(argsort(pairs.into_iter().map(key_of_pair)), [3, 1, 2, 4, 0]);
    }
}
