//! All numbers of a build. Lengths are in mm of the building, except on the sheet.

use super::alike::Types;
use super::beam::{edge_types, node_types};
use super::build::{Build, LeftOut};
use super::card::BuildCard;
use super::file::shared_length;
use super::offset::Choice;
use super::panel::{perimeter, smallest_box};
use super::paper::{FoldKind, Joint, JointKind, PaperModel};
use super::sheet::{CutPart, Hole, NamePlace, Place, Sheet};
use super::surface::{Edge, distinct};
use crate::scene::{BuildSettings, OffsetKind, Product};
use serde::Serialize;
use std::collections::BTreeSet;

/// The beams and the nodes between them.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct FrameReport {
    /// Nodes with beams.
    pub nodes: usize,
    /// Types of nodes, whose angles differ by at most `alike_deg`.
    pub node_types: usize,
    /// Tolerance of `node_types`.
    pub alike_deg: f64,
    /// Pairs of a tolerance in degrees and the number of types of nodes.
    pub node_types_curve: Vec<[f64; 2]>,
    /// Largest length cut off an end of a fin, on the sheet.
    pub cut_back_mm: f64,
    /// Largest change of a distance between corners when fins are laid flat.
    pub flattening_error_mm: f64,
    /// Largest step between the upper faces of neighbouring prisms.
    pub node_step_mm: f64,
    /// The vertex of `node_step_mm`.
    pub node_step_vertex: u32,
    /// Node discs that are asked for: one of each node where fins end.
    pub discs: usize,
    /// Node discs that are on a sheet.
    pub placed_discs: usize,
    /// Beams whose mitres leave nothing of a prism.
    pub without_prism: usize,
}

/// The paper model.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct PaperReport {
    /// Edges and creases folded to a ridge, seen from outside; those that stay flat do not count.
    pub ridges: usize,
    /// Edges and creases folded to a valley.
    pub valleys: usize,
    /// Edges that the settings have cut.
    pub seams: usize,
    /// Edges with a tab for glue.
    pub tabs: usize,
    /// Edges with a tongue and its slot.
    pub tongues: usize,
    /// Edges that are cut and have no tab, by the names of their panels: without room, or without
    /// one panel on either side.
    pub without_tab: Vec<String>,
    /// Edges that have no tab or fold since there is not one panel on either side, by the names of
    /// their panels.
    pub unpaired: Vec<String>,
    /// Panels that are not flat, and creased, or cut apart, along their diagonals.
    pub creased: usize,
    /// The names of panels of which the folds leave no inner face: the card is too thick.
    pub too_thick: Vec<String>,
    /// Where panels are cut back further than their fold asks: in line with a side whose fold asks for
    /// more. Each by its name and what it meets.
    pub gaps: Vec<String>,
}

