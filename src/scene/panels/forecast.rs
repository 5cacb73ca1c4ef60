//! Forecast, before solving, of how far a mesh will move for panels of one shape, and why.

use super::request::{MeshSuggestion, panel_offers};
use crate::constraint::{KINDS, Kind};
use crate::mesh::{
    Curvature, CurvatureLines, MESH_OPERATIONS, Mesh, Ragged, Task, Topology, face_curvatures,
};
use crate::solve::{Constraints, least_move};
use crate::words;
use serde::Serialize;

/// Least estimated move, as a fraction of the mean edge, of [`HowFar::Lot`].
const A_LOT: f64 = 0.2;
/// Least move of [`HowFar::Little`], as the same fraction.
const A_LITTLE: f64 = 0.03;
/// Least move of [`HowFar::Hardly`], as the same fraction.
const NOTHING: f64 = 1e-6;
/// Least angle in degrees between edges and lines of curvature that is reported as the cause.
const OFF: f64 = 10.0;
/// Least such angle at which diagonal quads are nearer to them than the edges.
const DIAGONAL: f64 = 22.5;
/// Greatest move of diagonal quads, as a fraction of the move of the mesh, at which they are named.
const DIAGONAL_MOVE: f64 = 0.5;
/// Diagonal quads are tried on meshes of at most this many faces: the forecast takes three times as
/// long.
const MOST_DIAGONAL_FACES: usize = 15_000;
/// Faces with more corners are left out: the time grows with the cube of their number.
const MOST_CORNERS: usize = 64;
/// A face counts as on a saddle if the product of the principal curvatures, averaged over its
/// corners, is below this fraction of the sum of their squares.
const SADDLE: f64 = -0.02;
/// Saddles are reported if more than this fraction of the faces is on them.
const SADDLE_SHARE: f64 = 0.05;

/// Classes of the mean move of the vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum HowFar {
    /// All panels have the shape already.
    Nothing,
    /// Less than 0.03 of the mean edge.
    Hardly,
    /// Less than a fifth of the mean edge.
    Little,
    /// A fifth of the mean edge or more.
    Lot,
}

/// The forecast for panels of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ForecastOfKind {
    /// The id of the kind.
    pub kind: &'static str,
    /// Adjective for panels of this kind.
    #[serde(skip)]
    adjective: &'static str,
    /// Estimated mean move of the vertices, as a fraction of the mean edge, see
    /// [`least_move`]. Up to a third of an edge it is within a third of the move for an exact
    /// shape; beyond that it tends to be too large (`tests/scene/forecast.rs`).
    pub least_move: f64,
    /// Class of this move.
    pub how_far: HowFar,
}

/// The forecasts for all kinds offered for the panels of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Forecast {
    /// In the order of [`KINDS`].
    pub kinds: Vec<ForecastOfKind>,
    /// The mean edge, in the unit of the mesh.
    #[serde(skip)]
    edge: f64,
    /// Mean angle between the edges and the lines of curvature, in degrees. `None` if the surface
    /// has no lines of curvature, or if the mesh is not quad-dominant: the edges of other faces
    /// need not follow them.
    #[serde(skip)]
    pub off_curvature_lines: Option<f64>,
    /// The forecast for the mesh of diagonal quads, if it would move at most half as far because
    /// they follow the lines of curvature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diagonal: Option<Vec<ForecastOfKind>>,
    /// Among the faces with more than four corners and known curvature, the number on saddles and
    /// the total; `None` unless most faces have more than four corners.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub saddles: Option<[usize; 2]>,
}

impl Forecast {
    /// Makes the forecast for `mesh`; `None` if no kind is offered for its panels.
    pub fn of(mesh: &Mesh, topology: &Topology) -> Option<Forecast> {
        let kinds = kinds(mesh, topology);
        if kinds.is_empty() {
            return None;
        }
        let off_curvature_lines = topology
            .is_quad_dominant()
            .then(|| CurvatureLines::new(&mesh.positions, &mesh.faces, topology).mean)
            .flatten();
        let is_far = kinds.iter().any(|kind| kind.how_far == HowFar::Lot);
        let is_diagonal = is_far && off_curvature_lines.is_some_and(|angle| angle >= DIAGONAL);
        Some(Forecast {
            diagonal: is_diagonal.then(|| diagonal(mesh, topology, &kinds)).flatten(),
            kinds,
            edge: topology.mean_edge(&mesh.positions),
            off_curvature_lines,
            saddles: has_large_faces(&mesh.faces).then(|| saddles(mesh, topology)),
        })
    }

