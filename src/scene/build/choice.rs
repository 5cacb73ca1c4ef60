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

    /// Its identifier in files and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            OffsetKind::Corner => "corner",
            OffsetKind::Face => "face",
            OffsetKind::Edge => "edge",
        }
    }
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

impl Pieces {
    /// All kinds.
    pub const ALL: [Pieces; 3] = [Pieces::Nets, Pieces::Strips, Pieces::Across];

    /// Its identifier in files and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            Pieces::Nets => "nets",
            Pieces::Strips => "strips",
            Pieces::Across => "across",
        }
    }
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

/// The pages of a PDF.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Page {
    /// The size of the sheets.
    #[default]
    Sheet,
    /// 210 x 297 mm.
    A4,
    /// 297 x 420 mm.
    A3,
}

impl Page {
    /// All page sizes.
    pub const ALL: [Page; 3] = [Page::Sheet, Page::A4, Page::A3];

    /// Its identifier in files and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            Page::Sheet => "sheet",
            Page::A4 => "a4",
            Page::A3 => "a3",
        }
    }

    /// Its shorter and its longer side in mm; none for the size of the sheet.
    pub fn size(self) -> Option<[f64; 2]> {
        match self {
            Page::Sheet => None,
            Page::A4 => Some([210.0, 297.0]),
            Page::A3 => Some([297.0, 420.0]),
        }
    }

    /// The unprintable margin of a page, in mm.
    pub const FREE: f64 = 5.0;
    /// Overlap of neighbouring pages, in mm.
    pub const OVERLAP: f64 = 10.0;

    /// The least number of pages that a sheet is printed on.
    pub(crate) fn count(self, sheet: [f64; 2]) -> u64 {
        let Some([short, long]) = self.size() else { return 1 };
        let both = [[short, long], [long, short]];
        let count = |page| page_counts(sheet, page).map(u64::from).iter().product();
        let counts: [u64; 2] = both.map(count);
        counts[0].min(counts[1])
    }
}

/// The number of pages of a sheet along its width and its height.
pub(crate) fn page_counts(sheet: [f64; 2], page: [f64; 2]) -> [u32; 2] {
    [0, 1].map(|k| {
        let used = page[k] - 2.0 * Page::FREE;
        let more = (sheet[k] - used) / (used - Page::OVERLAP);
        if more > 0.0 { (more.ceil() as u32).saturating_add(1) } else { 1 }
    })
}
