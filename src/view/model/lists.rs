//! Rows of vertex indices in two flat arrays, checked once on input.

use super::error::ViewError;
use crate::math::Ragged;

/// Creates rows from `#rows + 1` offsets (empty for no rows) and indices, each below `count`.
///
/// # Errors
/// Offsets that do not divide the indices into rows, or an index that is too large. `what` names the
/// rows in the message.
pub fn rows(
    what: &'static str,
    offsets: Vec<u32>,
    indices: Vec<u32>,
    count: usize,
) -> Result<Ragged, ViewError> {
    let offsets = if offsets.is_empty() { vec![0] } else { offsets };
    if offsets[0] != 0 {
        return Err(ViewError::Offsets { what, row: 0 });
    }
    if let Some(row) = offsets.windows(2).position(|w| w[0] > w[1]) {
        return Err(ViewError::Offsets { what, row: row + 1 });
    }
    let last = offsets.len() - 1;
    if offsets[last] as usize != indices.len() {
        return Err(ViewError::Offsets { what, row: last });
    }
    check_indices(what, &indices, count)?;
    Ok(Ragged::from_parts(offsets, indices))
}

/// Checks that an array has the expected number of entries.
///
/// # Errors
/// If it has another number.
pub fn check_length(what: &'static str, got: usize, expected: usize) -> Result<(), ViewError> {
    if got == expected { Ok(()) } else { Err(ViewError::Length { what, got, expected }) }
}

/// Checks that every index is less than `count`.
///
/// # Errors
/// The first index that is not.
pub fn check_indices(what: &'static str, indices: &[u32], count: usize) -> Result<(), ViewError> {
    match indices.iter().find(|&&i| i as usize >= count) {
        Some(&index) => Err(ViewError::Index { what, index, count }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_rows_are_refused_by_name() {
        let message = |offsets: &[u32], indices: &[u32]| {
            rows("faces", offsets.to_vec(), indices.to_vec(), 4).unwrap_err().to_string()
        };
        assert!(message(&[0, 3], &[0, 1, 4]).contains("faces: found 4, expected an index below 4"));
        assert!(message(&[0, 4], &[0, 1, 2]).contains("offset 1"));
        assert!(message(&[1, 3], &[0, 1, 2]).contains("offset 0"));
        assert!(message(&[0, 3, 2, 3], &[0, 1, 2]).contains("offset 2"));
    }
}
