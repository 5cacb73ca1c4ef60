//! The choices among the settings of a build.

use serde::{Deserialize, Serialize};

/// A product.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Product {
    /// Single panels.
    #[default]
    Panels,
    /// Beams along the edges, as flat fins, with the nodes between them.
    Fins,
    /// Strips and nets of paper, folded and glued.
    Paper,
}

impl Product {
    /// All products.
    pub const ALL: [Product; 3] = [Product::Panels, Product::Fins, Product::Paper];

    /// Its identifier in files and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            Product::Panels => "panels",
            Product::Fins => "fins",
            Product::Paper => "paper",
        }
    }
}

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
}

/// How panels are named.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Names {
    /// By the index of the face.
    #[default]
    Index,
    /// By row and column if the mesh is one grid of quads; else by the index.
    Rows,
    /// By row from the supports and number along the row.
    Assembly,
}

/// The order in which parts are laid out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Order {
    /// Highest first: needs fewest sheets.
    #[default]
    Size,
    /// By name: neighbours stay together.
    Names,
}

/// The kind of pieces of a paper model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Pieces {
    /// Nets: the flattest edges are folded first.
    #[default]
    Nets,
    /// Strips of quads, in the direction through the first side of the first face.
    Strips,
    /// Strips of quads, in the other direction.
    Across,
}

/// How the folds of a paper model are made. Except for creases, they are true to the thickness of the
/// card, which has no tabs: its edges are glued or taped to each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Fold {
    /// Creased, of paper whose thickness does not count.
    #[default]
    Crease,
    /// Cut half through on the side that opens.
    Score,
    /// Cut from the inside: ridges as a groove.
    VCut,
    /// Cut through, and held by tape.
    Separate,
}

/// How the cut edges of creased paper are joined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Join {
    /// By tabs for glue.
    #[default]
    Tabs,
    /// By tongues in slots, without glue; by tabs where these have no room.
    Slots,
}

/// A version of DXF.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Dxf {
    /// AC1015: closed lightweight polylines, units in the header.
    #[default]
    R2000,
    /// AC1009, for old machines.
    R12,
}
