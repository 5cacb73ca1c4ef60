//! Line (paper section 3.1).

use super::{Arity, Info, Projection};
use crate::math::{Lane, Vec3};
use serde::{Deserialize, Serialize};

/// Line.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Line {}

impl Projection for Line {
    const INFO: Info = Info {
        id: "line",
        label: "Line",
        summary: "",
        paper: "3.1",
        arity: Arity::AtLeast(3),
        exact: false,
        colour: [128, 128, 128],
        params: &[],
    };

    fn project<S: Lane>(&self, _rest: &[Vec3<S>], _v: &mut [Vec3<S>]) {}
}
