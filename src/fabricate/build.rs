//! All parts of one shape: panels with joints and names on sheets, and the offset.

use super::alike::Types;
use super::beam::Frame;
use super::fault::Fault;
use super::file::{Drawing, places};
use super::offset::{Axes, OffsetCheck, axes_of, check};
use super::panel::{
    FlatPanel, Stand, assembly_of_nodes, assembly_rows, bent_panels, halved, lay_flat, panel_names,
};
use super::paper::{LEAST_TAB, PaperModel};
use super::sheet::{CutPart, Layout, in_capitals};
use super::surface::PanelSurface;
use crate::math::plane::Point2;
use crate::mesh::Mesh;
use crate::scene::{BuildSettings, Fold, Names, OffsetKind, Page, Product, Tiling};
use crate::words::{LengthUnit, UNITS};
use serde::Serialize;
use std::ops::Range;

/// Numbers below this, in mm of the building or degrees, are rounding errors.
const ROUNDING: f64 = 1e-6;

/// Largest number of pages that all sheets are tiled to.
const MOST_PAGES: u64 = 5000;

/// What a limit allows: a limit of 0 is met by rounding errors, and by nothing else.
pub(super) fn allowed(limit: f64) -> f64 {
    limit.max(ROUNDING)
}

/// Whether a number is within its limit.
pub(super) fn is_within(value: f64, limit: f64) -> bool {
    value <= allowed(limit)
}

/// A panel as it is cut, in mm of the sheet, rotated so that its smallest box lies along x.
#[derive(Clone, Debug)]
pub struct CutPanel {
    /// The panel without the joint.
    pub whole: Vec<Point2>,
    /// The rotation from the plane of the panel, as cosine and sine.
    pub turn: Point2,
    /// The size of its smallest box, with the joint subtracted.
    pub size: [f64; 2],
    /// Its index in [`Build::parts`], or that of its first piece.
    pub part: usize,
    /// The number of its pieces, which are parts one after another; 1 if it is whole.
    pub pieces: usize,
}

impl CutPanel {
    /// The indices of its pieces in [`Build::parts`].
    pub fn parts(&self) -> Range<usize> {
        self.part..self.part + self.pieces
    }
}

/// A plate behind a seam between two pieces of a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Splice {
    /// The panel.
    pub panel: u32,
    /// The index of the plate in [`Build::parts`].
    pub part: usize,
    /// The indices of the pieces.
    pub pieces: [usize; 2],
    /// The axis of the panel across the seam: 0 for x, 1 for y.
    pub axis: usize,
    /// The lower left and the upper right corner of the plate, as the panel is cut, in mm.
    pub corners: [Point2; 2],
    /// The ends of the seam there.
    pub seam: [Point2; 2],
}

/// A disc on the sheets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CutDisc {
    /// The vertex of its node.
    pub vertex: u32,
    /// Its index in [`Build::parts`].
    pub part: usize,
}

/// A part that is not cut, and the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotCut {
    /// Its name.
    pub part: String,
    /// The reason, in words.
    pub why: &'static str,
    /// Whether it would be a part: a panel without area and a beam without length are none.
    pub is_part: bool,
}

/// Numbers of what is left out of parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct LeftOut {
    /// Neighbours' names without room, on parts that are on a sheet.
    pub dropped_names: usize,
    /// Parts on a sheet on which their own name, or that of one of their panels, has no room for letters
    /// of 2 mm: it is not engraved.
    pub small_names: usize,
    /// Holes without room.
    pub dropped_holes: usize,
    /// Holes at edges where panels do not meet one to one: none lies opposite.
    pub unpaired_holes: usize,
    /// Inner corners that are cut without a relief for lack of room.
    pub dropped_reliefs: usize,
}