    /// Returns the change of the mesh that would reduce the move, if one is known.
    pub fn suggestion(&self) -> Option<MeshSuggestion> {
        let kinds = self.diagonal.as_ref()?;
        let is_near = kinds.iter().any(|kind| kind.how_far != HowFar::Lot);
        let words = match is_near {
            true => {
                format!("Diagonal quads (in Edit mesh) follow them: the mesh will then {}.", moves(kinds, None))
            }
            false => {
                "Diagonal quads (in Edit mesh) are nearer to them: the mesh will then move half as far or less."
                    .to_owned()
            }
        };
        MeshSuggestion::new("diagonal", words)
    }

    /// Returns the id of the kind to recommend: the strongest one for which the mesh does not move a
    /// lot, or the one for which it moves least.
    pub fn recommended(&self) -> &'static str {
        let mut strongest_first = self.kinds.iter().rev();
        let near = strongest_first.find(|kind| kind.how_far != HowFar::Lot);
        let least = || self.kinds.iter().min_by(|a, b| a.least_move.total_cmp(&b.least_move));
        near.or_else(least).map_or("", |kind| kind.kind)
    }

    /// Whether panels along the lines of curvature are the better choice: the edges are far off these
    /// lines, the mesh would move a lot, and no simple change of it helps as much.
    pub fn recommends_new_panels(&self) -> bool {
        let moves_a_lot =
            |kinds: &[ForecastOfKind]| kinds.iter().any(|it| it.how_far == HowFar::Lot);
        let is_off = self.off_curvature_lines.is_some_and(|angle| angle >= OFF);
        is_off && moves_a_lot(&self.kinds) && self.diagonal.as_deref().is_none_or(moves_a_lot)
    }

    /// How far the mesh will move, as a part of a sentence: "move a little for flat or circular panels
    /// (about 20 mm on average)". `units` is as in [`Forecast::words`].
    pub fn moves(&self, units: &str) -> String {
        let far = |kind: &ForecastOfKind| words::rough_length(kind.least_move * self.edge, units);
        moves(&self.kinds, Some(&far))
    }

    /// Describes the forecast in a few sentences: the move for each kind, its cause, and a suggestion.
    /// `units` is the symbol of the unit of the mesh, empty if not known.
    pub fn words(&self, units: &str) -> String {
        let mut words = format!("This mesh will {}", self.moves(units));
        let is_far = self.kinds.iter().any(|kind| kind.how_far == HowFar::Lot);
        words += &match self.off_curvature_lines.filter(|&angle| angle >= OFF) {
            Some(angle) if is_far => {
                let suggestion = self.suggestion().map_or_else(
                    || {
                        "New panels along the curvature, or a larger tolerance, would reduce this."
                            .to_owned()
                    },
                    |suggestion| suggestion.words,
                );
                format!(
                    ": its edges are {} off the lines of curvature on average. {suggestion}",
                    words::rough_degrees(angle)
                )
            }
            None if is_far => ". A larger tolerance would reduce this.".to_owned(),
            _ => ".".to_owned(),
        };
        let some = |&[on_saddles, all]: &[usize; 2]| on_saddles as f64 > SADDLE_SHARE * all as f64;
        if let Some([on_saddles, all]) = self.saddles.filter(some) {
            let are = words::is_or_are(on_saddles);
            let [some, all] = [on_saddles, all].map(words::group_digits);
            words += &format!(
                " {some} of {all} faces with more than four corners {are} where the surface is a saddle: flat panels \
                 cannot be convex there."
            );
        }
        words
    }
}

impl HowFar {
    const FARTHEST_FIRST: [HowFar; 4] =
        [HowFar::Lot, HowFar::Little, HowFar::Hardly, HowFar::Nothing];

    fn words(self) -> &'static str {
        match self {
            HowFar::Nothing => "not at all",
            HowFar::Hardly => "very little",
            HowFar::Little => "a little",
            HowFar::Lot => "a lot",
        }
    }

    fn words_with_verb(self) -> &'static str {
        match self {
            HowFar::Nothing => "not move at all",
            HowFar::Hardly => "move very little",
            HowFar::Little => "move a little",
            HowFar::Lot => "move a lot",
        }
    }
}

