//! Shapes of values that derived code does not check by itself. It takes the last of repeated keys
//! of a map, an array in the place of an object, and leaves items of a long array to be refused as
//! an error of syntax.

use super::error::twice;
use serde::de::value::MapAccessDeserializer;
use serde::de::{
    Deserialize, DeserializeSeed, Deserializer, Error, IntoDeserializer, MapAccess, SeqAccess,
    Unexpected, Visitor,
};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::fmt;
use std::marker::PhantomData;

/// Reads a key that may be absent, but must not be null if it is present.
pub(crate) fn present<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<Option<T>, D::Error> {
    T::deserialize(from).map(Some)
}

/// Reads an object, never an array of its values.
pub(crate) fn object<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<T, D::Error> {
    Object::deserialize(from).map(|Object(value)| value)
}

/// As [`object`], for a key that may be absent.
pub(crate) fn object_or_none<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<Option<T>, D::Error> {
    object(from).map(Some)
}

/// Reads an array of objects.
pub(crate) fn objects<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<Vec<T>, D::Error> {
    let items = Vec::deserialize(from)?;
    Ok(items.into_iter().map(|Object(value)| value).collect())
}

/// Reads an array of arrays of objects.
pub(crate) fn lists_of_objects<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<Vec<Vec<T>>, D::Error> {
    let lists: Vec<Vec<Object<T>>> = Vec::deserialize(from)?;
    let values = |list: Vec<Object<T>>| list.into_iter().map(|Object(value)| value).collect();
    Ok(lists.into_iter().map(values).collect())
}

/// A value that is an object, never an array of its values.
pub(crate) struct Object<T>(pub(crate) T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Object<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Object<T>, D::Error> {
        struct OfMap<T>(PhantomData<T>);

        impl<'de, T: Deserialize<'de>> Visitor<'de> for OfMap<T> {
            type Value = T;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<T, A::Error> {
                T::deserialize(MapAccessDeserializer::new(map))
            }
        }
        from.deserialize_map(OfMap(PhantomData)).map(Object)
    }
}

/// Reads an enum without fields, of which `serde_json` takes anything but a word for an error of syntax.
pub(crate) fn word<'de, D: Deserializer<'de>, T: Deserialize<'de>>(from: D) -> Result<T, D::Error> {
    Word::deserialize(from).map(|Word(value)| value)
}

/// As [`word`], or null.
pub(crate) fn word_or_null<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<Option<T>, D::Error> {
    let read = Option::deserialize(from)?;
    Ok(read.map(|Word(value)| value))
}

struct Word<T>(T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Word<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Word<T>, D::Error> {
        struct OfWord<T>(PhantomData<T>);

        impl<'de, T: Deserialize<'de>> Visitor<'de> for OfWord<T> {
            type Value = T;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a word")
            }
            fn visit_str<E: Error>(self, word: &str) -> Result<T, E> {
                T::deserialize(word.into_deserializer())
            }
        }
        from.deserialize_str(OfWord(PhantomData)).map(Word)
    }
}

/// A word, or an object with more.
pub(crate) enum Either<T> {
    Word(String),
    Object(T),
}

/// Reads a word or an object; `expected` describes both.
pub(crate) fn word_or<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
    expected: &str,
) -> Result<Either<T>, D::Error> {
    struct OfEither<'a, T>(&'a str, PhantomData<T>);

    impl<'de, T: Deserialize<'de>> Visitor<'de> for OfEither<'_, T> {
        type Value = Either<T>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str(self.0)
        }
        fn visit_str<E: Error>(self, word: &str) -> Result<Either<T>, E> {
            Ok(Either::Word(word.to_owned()))
        }
        fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Either<T>, A::Error> {
            T::deserialize(MapAccessDeserializer::new(map)).map(Either::Object)
        }
    }
    from.deserialize_any(OfEither(expected, PhantomData))
}