/// A shape divided into parts.
#[derive(Clone, Debug)]
pub struct Build {
    /// The settings.
    pub settings: BuildSettings,
    /// The unit of the mesh.
    pub unit: LengthUnit,
    /// The panels as a surface.
    pub surface: PanelSurface,
    /// The name of each panel.
    pub names: Vec<String>,
    /// The number of faces of the mesh that are panels: the first ones, but for those with holes.
    pub faces: usize,
    /// The panels that are cut as two triangles. The first triangle is in the place of the panel; the others
    /// follow the faces, in this order.
    pub halves: Vec<u32>,
    /// The rows of panels in the order of assembly.
    pub rows: Vec<Vec<u32>>,
    /// The number of each node in its name, by its vertex: that of the vertex, or if fins are named in the
    /// order of assembly, its own place in it, from 1.
    pub nodes: Vec<u32>,
    /// Each panel in its plane, in the unit of the mesh; none if it has no area.
    pub flat: Vec<Option<FlatPanel>>,
    /// Each panel as it is cut; none if it is not cut.
    pub cut: Vec<Option<CutPanel>>,
    /// The plates that join the pieces of panels.
    pub splices: Vec<Splice>,
    /// The parts that are not cut.
    pub not_cut: Vec<NotCut>,
    /// The parts to cut.
    pub parts: Vec<CutPart>,
    /// What is missing on them.
    pub left_out: LeftOut,
    /// Where the parts are on the sheets.
    pub layout: Layout,
    /// Types of panels, by their outlines as cut.
    pub types: Types,
    /// The beams, if fins are made and the surface has an outside.
    pub frame: Option<Frame>,
    /// The edge of each fin among the parts, of which they are the first.
    pub fins: Vec<u32>,
    /// The node discs among the parts, in the order of the parts, of which they are the last.
    pub discs: Vec<CutDisc>,
    /// The paper model, if one is made.
    pub paper: Option<PaperModel>,
    /// The node axes of the offset and their check; none if the surface has no outside.
    pub offset: Option<(Axes, OffsetCheck)>,
    /// What is not available, or not as it seems, and why; first why there is no offset.
    pub faults: Vec<Fault>,
}

/// Lays each panel flat in its plane.
pub(super) fn all_flat(surface: &PanelSurface) -> Vec<Option<FlatPanel>> {
    (0..surface.faces.len() as u32).map(|f| lay_flat(surface, f)).collect()
}

/// The unit with this symbol; metres for an empty one, of a file that has no unit. An unknown
/// one is refused: parts would have a wrong size.
///
/// # Errors
/// If it is none of [`UNITS`].
pub fn unit_of(symbol: &str) -> Result<LengthUnit, Fault> {
    let unit = if symbol.is_empty() { Some(UNITS[0]) } else { LengthUnit::of(symbol) };
    unit.ok_or_else(|| Fault::unknown_unit(symbol))
}

