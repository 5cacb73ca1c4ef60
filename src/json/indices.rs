//! Index lists: a JSON array, or a string of inclusive ranges such as `"0-199,240"`. Reading and
//! writing keep the order of the list. For serde's `with` attribute.

use serde::de::{self, Deserialize, Deserializer, SeqAccess, Unexpected, Visitor};
use serde::ser::{Serialize, Serializer};
use std::cell::Cell;
use std::fmt;

/// Upper bound on the number of indices that the ranges of one document expand to. A few bytes of
/// text can stand for any number of indices; this many take 64 MiB.
const MOST_INDICES: usize = 1 << 24;

thread_local! {
    /// How many more indices the ranges of the current document may expand to.
    static LEFT: Cell<usize> = const { Cell::new(MOST_INDICES) };
}

/// Resets the count at the start of a document.
pub(crate) fn begin() {
    LEFT.set(MOST_INDICES);
}

/// A list of indices in either form.
pub(crate) struct Indices<T = Vec<u32>>(pub(crate) T);

pub(crate) fn deserialize<'de, D: Deserializer<'de>, L: From<Vec<u32>>>(
    from: D,
) -> Result<L, D::Error> {
    from.deserialize_any(ListVisitor).map(L::from)
}

/// Reads a list that may be absent.
pub(crate) fn some<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec<u32>>, D::Error> {
    deserialize(from).map(Some)
}

impl<'de> Deserialize<'de> for Indices {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Indices, D::Error> {
        deserialize(from).map(Indices)
    }
}

impl Serialize for Indices<&[u32]> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        serialize(self.0, to)
    }
}

struct ListVisitor;

impl<'de> Visitor<'de> for ListVisitor {
    type Value = Vec<u32>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of indices such as [0, 1, 5] or \"0-1,5\"")
    }
    fn visit_str<E: de::Error>(self, text: &str) -> Result<Vec<u32>, E> {
        read_ranges(text).map_err(E::custom)
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Vec<u32>, A::Error> {
        let mut indices = Vec::with_capacity(array.size_hint().unwrap_or_default());
        while let Some(Index(index)) = array.next_element()? {
            indices.push(index);
        }
        Ok(indices)
    }
}

pub(super) struct Index(pub(super) u32);

impl<'de> Deserialize<'de> for Index {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Index, D::Error> {
        from.deserialize_u32(IndexVisitor).map(Index)
    }
}

struct IndexVisitor;

impl Visitor<'_> for IndexVisitor {
    type Value = u32;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an index, counted from 0")
    }
    fn visit_u64<E: de::Error>(self, index: u64) -> Result<u32, E> {
        let small = u32::try_from(index);
        small.map_err(|_| E::invalid_value(Unexpected::Unsigned(index), &self))
    }
}

fn read_ranges(text: &str) -> Result<Vec<u32>, String> {
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
                "the range {range:?} is reversed, expected the smaller index first"
            ));
        }
        let left = LEFT.get().checked_sub(((last - first) as usize).saturating_add(1));
        LEFT.set(left.ok_or_else(|| {
            format!("with the range {range:?} the document lists too many indices, expected at most {MOST_INDICES}")
        })?);
        indices.extend(first..=last);
    }
    Ok(indices)
}

/// Parses digits only: `parse` alone would accept a sign.
fn index(text: &str) -> Option<u32> {
    let text = text.trim();
    let digits = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    if digits { text.parse().ok() } else { None }
}

/// Writes an array, or the string of ranges if that is shorter.
pub(crate) fn serialize<S: Serializer>(indices: &[u32], to: S) -> Result<S::Ok, S::Error> {
    let digits = |index: &u32| index.checked_ilog10().unwrap_or(0) as usize + 1;
    let array = indices.iter().map(|index| digits(index) + ", ".len()).sum::<usize>();
    let ranges = ranges(indices);
    match indices.len() > 2 && ranges.len() + "\"\"".len() < array {
        true => to.serialize_str(&ranges),
        false => to.collect_seq(indices),
    }
}

fn ranges(indices: &[u32]) -> String {
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
    ranges
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<u32>, String> {
        begin();
        read_ranges(text)
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
        let write = |list: &[u32]| {
            let mut text = Vec::new();
            serialize(list, &mut serde_json::Serializer::new(&mut text)).unwrap();
            String::from_utf8(text).unwrap()
        };
        assert_eq!(write(&[]), "[]");
        assert_eq!(write(&[4, 5]), "[4,5]");
        assert_eq!(write(&[0, 1, 2, 3, 9]), "\"0-3,9\"");
        assert_eq!(write(&[9, 3, 4, 4]), "\"9,3-4,4\"");
        assert_eq!(read("9,3-4,4").unwrap(), [9, 3, 4, 4]);
    }
}