/// The report of a build.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BuildReport {
    /// The product.
    pub product: Product,
    /// Parts to be cut: panels, or their pieces and plates; fins and node discs; or pieces of paper. The
    /// panels of which no piece is made, those without area, and beams without length are in `not_cut` only.
    pub parts: usize,
    /// Panels.
    pub panels: usize,
    /// Edges.
    pub edges: usize,
    /// Vertices of panels.
    pub nodes: usize,
    /// Connected components of the surface.
    pub components: usize,
    /// Panels that were reversed to agree with their neighbours.
    pub turned: usize,
    /// The unit of the mesh.
    pub unit: String,
    /// The denominator of the scale.
    pub scale: f64,
    /// Sheets in use.
    pub sheets: usize,
    /// Width and height of a sheet.
    pub sheet_mm: [f64; 2],
    /// Parts on sheets.
    pub placed: usize,
    /// The fraction of the sheets' area that parts cover.
    pub used: f64,
    /// The names of parts that are larger than a sheet.
    pub too_large: Vec<String>,
    /// Width and height of a sheet with room for each of them within the same margin.
    pub larger_sheet_mm: Option<[f64; 2]>,
    /// The name of the part whose smallest box is narrowest; empty if there are no parts.
    pub smallest_part: String,
    /// Length and width of that box, on the sheet.
    pub smallest_part_mm: Option<[f64; 2]>,
    /// The names of parts that are narrower than their limit.
    pub narrow: Vec<String>,
    /// Parts that cannot be cut, each with the reason.
    pub not_cut: Vec<String>,
    /// Holes of panels on sheets, as the model has them.
    pub openings: usize,
    /// Panels that are cut into pieces.
    pub spliced: usize,
    /// The plates that join their pieces.
    pub plates: usize,
    /// Panels that are cut as two triangles, since they bend more than their material takes.
    pub halved: usize,
    /// Strips over the joints between panels.
    pub strips: usize,
    /// Their length on the sheet, although they are cut of another material.
    pub strip_length_mm: f64,
    /// Joints without a strip for lack of room between those at their ends.
    pub dropped_strips: usize,
    /// Area of all parts on sheets, without their holes.
    pub cut_area_mm2: f64,
    /// Length of their outlines and holes.
    pub cut_length_mm: f64,
    /// The gap between panels on the sheet.
    pub joint_mm: f64,
    /// The least joint on the sheet that keeps panels of this thickness from colliding, if they are
    /// laid outside and inside of the surface; null if none of 0.1 mm is needed, or it is not known.
    pub least_joint_mm: [Option<f64>; 2],
    /// The panels between which the least joint of either side is needed, such as `P3 and P7`; empty if
    /// none is.
    pub least_joint_at: [String; 2],
    /// Why the least joint of either side is not known; empty if it is.
    pub no_least_joint: [&'static str; 2],
    /// What is left out of parts, among the numbers of the report.
    #[serde(flatten)]
    pub left_out: LeftOut,
    /// The names of parts on sheets that have no room for their name, on the part or beside it.
    pub unnamed: Vec<String>,
    /// Round holes in parts on sheets.
    pub holes: usize,
    /// Types of panels.
    pub types: usize,
    /// Pairs of a tolerance in mm of the building and the number of types of panels.
    pub types_curve: Vec<[f64; 2]>,
    /// Types of edges: lengths within the same tolerance.
    pub edge_types: usize,
    /// Pairs of a tolerance in mm of the building and the number of types of edges.
    pub edge_types_curve: Vec<[f64; 2]>,
    /// Largest change of a distance between corners when panels are laid flat.
    pub flattening_error_mm: f64,
    /// Smallest and largest fold, positive for ridges; null without inner edges.
    pub fold_deg: Option<[f64; 2]>,
    /// Beams and nodes; null if they are not made.
    pub frame: Option<FrameReport>,
    /// The paper model; null for other products.
    pub paper: Option<PaperReport>,
    /// The part that depends on the offset, among the numbers of the report.
    #[serde(flatten)]
    pub card: BuildCard,
}

/// The accuracy of cutting, in mm: of joints and their differences, less is nothing.
pub(super) const JOINT_STEP: f64 = 0.1;

/// The tolerances at which types are counted, in mm of the building.
const ALIKE_MM: [f64; 6] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0];
/// The tolerances of angles, in degrees.
const ALIKE_DEG: [f64; 6] = [0.05, 0.1, 0.2, 0.5, 1.0, 2.0];

/// The number of types at each tolerance; empty for more than `MOST` items, where this would
/// dominate the time.
fn curve(tolerances: &[f64], items: usize, types: impl Fn(f64) -> Types) -> Vec<[f64; 2]> {
    const MOST: usize = 5000;
    let tolerances = tolerances.iter().take(if items > MOST { 0 } else { tolerances.len() });
    tolerances.map(|&at| [at, types(at).leaders.len() as f64]).collect()
}

impl Build {
    /// All numbers.
    pub fn report(&self) -> BuildReport {
        let building = self.mm_of_building();
        let mut report = self.report_without_curves();
        report.types_curve =
            curve(&ALIKE_MM, self.flat.len(), |tolerance| self.panel_types(tolerance));
        report.edge_types_curve = curve(&ALIKE_MM, self.surface.edges.len(), |tolerance| {
            edge_types(&self.surface, tolerance / building)
        });
        if let Some((own, frame)) = report.frame.as_mut().zip(self.frame.as_ref()) {
            own.node_types_curve = curve(&ALIKE_DEG, own.nodes, |tolerance| {
                node_types(&frame.nodes, tolerance, self.settings.mirror)
            });
        }
        report
    }