impl Build {
    /// All parts of a mesh at its `positions`, which stands as `stand` says.
    ///
    /// # Errors
    /// If the mesh has no faces, or a setting is out of its range.
    pub fn new(
        mesh: &Mesh,
        settings: &BuildSettings,
        unit: LengthUnit,
        stand: &Stand,
    ) -> Result<Build, Fault> {
        (settings.check().and_then(|()| settings.check_edges(mesh)))
            .map_err(|(key, message)| Fault(format!("build.{key}: {message}")))?;
        let whole = PanelSurface::new(mesh)?;
        let mut rows = assembly_rows(&whole, stand);
        let (names, are_as_asked) = panel_names(&whole, settings.names, &rows);
        let to_building = 1000.0 * unit.metres;
        let bent = match settings.product {
            Product::Panels if settings.bend > 0.0 => {
                let least = settings.bend * settings.thickness * settings.scale / to_building;
                bent_panels(&whole, &all_flat(&whole), least)
            }
            _ => Vec::new(),
        };
        let (surface, names) = match bent.is_empty() {
            true => (whole, names),
            false => halved(mesh, &whole, (names, &mut rows), &bent)?,
        };
        let flat = all_flat(&surface);
        let nodes = match (settings.product, settings.names) {
            (Product::Fins, Names::Assembly) => assembly_of_nodes(&surface, &rows, stand),
            _ => (0..surface.positions.len() as u32).collect(),
        };
        let mut build = Build {
            settings: settings.clone(),
            surface,
            names,
            faces: mesh.faces.len(),
            halves: bent.iter().map(|own| own.panel).collect(),
            rows,
            nodes,
            flat,
            cut: Vec::new(),
            splices: Vec::new(),
            not_cut: Vec::new(),
            parts: Vec::new(),
            left_out: LeftOut::default(),
            layout: Layout::default(),
            types: Types::default(),
            frame: None,
            fins: Vec::new(),
            discs: Vec::new(),
            paper: None,
            offset: None,
            faults: Vec::new(),
            unit,
        };
        build.types = build.panel_types(build.settings.alike);
        build.make_offset(build.settings.kind);
        if build.surface.untouched > 0 {
            build.faults.push(Fault::untouched(build.surface.untouched));
        }
        if let Some(all) = build.surface.inside_out() {
            build.faults.push(Fault::inside_out(all));
        }
        if !are_as_asked {
            build.faults.push(Fault::no_rows());
        }
        build.cut(stand);
        if build.printed_page() != build.settings.page {
            build.faults.push(Fault::too_many_pages(build.pages()));
        }
        Ok(build)
    }

    /// The face of the mesh that a panel is, or a half of it; none of a panel with holes.
    pub fn face_of(&self, panel: u32) -> Option<u32> {
        match (panel as usize).checked_sub(self.faces) {
            None => Some(panel),
            Some(half) => self.halves.get(half).copied(),
        }
    }

    /// The number of each panel in the order of assembly, from 1.
    pub fn order(&self) -> Vec<u32> {
        let mut order = vec![0; self.names.len()];
        let numbers = self.rows.iter().flatten().zip(1..);
        numbers.for_each(|(&f, number)| order[f as usize] = number);
        order
    }

    /// The name of the node at a vertex.
    pub(super) fn node_name(&self, vertex: u32) -> String {
        format!("N{}", self.nodes[vertex as usize])
    }

    /// The name of the beam along the edge between two vertices, from the first to the second.
    pub(super) fn beam_name(&self, ends: [u32; 2]) -> String {
        let [a, b] = ends.map(|v| self.nodes[v as usize]);
        format!("B{a}-{b}")
    }

    /// The number of parts that are missing because they cannot be cut.
    pub(super) fn missing_parts(&self) -> usize {
        self.not_cut.iter().filter(|not| not.is_part).count()
    }

    /// The number of pages of all sheets, on pages of the size that was asked for.
    fn pages(&self) -> u64 {
        let BuildSettings { sheet, page, .. } = self.settings;
        self.layout.sheets.len() as u64 * Tiling::of(sheet, page.size()).count()
    }

    /// The page size of the PDF: that which was asked for, unless that makes too many pages.
    pub(super) fn printed_page(&self) -> Page {
        if self.pages() > MOST_PAGES { Page::Sheet } else { self.settings.page }
    }

    /// The height of tabs, tongues and flanges in mm of the sheet, which only creased paper has; 0 for
    /// none, and for lower ones than are made.
    pub(super) fn tab(&self) -> f64 {
        let BuildSettings { fold, tab, .. } = self.settings;
        if fold == Fold::Crease && tab >= LEAST_TAB { tab } else { 0.0 }
    }

    /// Millimetres of the building per unit of the mesh.
    pub fn mm_of_building(&self) -> f64 {
        1000.0 * self.unit.metres
    }

    /// Millimetres of the sheet per unit of the mesh.
    pub fn mm_of_sheet(&self) -> f64 {
        self.mm_of_sheet_at(self.settings.scale)
    }

    /// As [`Build::mm_of_sheet`], at another scale.
    pub(super) fn mm_of_sheet_at(&self, scale: f64) -> f64 {
        self.mm_of_building() / scale
    }

