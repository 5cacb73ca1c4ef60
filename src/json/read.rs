//! Deserializes serde types from a tree, with the JSON path of an error.
//!
//! We do not wrap another deserializer, because this code is instantiated for every type and must
//! be small. An enum with fields is an object whose `type` names the variant.

use super::error::JsonError;
use super::tree::Tree;
use serde::de::value::StrDeserializer;
use serde::de::{
    Deserialize, DeserializeOwned, DeserializeSeed, Deserializer, EnumAccess, Error, Expected,
    IntoDeserializer, MapAccess, SeqAccess, VariantAccess, Visitor,
};
use serde_json::{Number, Value};

/// Deserializes a value.
///
/// # Errors
/// A value that does not fit; the path of the error is relative to `value`.
pub(crate) fn read<T: DeserializeOwned>(value: &Value) -> Result<T, JsonError> {
    read_tree(&value.into())
}

/// Deserializes a document.
pub(crate) fn read_tree<T: DeserializeOwned>(tree: &Tree) -> Result<T, JsonError> {
    T::deserialize(Reader(tree, None))
}

/// Deserializes a key that may be absent, but must not be null if it is present.
pub(crate) fn present<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<Option<T>, D::Error> {
    T::deserialize(from).map(Some)
}

const TAG: &str = "type";

/// A JSON value to be read, ignoring the entry with the given key.
#[derive(Clone, Copy)]
struct Reader<'de>(&'de Tree, Option<&'static str>);

impl<'de> Reader<'de> {
    fn number(self) -> Option<&'de Number> {
        if let Tree::Number(number) = self.0 { Some(number) } else { None }
    }

    fn unlike<T>(self, expected: &dyn Expected) -> Result<T, JsonError> {
        Err(JsonError::found(&self.0.describe(), &expected.to_string()))
    }
}

impl<'de> Deserializer<'de> for Reader<'de> {
    type Error = JsonError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.0 {
            Tree::Null => visitor.visit_unit(),
            Tree::Bool(value) => visitor.visit_bool(*value),
            Tree::Number(number) => match (number.as_u64(), number.as_i64()) {
                (Some(value), _) => visitor.visit_u64(value),
                (None, Some(value)) => visitor.visit_i64(value),
                (None, None) => visitor.visit_f64(number.as_f64().unwrap_or(f64::NAN)),
            },
            Tree::Text(text) => visitor.visit_str(text),
            Tree::Array(items) => visitor.visit_seq(Items(items.iter().enumerate())),
            Tree::Object(entries) => {
                visitor.visit_map(Entries { rest: entries.iter(), but: self.1, current: None })
            }
        }
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.0 {
            Tree::Bool(value) => visitor.visit_bool(*value),
            _ => self.unlike(&visitor),
        }
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.number().and_then(Number::as_f64) {
            Some(value) => visitor.visit_f64(value),
            None => self.unlike(&visitor),
        }
    }

    fn deserialize_u64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.number().and_then(Number::as_u64) {
            Some(value) => visitor.visit_u64(value),
            None => self.unlike(&visitor),
        }
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        self.deserialize_u64(visitor)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.0 {
            Tree::Text(text) => visitor.visit_str(text),
            _ => self.unlike(&visitor),
        }
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        self.deserialize_str(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.0 {
            Tree::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, JsonError> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.0 {
            Tree::Array(items) => visitor.visit_seq(Items(items.iter().enumerate())),
            _ => self.unlike(&visitor),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(
        self,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, JsonError> {
        match self.0 {
            Tree::Array(items) if items.len() == length => self.deserialize_seq(visitor),
            _ => self.unlike(&visitor),
        }
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, JsonError> {
        match self.0 {
            Tree::Object(entries) => {
                visitor.visit_map(Entries { rest: entries.iter(), but: self.1, current: None })
            }
            _ => self.unlike(&visitor),
        }
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, JsonError> {
        self.deserialize_map(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, JsonError> {
        match self.0 {
            Tree::Text(_) | Tree::Object(_) => visitor.visit_enum(self),
            // Reports what was found.
            _ => self.deserialize_any(visitor),
        }
    }

    serde::forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u8 u16 u128 f32 char bytes byte_buf unit unit_struct tuple_struct identifier
        ignored_any
    }
}

/// A variant is its name alone, or an object that contains its name and its fields.
impl<'de> EnumAccess<'de> for Reader<'de> {
    type Error = JsonError;
    type Variant = Self;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<(S::Value, Self), JsonError> {
        if let Tree::Text(word) = self.0 {
            return Ok((seed.deserialize(key(word))?, self));
        }
        let tag = self.0.get(TAG).ok_or_else(|| JsonError::missing_field(TAG))?;
        let variant = match tag {
            Tree::Text(word) => seed.deserialize(key(word)),
            other => Err(JsonError::found(&other.describe(), "a string")),
        };
        Ok((variant.map_err(|error| error.below_key(TAG))?, Reader(self.0, Some(TAG))))
    }
}

impl<'de> VariantAccess<'de> for Reader<'de> {
    type Error = JsonError;

    fn unit_variant(self) -> Result<(), JsonError> {
        Ok(())
    }

    fn newtype_variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, JsonError> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, JsonError> {
        self.unlike(&visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, JsonError> {
        self.deserialize_map(visitor)
    }
}

fn key(word: &str) -> StrDeserializer<'_, JsonError> {
    word.into_deserializer()
}

/// The items of an array with their indices.
struct Items<'de>(std::iter::Enumerate<std::slice::Iter<'de, Tree>>);

impl<'de> SeqAccess<'de> for Items<'de> {
    type Error = JsonError;

    fn next_element_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, JsonError> {
        let Some((k, item)) = self.0.next() else { return Ok(None) };
        seed.deserialize(Reader(item, None)).map(Some).map_err(|error| error.below_index(k))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

/// The entries of an object that remain, and the entry whose key has just been read.
struct Entries<'de> {
    rest: std::slice::Iter<'de, (String, Tree)>,
    but: Option<&'static str>,
    current: Option<(&'de str, &'de Tree)>,
}

impl<'de> Entries<'de> {
    /// Advances to the next entry. Not inlined, to keep the code of each type small.
    #[inline(never)]
    fn advance(&mut self) -> Option<&'de str> {
        let next = self.rest.find(|(key, _)| self.but.is_none_or(|but| but != key));
        self.current = next.map(|(key, value)| (key.as_str(), value));
        self.current.map(|(key, _)| key)
    }
}

impl<'de> MapAccess<'de> for Entries<'de> {
    type Error = JsonError;

    fn next_key_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, JsonError> {
        let Some(word) = self.advance() else { return Ok(None) };
        seed.deserialize(key(word)).map(Some)
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, JsonError> {
        let (key, value) = self.current.expect("serde reads a key before its value");
        seed.deserialize(Reader(value, None)).map_err(|error| error.below_key(key))
    }
}