    /// The report without the numbers of types at other tolerances, which take most of its time.
    pub(super) fn report_without_curves(&self) -> BuildReport {
        let building = self.mm_of_building();
        let on_sheets: Vec<usize> = self
            .layout
            .sheets
            .iter()
            .flat_map(|sheet| sheet.places.iter().map(|place| place.part))
            .collect();
        let sum = |of: fn(&CutPart) -> f64| {
            // Not `sum`, which is -0 of nothing.
            on_sheets.iter().map(|&part| of(&self.parts[part])).fold(0.0, |a, b| a + b)
        };
        let is_nameless =
            |part: &&CutPart| part.named == NamePlace::Nowhere && !self.settings.outlines_only;
        let cut_area_mm2 = sum(CutPart::area);
        let holes = || on_sheets.iter().flat_map(|&part| &self.parts[part].holes);
        let around_holes = holes().map(Hole::perimeter).fold(0.0, |a, b| a + b);
        let mut strips = self.strips();
        let all_strips = strips.len();
        strips.retain(|own| own.length > 0.0);
        let [width, height] = self.settings.sheet;
        let sheets = self.layout.sheets.len();
        let folds = self.surface.edges.iter();
        let folds = folds.filter_map(|edge| Some((edge, self.surface.fold(edge)?)));
        let folds: Vec<(&Edge, f64)> = folds.collect();
        let fold_deg = (!folds.is_empty()).then(|| {
            let all = || folds.iter().map(|(_, fold)| *fold);
            let low = all().fold(f64::INFINITY, f64::min);
            [low, all().fold(f64::NEG_INFINITY, f64::max)].map(f64::to_degrees)
        });
        let least = [1.0, -1.0].map(|side| self.least_joint(&folds, side));
        let between = |edge: &Edge| {
            let both = distinct(edge.panels.into_iter().flatten()).into_iter();
            both.map(|f| &*self.names[f as usize]).collect::<Vec<_>>().join(" and ")
        };
        let errors = self.flat.iter().flatten().map(|flat| flat.flattening_error);
        let boxes: Vec<(&CutPart, [f64; 2])> =
            self.parts.iter().map(|part| (part, smallest_box(&part.outline).1)).collect();
        let smallest = boxes.iter().min_by(|(_, a), (_, b)| a[1].total_cmp(&b[1]));
        let is_narrow =
            |(_, [_, width]): &&(&CutPart, [f64; 2])| *width < self.settings.limits.part;
        let nodes = distinct(self.surface.faces.indices().iter().copied());
        BuildReport {
            product: self.settings.product,
            parts: self.parts.len()
                + match self.settings.product {
                    Product::Paper => 0,
                    Product::Panels | Product::Fins => self.missing_parts(),
                },
            panels: self.names.len() - self.halves.len(),
            edges: self.surface.real_edges().count(),
            nodes: nodes.len(),
            components: self.surface.parts,
            turned: self.surface.turned,
            unit: self.unit.symbol.to_owned(),
            scale: self.settings.scale,
            sheets,
            sheet_mm: self.settings.sheet,
            placed: on_sheets.len(),
            used: if sheets > 0 { cut_area_mm2 / (sheets as f64 * width * height) } else { 0.0 },
            too_large: self
                .layout
                .too_large
                .iter()
                .map(|&part| self.parts[part].name.clone())
                .collect(),
            smallest_part: smallest.map_or_else(String::new, |(part, _)| part.name.clone()),
            smallest_part_mm: smallest.map(|(_, size)| *size),
            narrow: boxes.iter().filter(is_narrow).map(|(part, _)| part.name.clone()).collect(),
            larger_sheet_mm: self.larger_sheet(),
            not_cut: self.not_cut.iter().map(|not| format!("{}: {}", not.part, not.why)).collect(),
            openings: holes().filter(|hole| !hole.neighbours.is_empty()).count(),
            spliced: self.cut.iter().flatten().filter(|cut| cut.pieces > 1).count(),
            plates: self.splices.len(),
            halved: self.halves.len(),
            strips: strips.len(),
            strip_length_mm: strips.iter().map(|own| own.length).fold(0.0, |a, b| a + b),
            dropped_strips: all_strips - strips.len(),
            cut_area_mm2,
            cut_length_mm: sum(|part| perimeter(&part.outline)) - self.shared() + around_holes,
            joint_mm: self.settings.joint * self.mm_of_sheet(),
            least_joint_mm: least.map(|least| least.ok().flatten().map(|(least, _)| least)),
            least_joint_at: least
                .map(|least| least.ok().flatten().map_or_else(String::new, |(_, at)| between(at))),
            no_least_joint: least.map(|least| least.err().unwrap_or("")),
            left_out: self.left_out,
            unnamed: (self.layout.places(self.parts.len()).iter().zip(&self.parts))
                .filter(|(place, part)| place.is_some() && is_nameless(part))
                .map(|(_, part)| part.name.clone())
                .collect(),
            holes: holes().filter(|hole| hole.slot.is_none()).count(),
            types: self.types.leaders.len(),
            types_curve: Vec::new(),
            edge_types: edge_types(&self.surface, self.settings.alike / building).leaders.len(),
            edge_types_curve: Vec::new(),
            flattening_error_mm: errors.fold(0.0, f64::max) * building,
            fold_deg,
            frame: self.frame_report(),
            paper: self.paper_report(),
            card: self.card(),
        }
    }

