//! Test inputs for the properties of every kind: kinds, numbers of points, and points.

use crate::support::project::project;
use crate::support::random::{Points, Random, centred, farthest, in_frame, size};
use crate::support::shapes::{Shape, cloud, shapes};
use serde_json::Value;
use shape_up::constraint::{Arity, Centring, Form, Info, KINDS, Kind, Param};
use shape_up::math::Vec3;
use std::fmt;

/// One test input: centred points and centred rest points.
pub(crate) struct Case {
    pub(crate) kind: Kind,
    pub(crate) shape: Shape,
    pub(crate) n: usize,
    pub(crate) seed: u64,
    pub(crate) rest: Points,
    pub(crate) points: Points,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let id = self.kind.info().id;
        write!(f, "{id} {}, n = {}, seed {}", self.shape.params, self.n, self.seed)
    }
}

impl Case {
    pub(crate) fn project(&self) -> Points {
        project(&self.kind, &self.rest, &self.points)
    }
    pub(crate) fn centred(&self, points: &[Vec3<f64>]) -> Points {
        centred_as(self.kind.info().centring, points)
    }
    pub(crate) fn with(
        &self,
        map: impl Fn(Vec3<f64>) -> Vec3<f64>,
        rest: impl Fn(Vec3<f64>) -> Vec3<f64>,
    ) -> Case {
        Case {
            kind: self.kind.clone(),
            rest: self.rest.iter().map(|v| rest(*v)).collect(),
            points: self.points.iter().map(|v| map(*v)).collect(),
            ..*self
        }
    }
}

/// The points, centred as the kind declares.
pub(crate) fn centred_as(centring: Centring, points: &[Vec3<f64>]) -> Points {
    match centring {
        Centring::Together => centred(points),
        Centring::ByEdge => points.chunks(2).flat_map(centred).collect(),
        Centring::Placed => points.to_vec(),
    }
}

/// Every kind with the parameters of each of its descriptions.
pub(crate) fn kinds() -> Vec<(Kind, Shape)> {
    let with_accounts = KINDS.iter().flat_map(|info| {
        let accounts = shapes(info).into_iter();
        accounts
            .map(|shape| (kind(info.id, serde_json::from_str(shape.params).expect("JSON")), shape))
    });
    with_accounts.collect()
}

pub(crate) fn kind(id: &str, params: Value) -> Kind {
    Kind::new(id, params).unwrap_or_else(|error| panic!("{id}: {error:?}"))
}

/// The kind with each parameter changed by `change`.
pub(crate) fn with_params(kind: &Kind, change: impl Fn(&Param, Value) -> Value) -> Kind {
    let info = kind.info();
    let mut params = kind.params();
    for param in info.params {
        params[param.id] = change(param, params[param.id].take());
    }
    self::kind(info.id, params)
}

/// The equivalent kind for lengths multiplied by `scale`.
pub(crate) fn scaled(kind: &Kind, scale: f64) -> Kind {
    with_params(kind, |param, value| {
        let factor = match param.unit {
            "length" => scale,
            "area" => scale.powi(2),
            "volume" => scale.powi(3),
            _ => return value,
        };
        let scaled = |value: Value| value.as_f64().map_or(value, |number| (number * factor).into());
        match value {
            Value::Array(ends) => ends.into_iter().map(scaled).collect(),
            value => scaled(value),
        }
    })
}

/// The equivalent kind in rotated space.
pub(crate) fn turned(kind: &Kind, frame: [Vec3<f64>; 3]) -> Kind {
    with_params(kind, |param, value| match value.as_array().map(Vec::as_slice) {
        Some([x, y, z]) if param.forms.contains(&Form::Vector) => {
            let direction = [x, y, z].map(|part| part.as_f64().expect("a vector has numbers"));
            <[f64; 3]>::from(in_frame(frame, direction.into())).to_vec().into()
        }
        _ => value,
    })
}

/// Whether the kind depends on directions or positions in space, so that its rest shape has to move
/// along.
pub(crate) fn is_oriented(kind: &Kind) -> bool {
    let info = kind.info();
    let params = kind.params();
    info.centring == Centring::Placed
        || info.params.iter().any(|param| {
            param.forms.contains(&Form::Vector) && params[param.id].as_array().is_some()
        })
}

/// Numbers of points to try.
pub(crate) fn sizes(info: &Info) -> Vec<usize> {
    match info.arity {
        Arity::AtLeast(n) if info.centring == Centring::ByEdge => vec![n, n + 2, 3 * n, 40],
        Arity::AtLeast(n) => vec![n, n + 1, n + 2, 2 * n + 3, 40],
        Arity::Exactly(n) => vec![n],
    }
}

/// Every kind and size with `seeds` point sets: clouds of three flatnesses and disturbed shapes.
pub(crate) fn cases(seeds: u64) -> Vec<Case> {
    let mut cases = Vec::new();
    for (kind, shape) in kinds() {
        let info = kind.info();
        for n in sizes(info) {
            for seed in 0..seeds {
                let mut random = Random::new(seed);
                let rest = (shape.rest)(&mut Random::new(!seed), n);
                let sample = (shape.sample)(&mut random, &rest);
                let disturbed: Points = sample.iter().map(|v| *v + random.vector() * 0.1).collect();
                let points = match seed % 4 {
                    0 => disturbed,
                    1 => cloud(&mut random, n, 1.0),
                    2 => cloud(&mut random, n, 0.1),
                    _ => cloud(&mut random, n, 1e-3),
                };
                let rest = centred_as(info.centring, &rest);
                let points = centred_as(info.centring, &points);
                cases.push(Case { kind: kind.clone(), shape, n, seed, rest, points });
            }
        }
    }
    cases
}

/// The same, only for kinds with a described set.
pub(crate) fn told(seeds: u64) -> impl Iterator<Item = Case> {
    cases(seeds).into_iter().filter(|case| case.shape.tells_the_set)
}

/// Fails unless `found` and `expected` agree to `tolerance`, as a fraction of the size of the case.
pub(crate) fn assert_close(
    case: &Case,
    what: &str,
    found: &[Vec3<f64>],
    expected: &[Vec3<f64>],
    tolerance: f64,
) {
    let error = farthest(found, expected) / size(&case.points);
    assert!(error <= tolerance, "{case}: {what}: off by {error:e} of the size");
}