    /// The distance of the offset and the depth of beams, in the unit of the mesh.
    pub fn distance(&self) -> f64 {
        self.settings.distance.unwrap_or_else(|| 0.2 * self.surface.mean_edge())
    }

    /// The width of prisms, in the unit of the mesh.
    pub fn beam_width(&self) -> f64 {
        self.settings.beam_width.unwrap_or_else(|| 0.05 * self.surface.mean_edge())
    }

    /// Computes the offset of this kind; by default of the kind that meets the limits, or else has the
    /// smallest errors. If there is none, the reason becomes the first fault.
    pub(super) fn make_offset(&mut self, kind: Option<OffsetKind>) {
        let folded = self.surface.folded_over();
        let fault = match &self.surface.one_sided {
            Some(fault) => Some(fault.clone()),
            None => (!folded.is_empty())
                .then(|| Fault::folded_over(folded.len(), &self.names[folded[0] as usize])),
        };
        if let Some(fault) = fault {
            self.faults.insert(0, fault);
            self.offset = None;
            return;
        }
        // Corners do not suit a box or a mesh with holes: by default both kinds are tried.
        let kinds = match &kind {
            Some(kind) => std::slice::from_ref(kind),
            None => &[OffsetKind::Face, OffsetKind::Corner],
        };
        // Errors that count as exact are equal, or rounding would choose. In a tie the first one wins.
        let exact = self.exact_tolerance();
        let rank = |check: &OffsetCheck| {
            let error = check.warp.max(check.distance_error);
            (!self.meets_limits(check), if error <= exact { 0.0 } else { error })
        };
        self.offset = self.offsets_of(kinds).into_iter().min_by(|(_, a), (_, b)| {
            let ((misses, error), (misses_too, other)) = (rank(a), rank(b));
            misses.cmp(&misses_too).then(error.total_cmp(&other))
        });
    }

    /// Whether all numbers of an offset are within the limits of the build check.
    fn meets_limits(&self, check: &OffsetCheck) -> bool {
        let (limits, building, distance) =
            (self.settings.limits, self.mm_of_building(), self.distance());
        let safe = check.safe_distance[usize::from(distance > 0.0)];
        is_within(check.warp * building, limits.warp)
            && is_within(check.distance_error * building, limits.distance)
            && is_within(check.inner_lean_deg, limits.lean)
            && safe.is_none_or(|safe| distance.abs() < safe.abs())
    }

    /// The axes of some kinds of offset, and their checks.
    pub(super) fn offsets_of(&self, kinds: &[OffsetKind]) -> Vec<(Axes, OffsetCheck)> {
        let distance = self.distance();
        let follow = self.settings.follow;
        let axes = axes_of(&self.surface, kinds, follow, distance, self.exact_tolerance());
        let checked = |axes: Axes| {
            let found = check(&self.surface, &axes.axes, axes.kind, distance);
            (axes, found)
        };
        axes.into_iter().map(checked).collect()
    }

    /// The warp and distance error of an exact offset, in the unit of the mesh.
    pub(super) fn exact_tolerance(&self) -> f64 {
        let limits = self.settings.limits;
        allowed(0.1 * limits.warp.min(limits.distance)) / self.mm_of_building()
    }

    /// The sheets as line drawings.
    pub fn drawings(&self) -> Vec<Drawing> {
        (0..self.layout.sheets.len()).map(|k| self.drawing(k)).collect()
    }

    /// A sheet as a line drawing; panics if there are fewer.
    pub fn drawing(&self, k: usize) -> Drawing {
        let BuildSettings { sheet, margin, outlines_only, .. } = self.settings;
        let (number, count) = (k + 1, self.layout.sheets.len());
        let digits = count.to_string().len().max(2);
        let name = format!("sheet-{number:0digits$}");
        let words = [self.title(number, count), self.legend()];
        let own = &self.layout.sheets[k];
        Drawing::new(name, words, sheet, margin, own, &self.parts, outlines_only)
    }