    /// The length of what outlines share with others or themselves, which is cut once.
    fn shared(&self) -> f64 {
        let outline = |place: &Place| {
            self.parts[place.part].outline.iter().map(|&point| place.to_sheet(point)).collect()
        };
        let of_sheet =
            |sheet: &Sheet| shared_length(&sheet.places.iter().map(outline).collect::<Vec<_>>());
        self.layout.sheets.iter().map(of_sheet).fold(0.0, |a, b| a + b)
    }

    /// Width and height, in whole mm, of a sheet for the parts that are too large; none if all fit, or
    /// no sheet may be that large.
    fn larger_sheet(&self) -> Option<[f64; 2]> {
        let box_of = |&part: &usize| smallest_box(&self.parts[part].outline).1;
        let boxes = self.layout.too_large.iter().map(box_of);
        let size = boxes.reduce(|[a, b], [c, d]| [a.max(c), b.max(d)])?;
        let sheet = size.map(|side| (side + 2.0 * self.settings.margin - 1e-6).ceil());
        let settings = BuildSettings { sheet, ..self.settings.clone() };
        settings.check().is_ok().then_some(sheet)
    }

    /// The errors of every kind of offset; empty if offsets are not available.
    pub fn choices(&self) -> Vec<Choice> {
        if self.offset.is_none() {
            return Vec::new();
        }
        let building = self.mm_of_building();
        let all = self.offsets_of(&OffsetKind::ALL).into_iter();
        let choice = all.map(|(axes, check)| Choice {
            kind: axes.kind,
            exact: axes.inexact.is_empty(),
            warp_mm: check.warp * building,
            distance_error_mm: check.distance_error * building,
        });
        choice.collect()
    }

