//! A list of lists of indices in two flat arrays.

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