    /// What the lines on a sheet mean: which side is seen, or how the letters of a part lie in the
    /// model, and where its arrow points.
    pub(super) fn legend(&self) -> String {
        let side = match self.settings.product {
            _ if self.surface.one_sided.is_some() => "",
            // Above and below as the letters stand, which is outwards.
            Product::Fins if self.distance() > 0.0 => {
                "FIN NAMES READ FROM FIRST TO SECOND NODE, OUTSIDE UP, MODEL EDGE AT THE BOTTOM"
            }
            Product::Fins => {
                "FIN NAMES READ FROM FIRST TO SECOND NODE, OUTSIDE UP, MODEL EDGE AT THE TOP"
            }
            _ if self.settings.print_inside => "SEEN FROM INSIDE, MIRRORED",
            Product::Panels | Product::Paper => "SEEN FROM OUTSIDE",
        };
        let has_tongues = self.paper.as_ref().is_some_and(PaperModel::has_tongues);
        let arrow = match self.settings.product {
            Product::Panels => "ARROW: UP, IF LEVEL TO THE TOP OF KEY 1",
            Product::Fins if self.discs.is_empty() => "ARROW: TO THE SIDE AT THE EDGE OF THE MODEL",
            Product::Fins => "ARROW OF A FIN: TO THE SIDE AT THE EDGE OF THE MODEL",
            Product::Paper => match (self.settings.fold, self.settings.print_inside) {
                (Fold::Crease, _) if has_tongues => "TONGUES GO INTO THE SLOTS OF THEIR NAME",
                (Fold::Crease, _) => "",
                (Fold::Score, _) => {
                    "CUT HALF THROUGH: SOLID LINES FROM THIS SIDE, DASHED FROM BEHIND"
                }
                (Fold::VCut, false) => {
                    "CUT FROM BEHIND: GROOVES AT SOLID LINES, SLITS AT DASHED, MITRES AT EDGES"
                }
                (Fold::VCut, true) => {
                    "CUT FROM THIS SIDE: GROOVES AT DASHED LINES, SLITS AT SOLID, MITRES AT EDGES"
                }
                (Fold::Separate, _) => "EDGES HELD BY TAPE",
            },
        };
        let discs = "DISCS SEEN FROM OUTSIDE, ARROW AT THE FIRST SLOT";
        let discs = if self.discs.is_empty() { "" } else { discs };
        let is_bevelled = self.parts.iter().any(|part| part.bevels.iter().any(Option::is_some));
        let bevels = "AT EDGES: BEVEL IN DEGREES, + CUTS THE INSIDE BACK";
        let bevels = if is_bevelled { bevels } else { "" };
        let splices = match (self.splices.is_empty(), self.is_turned_over()) {
            (true, _) => "",
            (false, false) => "FRAME AT A SEAM: PLATE BEHIND IT",
            (false, true) => "FRAME AT A SEAM: PLATE ON IT",
        };
        let words =
            [side, arrow, bevels, discs, splices].into_iter().filter(|words| !words.is_empty());
        words.collect::<Vec<_>>().join(", ")
    }

    /// The title of a sheet, with the units of the model and of the sheet.
    fn title(&self, number: usize, count: usize) -> String {
        let scale = places(self.settings.scale, 6);
        let [width, height] = self.settings.sheet.map(|size| places(size, 3));
        let thickness = match self.settings.thickness > 0.0 {
            true => format!("{} MM ", places(self.settings.thickness, 3)),
            false => String::new(),
        };
        let material = thickness + &in_capitals(&self.settings.material);
        let material = material.trim();
        let material = if material.is_empty() { String::new() } else { format!(", {material}") };
        format!(
            "SHEET {number}/{count}, SCALE 1:{scale}, MODEL IN {}, SHEET {width} X {height} MM{material}",
            self.unit.symbol.to_ascii_uppercase()
        )
    }
}
