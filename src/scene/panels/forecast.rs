//! How far a mesh will move for panels of one shape, and why, before anything is solved.

use super::ask::panel_offers;
use crate::constraint::{KINDS, Kind};
use crate::mesh::{Curvature, CurvatureLines, Mesh, Ragged, Topology, face_curvatures};
use crate::solve::{Constraints, least_move};
use serde::Serialize;

/// Vertices move a lot from the first part of the mean edge on, by the estimate, and hardly below the second.
const A_LOT: f64 = 0.2;
const A_LITTLE: f64 = 0.03;
/// Panels are as asked where they need to move by less than this part.
const NOTHING: f64 = 1e-6;
/// Edges off the lines of curvature by fewer degrees are not why a mesh has to move.
const OFF: f64 = 10.0;
/// A face is on a saddle where the product of the principal curvatures at its corners is below this part of the sum of
/// their squares, on average; and it is told where more than such a part of the faces is.
const SADDLE: f64 = -0.02;
const SOME: f64 = 0.05;

/// How far vertices move, on average.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum HowFar {
    /// All panels are as asked.
    Nothing,
    /// By a small part of an edge.
    Hardly,
    /// By less than a fifth of the mean edge.
    Little,
    /// By a fifth of the mean edge or more.
    Lot,
}

/// The forecast for panels of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ForecastOfKind {
    /// The id of the kind.
    pub kind: &'static str,
    /// The adjective for panels that are so.
    #[serde(skip)]
    adjective: &'static str,
    /// How far the vertices have to move on average, as a part of the mean edge, see [`least_move`]. Up to a third of
    /// an edge it is within a third of what an exact shape costs, beyond that rather too much (`tests/scene/forecast.rs`).
    pub least_move: f64,
    /// The same in words.
    pub how_far: HowFar,
}

/// The forecasts for all kinds that are offered for panels.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Forecast {
    /// In the order of [`KINDS`].
    pub kinds: Vec<ForecastOfKind>,
    /// The mean angle of the edges to the lines of curvature, degrees; none where the surface has none, and where
    /// most faces are no quads, whose edges need not follow them.
    #[serde(skip)]
    pub off_curvature_lines: Option<f64>,
    /// How many faces with more than four corners are on saddles, and how many there are with known curvatures, where most
    /// faces have so many corners; none where they have not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub saddles: Option<[usize; 2]>,
}

impl Forecast {
    /// Of the shapes that are offered for the panels of `mesh`; none where no shape is.
    pub fn of(mesh: &Mesh, topology: &Topology) -> Option<Forecast> {
        let edge = topology.mean_edge(&mesh.positions);
        let offers = panel_offers(mesh).into_iter().filter(|offer| offer.reason.is_none());
        let kinds: Vec<ForecastOfKind> =
            offers.filter_map(|offer| ForecastOfKind::of(offer.kind, mesh, edge)).collect();
        (!kinds.is_empty()).then(|| Forecast {
            kinds,
            off_curvature_lines: topology
                .is_quad_dominant()
                .then(|| CurvatureLines::new(&mesh.positions, &mesh.faces, topology).mean)
                .flatten(),
            saddles: has_large_faces(&mesh.faces).then(|| saddles(mesh, topology)),
        })
    }

    /// A sentence or a few: for what it will move how far, why, and what to do about it.
    pub fn words(&self) -> String {
        let mut words = String::from("This mesh will");
        let (mut farthest, mut joint) = (None, "");
        for how_far in HowFar::FARTHEST_FIRST {
            let kinds = self.kinds.iter().filter(|kind| kind.how_far == how_far);
            let adjectives: Vec<&str> = kinds.map(|kind| kind.adjective).collect();
            if adjectives.is_empty() {
                continue;
            }
            let (words_of, panels) = match farthest {
                None => (how_far.words_with_verb(), "panels"),
                Some(_) => (how_far.words(), "ones"),
            };
            let parts = [joint, " ", words_of, " for ", &adjectives.join(" or "), " ", panels];
            words += &parts.concat();
            farthest = farthest.or(Some(how_far));
            joint = " and";
        }
        words += &match (farthest, self.off_curvature_lines.filter(|&angle| angle >= OFF)) {
            (Some(HowFar::Lot), Some(angle)) => format!(
                ": its edges are {angle:.0}° off the lines of curvature on average. Edges along them, or a \
                 larger tolerance, need less."
            ),
            (Some(HowFar::Lot), None) => ". A larger tolerance needs less.".to_owned(),
            _ => ".".to_owned(),
        };
        let some = |&[on_saddles, all]: &[usize; 2]| on_saddles as f64 > SOME * all as f64;
        if let Some([on_saddles, all]) = self.saddles.filter(some) {
            words += &format!(
                " {on_saddles} of {all} faces with more than four corners are where it is a saddle: flat panels \
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
    /// Of the kind `id` on all faces that can have it; `edge` is the mean length of an edge.
    fn of(id: &str, mesh: &Mesh, edge: f64) -> Option<ForecastOfKind> {
        let info = KINDS.iter().find(|info| info.id == id)?;
        let kind = Kind::new(id, serde_json::json!({})).ok()?;
        let fitting = mesh.faces.iter().filter(|face| info.arity.fits(face.len()));
        let row = Constraints { kind, weight: 1.0, members: fitting.collect() };
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

/// Whether most faces have more than four corners.
fn has_large_faces(faces: &Ragged) -> bool {
    2 * faces.iter().filter(|face| face.len() > 4).count() > faces.len()
}

/// How many faces of more than four corners are on saddles, and how many there are where the curvature is known.
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
