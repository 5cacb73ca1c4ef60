//! Lists of indices: sorting by integer keys, marked elements, and lists of lists in two flat arrays.

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

fn order(mut keyed: Vec<(u64, u32)>) -> Vec<u32> {
    // Few keys, as of one face, are not worth the tables of counts.
    if keyed.len() < 500 {
        keyed.sort_unstable();
    } else {
        sort_by_digits(&mut keyed);
    }
    keyed.into_iter().map(|(_, index)| index).collect()
}

/// Sorts by key, a digit of 11 bits at a time from the lowest on; equal keys keep their order. In wasm,
/// the half-edges of 10,000 vertices take little more than half the time of comparing.
fn sort_by_digits(keyed: &mut Vec<(u64, u32)>) {
    const BITS: u32 = 11;
    let digit = |key: u64, at: u32| (key >> at) as usize & ((1 << BITS) - 1);
    // Digits in which no keys differ need no pass.
    let first = keyed[0].0;
    let differing = keyed.iter().fold(0, |all, (key, _)| all | (key ^ first));
    let mut sorted = keyed.clone();
    for at in (0..u64::BITS).step_by(BITS as usize).filter(|&at| digit(differing, at) != 0) {
        let mut ends = [0_usize; 1 << BITS];
        keyed.iter().for_each(|&(key, _)| ends[digit(key, at)] += 1);
        let mut start = 0;
        for end in &mut ends {
            start += std::mem::replace(end, start);
        }
        for &item in keyed.iter() {
            let place = &mut ends[digit(item.0, at)];
            sorted[*place] = item;
            *place += 1;
        }
        std::mem::swap(keyed, &mut sorted);
    }
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

/// A list of rows of different lengths, such as the corners of each face.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ragged {
    /// `#rows + 1`: row `i` is `indices[offsets[i]..offsets[i + 1]]`.
    offsets: Vec<u32>,
    indices: Vec<u32>,
}

impl Default for Ragged {
    fn default() -> Self {
        Ragged { offsets: vec![0], indices: Vec::new() }
    }
}

impl Ragged {
    /// Returns a list without rows.
    pub fn new() -> Self {
        Self::default()
    }
    /// Builds rows from `#rows + 1` offsets that ascend from zero to the number of entries; panics if
    /// they do not end there.
    pub fn from_parts(offsets: Vec<u32>, indices: Vec<u32>) -> Self {
        assert_eq!(offsets.last().copied(), Some(indices.len() as u32), "the last row ends there");
        Ragged { offsets, indices }
    }
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }
    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Returns row `i`; panics if `i` is out of range.
    #[inline]
    pub fn row(&self, i: usize) -> &[u32] {
        &self.indices[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }
    /// Appends a row.
    #[inline]
    pub fn push(&mut self, row: &[u32]) {
        self.indices.extend_from_slice(row);
        self.offsets.push(self.indices.len() as u32);
    }
    /// Releases unused capacity.
    pub fn shrink_to_fit(&mut self) {
        self.offsets.shrink_to_fit();
        self.indices.shrink_to_fit();
    }
    /// Sorts the entries of each row.
    pub fn sort_rows(&mut self) {
        for ends in self.offsets.windows(2) {
            self.indices[ends[0] as usize..ends[1] as usize].sort_unstable();
        }
    }
    /// Replaces every entry `v` by `name[v]`.
    pub fn rename(&mut self, name: &[u32]) {
        self.indices.iter_mut().for_each(|v| *v = name[*v as usize]);
    }
    /// All rows in order.
    #[inline]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> + Clone {
        self.offsets.windows(2).map(|w| &self.indices[w[0] as usize..w[1] as usize])
    }
    /// `#rows + 1` offsets into [`Ragged::indices`].
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }
    /// The entries of all rows, one after another.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }
}

impl<R: AsRef<[u32]>> FromIterator<R> for Ragged {
    fn from_iter<T: IntoIterator<Item = R>>(rows: T) -> Self {
        let mut ragged = Ragged::new();
        for row in rows {
            ragged.push(row.as_ref());
        }
        ragged.shrink_to_fit();
        ragged
    }
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

    #[test]
    fn many_keys_are_sorted_like_few() {
        let mix = |i: u64| i.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        for (count, mask) in [(499, u64::MAX), (500, u64::MAX), (5000, 0xFF00_0000_3F00), (700, 0)]
        {
            let keys: Vec<u64> = (0..count).map(|i| mix(i) & mask).collect();
            let mut expected: Vec<u32> = (0..count as u32).collect();
            expected.sort_by_key(|&i| keys[i as usize]);
            assert_eq!(argsort(keys.into_iter()), expected);
        }
    }
}