    /// Panels of thickness `T` on one side collide at an edge of fold `theta` towards that side
    /// unless the joint is at least `2 T sin(|theta|/2) / cos(theta/2)`: the largest of these, and its edge.
    /// None if that is nothing at all edges: folds between coplanar panels are rounding errors of either
    /// sign.
    ///
    /// # Errors
    /// Why it is not known.
    fn least_joint<'a>(
        &self,
        folds: &[(&'a Edge, f64)],
        side: f64,
    ) -> Result<Option<(f64, &'a Edge)>, &'static str> {
        if self.surface.panels.iter().any(|panels| panels.len() > 2) {
            return Err("more than two panels meet at an edge");
        }
        if self.surface.one_sided.is_some() {
            return Err("the surface has one side only");
        }
        let towards = folds.iter().map(|(edge, fold)| (-fold * side, *edge));
        let Some((steepest, edge)) =
            towards.filter(|(fold, _)| *fold > 0.0).max_by(|(a, _), (b, _)| a.total_cmp(b))
        else {
            return Ok(None);
        };
        let half_turns = steepest / std::f64::consts::TAU * 0.5;
        let (sine, cosine) = (crate::math::sine(half_turns), crate::math::cosine(half_turns));
        if cosine <= 1e-6 {
            return Err("panels lie on each other");
        }
        let least = 2.0 * self.settings.thickness * sine / cosine;
        Ok((least >= JOINT_STEP).then_some((least, edge)))
    }

    fn frame_report(&self) -> Option<FrameReport> {
        let frame = self.frame.as_ref()?;
        let fins = || frame.fins.iter().flatten();
        let places = self.layout.places(self.parts.len());
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let (step, node_step_vertex) = frame.largest_step().unwrap_or_default();
        Some(FrameReport {
            nodes: frame.nodes.iter().flatten().count(),
            node_types: frame.types.leaders.len(),
            alike_deg: self.settings.alike_deg,
            node_types_curve: Vec::new(),
            cut_back_mm: largest(&mut fins().flat_map(|fin| fin.cut_back)) * self.mm_of_sheet(),
            flattening_error_mm: largest(&mut fins().map(|fin| fin.flattening_error))
                * self.mm_of_building(),
            node_step_mm: step * self.mm_of_building(),
            node_step_vertex,
            discs: frame.discs.iter().flatten().count(),
            placed_discs: self.discs.iter().filter(|disc| places[disc.part].is_some()).count(),
            without_prism: frame.without_prism,
        })
    }

    fn paper_report(&self) -> Option<PaperReport> {
        let PaperModel { net, joint_kinds, uneven, .. } = self.paper.as_ref()?;
        let folds = |kind: FoldKind| {
            let joints = net.joints.iter().zip(&net.folded);
            joints.filter(|(joint, folded)| **folded && joint.kind() == kind).count()
        };
        let creases = net.joints.iter().filter(|joint| joint.edge.is_none());
        let creased = distinct(creases.map(|joint| net.facets[joint.sides[0].0 as usize].panel));
        let lacks_tab = |kind: &JointKind| self.tab() > 0.0 && matches!(kind, JointKind::Bare);
        let without_tab = net.joints.iter().zip(joint_kinds).filter(|(_, kind)| lacks_tab(kind));
        let name = |f: u32| &*self.names[net.facets[f as usize].panel as usize];
        let panels = |joint: &Joint| joint.sides.map(|(f, _)| name(f)).join("/");
        let gap = |&side: &(u32, u32)| {
            let met = net.across(side).map_or("an edge without a joint", |(_, (f, _))| name(f));
            format!("{} at {met}", name(side.0))
        };
        let mut gaps: Vec<String> = uneven.gaps.iter().map(gap).collect();
        gaps.dedup();
        // Around a panel without area several edges are between the same two.
        let mut known = BTreeSet::new();
        let unpaired = self.surface.unpaired().filter(|(_, panels)| known.insert(panels.clone()));
        let unpaired: Vec<String> = unpaired
            .map(|(_, panels)| {
                panels.iter().map(|&f| &*self.names[f as usize]).collect::<Vec<_>>().join("/")
            })
            .collect();
        let beside = unpaired.iter().filter(|_| self.tab() > 0.0).cloned();
        Some(PaperReport {
            ridges: folds(FoldKind::Ridge),
            valleys: folds(FoldKind::Valley),
            seams: self.settings.seams.len(),
            tabs: joint_kinds.iter().filter(|kind| matches!(kind, JointKind::Tab(_))).count(),
            tongues: joint_kinds.iter().filter(|kind| matches!(kind, JointKind::Tongue(_))).count(),
            without_tab: without_tab.map(|(joint, _)| panels(joint)).chain(beside).collect(),
            unpaired,
            creased: creased.len(),
            too_thick: distinct(uneven.too_thick.iter().map(|&f| net.facets[f as usize].panel))
                .into_iter()
                .map(|panel| self.names[panel as usize].clone())
                .collect(),
            gaps,
        })
    }
}
