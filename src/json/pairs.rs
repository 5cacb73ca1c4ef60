//! Lists of pairs of indices, such as edges by their ends: `[[0, 1], [5, 4]]`. For serde's `with`
//! attribute.

use super::indices::Index;
use serde::de::{Deserialize, Deserializer, Error, IgnoredAny, SeqAccess, Visitor};
use serde::ser::Serializer;
use std::fmt;
use std::rc::Rc;

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Rc<[[u32; 2]]>, D::Error> {
    let pairs: Vec<Pair> = Vec::deserialize(from)?;
    Ok(pairs.into_iter().map(|Pair(pair)| pair).collect())
}

pub(crate) fn serialize<S: Serializer>(pairs: &Rc<[[u32; 2]]>, to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(pairs.iter())
}

struct Pair([u32; 2]);

impl<'de> Deserialize<'de> for Pair {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Pair, D::Error> {
        from.deserialize_seq(PairVisitor)
    }
}

struct PairVisitor;

impl<'de> Visitor<'de> for PairVisitor {
    type Value = Pair;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a pair of indices such as [3, 4]")
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Pair, A::Error> {
        let mut pair = [0; 2];
        for (k, index) in pair.iter_mut().enumerate() {
            let Index(found) =
                array.next_element()?.ok_or_else(|| A::Error::invalid_length(k, &self))?;
            *index = found;
        }
        // A longer array would be an error of syntax.
        let mut length = pair.len();
        while array.next_element::<IgnoredAny>()?.is_some() {
            length += 1;
        }
        if length > pair.len() {
            return Err(A::Error::invalid_length(length, &self));
        }
        Ok(Pair(pair))
    }
}