impl ForecastOfKind {
    /// Makes the forecast of the kind `id` on all suitable faces; `edge` is the mean edge.
    fn of(id: &str, mesh: &Mesh, edge: f64) -> Option<ForecastOfKind> {
        let info = KINDS.iter().find(|info| info.id == id)?;
        let kind = Kind::new(id, serde_json::json!({})).ok()?;
        let fits = |face: &&[u32]| info.arity.fits(face.len()) && face.len() <= MOST_CORNERS;
        let fitting = mesh.faces.iter().filter(fits);
        let members: Ragged = fitting.collect();
        if members.is_empty() {
            return None;
        }
        let row = Constraints { kind, weight: 1.0, members };
        let moved = least_move(mesh, &[row]).mean;
        let least_move = if edge > 0.0 { moved / edge } else { 0.0 };
        let how_far = match least_move {
            ..NOTHING => HowFar::Nothing,
            ..A_LITTLE => HowFar::Hardly,
            ..A_LOT => HowFar::Little,
            _ => HowFar::Lot,
        };
        Some(ForecastOfKind { kind: info.id, adjective: info.panels?, least_move, how_far })
    }
}

/// Makes the forecasts of all kinds offered for the panels of `mesh`.
fn kinds(mesh: &Mesh, topology: &Topology) -> Vec<ForecastOfKind> {
    let edge = topology.mean_edge(&mesh.positions);
    let offers = panel_offers(mesh).into_iter().filter(|offer| offer.reason.is_none());
    offers.filter_map(|offer| ForecastOfKind::of(offer.kind, mesh, edge)).collect()
}

/// Returns [`Forecast::diagonal`] of a mesh with the forecasts `own`.
fn diagonal(
    mesh: &Mesh,
    topology: &Topology,
    own: &[ForecastOfKind],
) -> Option<Vec<ForecastOfKind>> {
    if mesh.faces.len() > MOST_DIAGONAL_FACES {
        return None;
    }
    let operation = MESH_OPERATIONS.iter().find(|operation| operation.id == "diagonal")?;
    let up = [0.0, 0.0, 1.0];
    let rest = &mesh.positions;
    let task = Task { mesh, rest, topology, up, sizes: &[], vertices: &[], faces: &[] };
    let turned = operation.apply(&task).ok()?.mesh;
    let turned_topology = Topology::new(&turned);
    let edge = topology.mean_edge(&mesh.positions);
    let shorter = turned_topology.mean_edge(&turned.positions) / edge;
    let kinds = kinds(&turned, &turned_topology);
    let is_nearer = |(own, turned): (&ForecastOfKind, &ForecastOfKind)| {
        shorter * turned.least_move <= DIAGONAL_MOVE * own.least_move
    };
    (kinds.len() == own.len() && own.iter().zip(&kinds).all(is_nearer)).then_some(kinds)
}

/// Describes the moves for these kinds, with their mean lengths if `far` gives them: "move a lot for
/// circular panels (about 0.3 m on average) and a little for flat ones (about 20 mm on average)".
fn moves(kinds: &[ForecastOfKind], far: Option<&dyn Fn(&ForecastOfKind) -> String>) -> String {
    let mut words = String::new();
    for how_far in HowFar::FARTHEST_FIRST {
        let kinds: Vec<_> = kinds.iter().filter(|kind| kind.how_far == how_far).collect();
        let adjectives: Vec<&str> = kinds.iter().map(|kind| kind.adjective).collect();
        if adjectives.is_empty() {
            continue;
        }
        let (joint, words_of, panels) = match words.is_empty() {
            true => ("", how_far.words_with_verb(), "panels"),
            false => (" and ", how_far.words(), "ones"),
        };
        words += &[joint, words_of, " for ", &adjectives.join(" or "), " ", panels].concat();
        if let Some(far) = far.filter(|_| how_far != HowFar::Nothing) {
            let mut lengths: Vec<String> = kinds.iter().map(|kind| far(kind)).collect();
            lengths.dedup();
            words += &format!(" (about {} on average)", lengths.join(" or "));
        }
    }
    words
}

fn has_large_faces(faces: &Ragged) -> bool {
    2 * faces.iter().filter(|face| face.len() > 4).count() > faces.len()
}

/// Returns the two counts of [`Forecast::saddles`].
fn saddles(mesh: &Mesh, topology: &Topology) -> [usize; 2] {
    let (faces, at) = (&mesh.faces, &mesh.positions);
    let product = face_curvatures(at, faces, topology, Curvature::gauss);
    let squares = face_curvatures(at, faces, topology, |one| {
        one.principal.iter().map(|value| value * value).sum()
    });
    let known = faces.iter().zip(product.into_iter().zip(squares));
    let known = known.filter(|(face, (product, _))| face.len() > 4 && !product.is_nan());
    known.fold([0, 0], |[on_saddles, all], (_, (product, squares))| {
        [on_saddles + usize::from(product < SADDLE * squares), all + 1]
    })
}
