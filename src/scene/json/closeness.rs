//! "closeness": the target of the closeness energy. Another surface is written like the mesh of the
//! scene: as `to`, or as `target` while `to` is something else.

use super::mesh;
use crate::json::{Either, object, object_or_none, objects, word_or};
use crate::scene::{
    BoundaryCloseness, Closeness, ClosenessTo, ClosenessWeight, MeshSource, NamedEnum, Target,
};
use serde::de::{Deserialize, Deserializer, Error, Unexpected};
use serde::ser::{Serialize, Serializer};
use std::rc::Rc;

#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct ClosenessFile {
    #[serde(default, skip_serializing_if = "To::is_default")]
    to: To,
    #[serde(default, deserialize_with = "objects", skip_serializing_if = "Vec::is_empty")]
    weights: Vec<ClosenessWeight>,
    #[serde(default, deserialize_with = "object_or_none", skip_serializing_if = "Option::is_none")]
    boundary: Option<BoundaryCloseness>,
    #[serde(default, deserialize_with = "object_or_none", skip_serializing_if = "Option::is_none")]
    target: Option<TargetFile>,
}

impl<'de> Deserialize<'de> for Closeness {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Closeness, D::Error> {
        let ClosenessFile { to, target, weights, boundary } = object(from)?;
        let (to, target) = match (to, target) {
            (To::Word(to), kept) => (to, kept.map(|kept| kept.mesh)),
            (To::Surface(target), None) => (ClosenessTo::Target, Some(target)),
            (To::Surface(_), Some(_)) => {
                return Err(D::Error::custom(
                    "found a \"target\" beside the surface in \"to\", expected one of them",
                ));
            }
        };
        Ok(Closeness { to, target, weights, boundary: boundary.unwrap_or_default() })
    }
}

impl Serialize for Closeness {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Closeness { to: word, target, weights, boundary } = self.clone();
        let (own, target) = match (word, target) {
            (ClosenessTo::Target, Some(target)) => (To::Surface(target), None),
            (word, kept) => (To::Word(word), kept.map(|mesh| TargetFile { mesh })),
        };
        let boundary = Some(boundary).filter(|own| *own != BoundaryCloseness::default());
        ClosenessFile { to: own, target, weights, boundary }.serialize(to)
    }
}

/// A word, or another surface, which is written like the mesh of the scene.
enum To {
    Word(ClosenessTo),
    Surface(Target),
}

impl Default for To {
    fn default() -> To {
        To::Word(ClosenessTo::default())
    }
}

impl To {
    fn is_default(&self) -> bool {
        matches!(self, To::Word(to) if *to == ClosenessTo::default())
    }
}

#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct TargetFile {
    mesh: Target,
}

impl<'de> Deserialize<'de> for Target {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Target, D::Error> {
        Ok(match mesh::mesh_or_path(from)? {
            MeshSource::File(path) => Target::File(path),
            MeshSource::Inline(mesh) => Target::Mesh(Rc::from(mesh)),
        })
    }
}

impl<'de> Deserialize<'de> for To {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<To, D::Error> {
        const FORMS: &str = "\"surface\" or \"rest\" or \"none\" or { \"mesh\": ... }";
        match word_or(from, FORMS)? {
            Either::Object(TargetFile { mesh }) => Ok(To::Surface(mesh)),
            Either::Word(word) => ClosenessTo::of_word(&word)
                .filter(|to| *to != ClosenessTo::Target)
                .map(To::Word)
                .ok_or_else(|| D::Error::invalid_value(Unexpected::Str(&word), &FORMS)),
        }
    }
}

impl Serialize for To {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            To::Word(word) => word.serialize(to),
            To::Surface(target) => to.collect_map([("mesh", target)]),
        }
    }
}

impl Serialize for Target {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Target::File(path) => to.collect_map([("file", path)]),
            Target::Mesh(own) => mesh::write(own, to),
        }
    }
}
