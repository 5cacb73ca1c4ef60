//! The elements that keep their distance in an offset.

use serde::{Deserialize, Serialize};

/// The condition on the node axes `n_i` besides parallel edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum OffsetKind {
    /// `|n_i| = 1`: corners keep their distance. Exact on circular meshes.
    Corner,
    /// `n_i . N_f = 1` at every corner: panels keep their distance (constant thickness). Exact on
    /// conical meshes, and wherever three flat panels meet at every vertex.
    Face,
    /// `|P_e n_i| = 1`: all beams have the same height. Exact on few meshes.
    Edge,
}

impl OffsetKind {
    /// All kinds.
    pub const ALL: [OffsetKind; 3] = [OffsetKind::Corner, OffsetKind::Face, OffsetKind::Edge];

    /// Its identifier in files and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            OffsetKind::Corner => "corner",
            OffsetKind::Face => "face",
            OffsetKind::Edge => "edge",
        }
    }
}