/// Words that each stand for a value.
pub(crate) struct Words<'a, T>(pub(crate) &'a [(&'static str, T)]);

impl<T: Copy> Visitor<'_> for Words<'_, T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words: Vec<_> = self.0.iter().map(|(word, _)| format!("{word:?}")).collect();
        f.write_str(&words.join(" or "))
    }
    fn visit_str<E: Error>(self, word: &str) -> Result<T, E> {
        let found = self.0.iter().find(|(known, _)| *known == word);
        found.map(|(_, value)| *value).ok_or_else(|| E::invalid_value(Unexpected::Str(word), &self))
    }
}

/// The entries of an object with keys of any name, in their order; a repeated key is refused.
pub(crate) struct Entries<T>(pub(crate) Vec<(String, T)>);

impl<T> Default for Entries<T> {
    fn default() -> Self {
        Entries(Vec::new())
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Entries<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Entries<T>, D::Error> {
        struct InOrder<T>(PhantomData<T>);

        impl<'de, T: Deserialize<'de>> Visitor<'de> for InOrder<T> {
            type Value = Entries<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Entries<T>, A::Error> {
                let (mut entries, mut keys) = (Vec::new(), BTreeSet::new());
                while let Some((key, value)) = map.next_entry::<String, T>()? {
                    if !keys.insert(key.clone()) {
                        return Err(A::Error::custom(twice(&key)));
                    }
                    entries.push((key, value));
                }
                Ok(Entries(entries))
            }
        }
        from.deserialize_map(InOrder(PhantomData))
    }
}

/// The entries of an object without those whose key `is_apart`, which go to `apart`.
pub(crate) struct SplitKeys<'a, A, F> {
    pub(crate) map: A,
    pub(crate) is_apart: F,
    pub(crate) apart: &'a mut Map<String, Value>,
}

impl<'de, A: MapAccess<'de>, F: Fn(&str) -> bool> MapAccess<'de> for SplitKeys<'_, A, F> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, A::Error> {
        while let Some(key) = self.map.next_key::<String>()? {
            if !(self.is_apart)(&key) {
                return seed.deserialize(key.into_deserializer()).map(Some);
            }
            let value = self.map.next_value()?;
            if self.apart.contains_key(&key) {
                return Err(A::Error::custom(twice(&key)));
            }
            self.apart.insert(key, value);
        }
        Ok(None)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.map.next_value_seed(seed)
    }
}

/// Reads an array of exactly `N` numbers, for a key that may be absent or not.
pub(crate) fn fixed<'de, D: Deserializer<'de>, T: From<[f64; N]>, const N: usize>(
    from: D,
) -> Result<T, D::Error> {
    Fixed::deserialize(from).map(|Fixed(numbers)| T::from(numbers))
}

/// Reads an array of points, `#points by 3`.
pub(crate) fn points<'de, D: Deserializer<'de>, T: From<Vec<[f64; 3]>>>(
    from: D,
) -> Result<T, D::Error> {
    let points: Vec<Fixed<3>> = Vec::deserialize(from)?;
    Ok(points.into_iter().map(|Fixed(point)| point).collect::<Vec<_>>().into())
}

struct Fixed<const N: usize>([f64; N]);

impl<'de, const N: usize> Deserialize<'de> for Fixed<N> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Fixed<N>, D::Error> {
        from.deserialize_seq(OfLength::<N>)
    }
}

struct OfLength<const N: usize>;

impl<'de, const N: usize> Visitor<'de> for OfLength<N> {
    type Value = Fixed<N>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match N {
            3 => f.write_str("a point [x, y, z]"),
            _ => write!(f, "an array of {N} numbers"),
        }
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Fixed<N>, A::Error> {
        let mut numbers = [0.0; N];
        for (k, number) in numbers.iter_mut().enumerate() {
            *number = array.next_element()?.ok_or_else(|| A::Error::invalid_length(k, &self))?;
        }
        let mut length = N;
        while array.next_element::<serde::de::IgnoredAny>()?.is_some() {
            length += 1;
        }
        if length > N { Err(A::Error::invalid_length(length, &self)) } else { Ok(Fixed(numbers)) }
    }
}
