//! Index lists: a JSON array, or a string of ranges such as `"0-199,240"` with both ends included.
//! The order of the list is kept, in and out.

use super::node::{JsonCursor, Node};
use crate::scene::SceneError;

const WHAT: &str = "a list of indices such as [0, 1, 5] or \"0-1,5\"";

pub(crate) fn read(at: &JsonCursor<'_>) -> Result<Vec<u32>, SceneError> {
    match at.node {
        Node::Array(_) => {
            at.array(WHAT)?.iter().map(|item| item.whole("an index, counted from 0")).collect()
        }
        Node::Text(text) => {
            read_ranges(text, |count| at.takes_indices(count)).map_err(|message| at.error(message))
        }
        _ => Err(at.expected(WHAT)),
    }
}

/// `takes` tells whether there is room for so many more indices: before they take any.
fn read_ranges(text: &str, takes: impl Fn(usize) -> bool) -> Result<Vec<u32>, String> {
    let mut indices = Vec::new();
    if text.trim().is_empty() {
        return Ok(indices);
    }
    for range in text.split(',') {
        let range = range.trim();
        let (first, last) = range.split_once('-').unwrap_or((range, range));
        let (Some(first), Some(last)) = (index(first), index(last)) else {
            return Err(format!(
                "found the range {range:?}, expected an index such as 7 or a range such as 0-199"
            ));
        };
        if first > last {
            return Err(format!(
                "the range {range:?} runs backwards, expected the smaller index first"
            ));
        }
        if !takes(((last - first) as usize).saturating_add(1)) {
            return Err(format!(
                "with the range {range:?} the lists of the scene are longer than any mesh"
            ));
        }
        indices.extend(first..=last);
    }
    Ok(indices)
}

/// Digits only: `parse` alone would also take a sign.
fn index(text: &str) -> Option<u32> {
    let text = text.trim();
    let digits = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    if digits { text.parse().ok() } else { None }
}

/// The list as JSON: an array, or the string of ranges where that is shorter.
pub(super) fn write(indices: &[u32]) -> String {
    let mut ranges = String::new();
    let mut rest = indices;
    while let Some(&first) = rest.first() {
        let run = rest
            .iter()
            .zip(u64::from(first)..)
            .take_while(|&(&i, next)| u64::from(i) == next)
            .count();
        if !ranges.is_empty() {
            ranges.push(',');
        }
        ranges.push_str(&first.to_string());
        if run > 1 {
            ranges.push_str(&format!("-{}", rest[run - 1]));
        }
        rest = &rest[run..];
    }
    let array: Vec<_> = indices.iter().map(u32::to_string).collect();
    let (ranges, array) = (format!("\"{ranges}\""), format!("[{}]", array.join(", ")));
    if indices.len() > 2 && ranges.len() < array.len() { ranges } else { array }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<u32>, String> {
        read_ranges(text, |_| true)
    }

    #[test]
    fn ranges_include_both_ends_and_keep_their_order() {
        assert_eq!(read("0-3,7, 5 - 6").unwrap(), [0, 1, 2, 3, 7, 5, 6]);
        assert_eq!(read(" ").unwrap(), [0u32; 0]);
    }

    #[test]
    fn a_bad_range_is_named() {
        for bad in ["0-", "-3", "1,,2", "a", "3-1", "+1", "1.5", "4294967296"] {
            let message = read(bad).unwrap_err();
            assert!(message.contains("range"), "{bad}: {message}");
        }
    }

    #[test]
    fn the_shorter_form_is_written_and_reads_back() {
        assert_eq!(write(&[]), "[]");
        assert_eq!(write(&[4, 5]), "[4, 5]");
        assert_eq!(write(&[0, 1, 2, 3, 9]), "\"0-3,9\"");
        assert_eq!(write(&[9, 3, 4, 4]), "\"9,3-4,4\"");
        assert_eq!(read("9,3-4,4").unwrap(), [9, 3, 4, 4]);
    }
}
