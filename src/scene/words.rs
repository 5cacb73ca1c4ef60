//! The words of enumerations: one list for each, used by scene files, the command line and all
//! hosts.

use super::{
    Accelerator, BoundaryRequire, ClosenessTo, Factorization, Lock, SmoothnessOf, Up, Weighting,
};
use crate::json::Words;
use crate::mesh::{GroupKeyword, Scheme};
use crate::solve::{ConformalNorm, ConformalWeights};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// An enumeration whose values each have a word.
pub trait NamedEnum: Copy + PartialEq + 'static {
    /// Every value with its word, in the order in which hosts list them.
    const WORDS: &'static [(&'static str, Self)];

    /// Returns the word of the value.
    fn word(self) -> &'static str {
        let found = Self::WORDS.iter().find(|(_, value)| *value == self);
        found.expect("every value has a word").0
    }

    /// Returns the value of a word; `None` if the word is unknown.
    fn of_word(word: &str) -> Option<Self> {
        Self::WORDS.iter().find(|(known, _)| *known == word).map(|(_, value)| *value)
    }

    /// Returns all words, separated by `between`.
    fn list(between: &str) -> String {
        Self::WORDS.iter().map(|(word, _)| *word).collect::<Vec<_>>().join(between)
    }
}

macro_rules! by_word {
    ($($Choice:ty),*) => {$(
        impl<'de> Deserialize<'de> for $Choice {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                from.deserialize_str(Words(Self::WORDS))
            }
        }

        impl Serialize for $Choice {
            fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                to.serialize_str(self.word())
            }
        }
    )*};
}

by_word!(
    Up,
    ClosenessTo,
    BoundaryRequire,
    SmoothnessOf,
    Weighting,
    Accelerator,
    Factorization,
    GroupKeyword,
    Scheme,
    Lock,
    ConformalWeights,
    ConformalNorm
);

impl NamedEnum for Scheme {
    const WORDS: &'static [(&'static str, Scheme)] = &[
        ("catmull-clark", Scheme::CatmullClark),
        ("linear", Scheme::Linear),
        ("loop", Scheme::Loop),
    ];
}

impl NamedEnum for Lock {
    const WORDS: &'static [(&'static str, Lock)] = &[
        ("weights", Lock::Weights),
        ("constraints", Lock::Constraints),
        ("handles", Lock::Handles),
        ("mesh", Lock::Mesh),
    ];
}

impl NamedEnum for Up {
    const WORDS: &'static [(&'static str, Up)] = &[("z", Up::Z), ("y", Up::Y)];
}

impl NamedEnum for ClosenessTo {
    const WORDS: &'static [(&'static str, ClosenessTo)] = &[
        ("surface", ClosenessTo::Surface),
        ("rest", ClosenessTo::Rest),
        ("none", ClosenessTo::None),
        ("target", ClosenessTo::Target),
    ];
}

impl NamedEnum for BoundaryRequire {
    const WORDS: &'static [(&'static str, BoundaryRequire)] = &[
        ("off", BoundaryRequire::Off),
        ("exact", BoundaryRequire::Exact),
        ("soft", BoundaryRequire::Soft),
    ];
}

impl NamedEnum for SmoothnessOf {
    const WORDS: &'static [(&'static str, SmoothnessOf)] =
        &[("surface", SmoothnessOf::Surface), ("displacement", SmoothnessOf::Displacement)];
}

impl NamedEnum for Weighting {
    const WORDS: &'static [(&'static str, Weighting)] = &[
        ("auto", Weighting::Auto),
        ("uniform", Weighting::Uniform),
        ("cotangent", Weighting::Cotangent),
        ("polygon", Weighting::Polygon),
    ];
}

impl NamedEnum for Accelerator {
    const WORDS: &'static [(&'static str, Accelerator)] = &[
        ("quasi-newton", Accelerator::QuasiNewton),
        ("anderson", Accelerator::Anderson),
        ("none", Accelerator::None),
    ];
}

impl NamedEnum for Factorization {
    const WORDS: &'static [(&'static str, Factorization)] = &[
        ("auto", Factorization::Auto),
        ("supernodal", Factorization::Supernodal),
        ("sprs-ldl", Factorization::SprsLdl),
    ];
}

impl NamedEnum for ConformalWeights {
    const WORDS: &'static [(&'static str, ConformalWeights)] = &[
        ("inverse-area", ConformalWeights::InverseArea),
        ("one", ConformalWeights::One),
        ("lscm", ConformalWeights::Lscm),
    ];
}

impl NamedEnum for ConformalNorm {
    const WORDS: &'static [(&'static str, ConformalNorm)] =
        &[("boundary", ConformalNorm::Boundary), ("vertices", ConformalNorm::Vertices)];
}

impl NamedEnum for GroupKeyword {
    const WORDS: &'static [(&'static str, GroupKeyword)] = &GroupKeyword::STATEMENTS;
}
