//! Shape constraints `C_i`: projection operators (paper section 3), the list of kinds, and which
//! vertices they act on.
//!
//! # Adding an operator
//!
//! 1. Write `constraint/<kind>.rs`: a struct whose fields are the parameters of the scene file, and
//!    its [`Projection`]. It sees its own mean-centred points and their rest points, and nothing
//!    else: no indices, no mesh, no weights.
//! 2. Add one line to the list at the end of this file, and its `mod`.
//! 3. Tell what the kind means a second time, without the operator, in `tests/support/shapes`:
//!    the property tests run over the list of kinds.
//!
//! The scene format, the command line, the controls of the page, the property tests and the
//! operator table follow from the declaration.
//!
//! # What is not an operator
//!
//! | file | holds |
//! |---|---|
//! | `info` | the declaration of a kind |
//! | `params` | the parameters of a kind from JSON |
//! | `limits`, `target`, `angle_range`, `direction` | values that parameters have in common |
//! | `select`, `resolve` | selectors, and the vertices of each constraint that one makes |
//! | `batch` | many constraints of one kind, projected in lanes |
//! | `separate_lanes` | for operators whose work depends on where the points are |
//! | `pitot`, `symmetry_group` | what incircles and tangent incircles, and symmetries, are made of |
//! | `usual` | what a place is to the mesh, for which a kind is the usual choice |
//! | `sketch` | a drawing of what a kind asks, made by the operator itself |

mod angle;
mod angle_range;
mod area;
mod batch;
mod bending;
mod circle;
mod conical;
mod direction;
mod equal_length;
mod incircle;
mod info;
mod limits;
mod line;
mod line_segment;
mod on_curve;
mod on_surface;
mod parallelogram;
mod params;
mod pitot;
mod planar_similar;
mod plane;
mod rectangle;
mod regular_polygon;
mod resolve;
mod rigid;
mod select;
mod separate_lanes;
mod similar;
mod sketch;
mod sphere;
mod square;
mod symmetry;
mod symmetry_group;
mod tangent_incircles;
mod target;
mod usual;
mod volume;

pub use batch::{Batch, LocalStep, Projected, Reference, Row, batches};
pub use info::{Arity, Centring, Form, Info, Param, ParamValue};
pub use resolve::resolve;
pub use select::{Element, SelectError, Selector, Set, Sets, describe};
pub use sketch::Sketch;
pub use usual::PlaceShape;

use crate::math::{Lane, Vec3};

/// One projection operator `P_i` (paper section 2.1, Eq. 2, and section 3).
pub trait Projection: Clone + PartialEq + std::fmt::Debug + 'static {
    /// What the operator is called, takes and guarantees.
    const INFO: Info;

    /// Whether [`Projection::project`] reads the rest points; without, it gets none.
    const READS_REST: bool = false;

    /// Whether each constraint keeps the previous projection where the new one is farther, also in a scene
    /// that does not ask for it: where projections are so far from the closest at times that the total
    /// energy would rise by more than a few digits.
    const GUARDED: bool = false;

    /// Whether the projection is the closest point of the set, with these parameters; [`Info::exact`] is
    /// about the default ones.
    fn is_exact(&self) -> bool {
        Self::INFO.exact
    }

    /// The places for which it is what somebody usually wants: hosts choose it beforehand there.
    const USUAL_FOR: &'static [PlaceShape] = &[];

    /// Gives the operator what it may look up besides its own points. Called once, before anything
    /// else.
    fn refer(&mut self, reference: &Reference<'_>) {
        let _ = reference;
    }

    /// Brings the centred rest points of one constraint into the form in which
    /// [`Projection::project`] wants them: three numbers for each point, whatever they mean. Called
    /// once per constraint, before all projections.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        let _ = rest;
    }

    /// The closed form, for one constraint or for several side by side: writes the closest points
    /// that have the shape to `projected`. False when it is not accurate in every lane; what it
    /// wrote is then not used. `v` are the points, centred as [`Info::centring`] says, `rest` the
    /// rest points `V'`, centred likewise, after [`Projection::prepare`], `n` of each.
    ///
    /// The result need not be centred: whoever scatters it centres it again. It is equivariant
    /// under scaling: no absolute thresholds.
    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool;

    /// Replaces the points `v` of one constraint by the closest points that have the shape: slower,
    /// and finite and accurate for every finite input, degenerate ones included. Called where the
    /// closed form is not accurate; an operator whose closed form always is has none.
    fn careful(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let _ = (rest, v);
        unreachable!("the closed form of this kind is accurate for every input");
    }

    /// Step I for one chunk of constraints: the closed form where it is accurate, else each lane
    /// by itself.
    #[inline(always)]
    fn project<S: Lane>(&self, rest: &[Vec3<S>], v: &[Vec3<S>], projected: &mut [Vec3<S>]) {
        project_with(
            |rest, v, projected| self.closed_form(rest, v, projected),
            &|rest, v| self.careful(rest, v),
            (rest, v, projected),
        );
    }

    /// The shape that fits the points `v` (in their place, not centred), to be drawn. None where the
    /// projection itself says all there is to see.
    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        let _ = v;
        None
    }
}

/// Rest points, points and their projections.
type Chunk<'a, S> = (&'a [Vec3<S>], &'a [Vec3<S>], &'a mut [Vec3<S>]);

/// See [`Projection::careful`].
type Careful<'a> = &'a dyn Fn(&[Vec3<f64>], &mut [Vec3<f64>]);

/// Step I with this closed form, and where it is not accurate each lane by itself.
#[inline(always)]
fn project_with<S: Lane>(
    closed_form: impl Fn(&[Vec3<S>], &[Vec3<S>], &mut [Vec3<S>]) -> bool,
    careful: Careful<'_>,
    (rest, v, projected): Chunk<'_, S>,
) {
    if !closed_form(rest, v, projected) {
        lane_by_lane(&closed_form, careful, (rest, v, projected));
    }
}

/// A closed form of some kind: of rest points, points, and where their projections go.
type ClosedForm<'a, S> = &'a dyn Fn(&[Vec3<S>], &[Vec3<S>], &mut [Vec3<S>]) -> bool;

/// Projects each lane by itself: by the closed form, with the lane in the place of all, so that no
/// kind has a second one that is compiled for a single lane, and otherwise carefully. A lane whose
/// closed form is accurate gets the same bits as in a chunk where all are.
#[cold]
#[inline(never)]
fn lane_by_lane<S: Lane>(
    closed_form: ClosedForm<'_, S>,
    careful: Careful<'_>,
    (rest, v, projected): Chunk<'_, S>,
) {
    let mut results = vec![Vec3::zero(); v.len()];
    for i in 0..S::WIDTH {
        let everywhere =
            |points: &[Vec3<S>]| points.iter().map(|p| Vec3::splat(p.lane(i))).collect();
        let (all_rest, all): (Vec<_>, Vec<_>) = (everywhere(rest), everywhere(v));
        if S::WIDTH > 1 && closed_form(&all_rest, &all, &mut results) {
            projected.iter_mut().zip(&results).for_each(|(to, from)| to.set_lane(i, from.lane(i)));
        } else {
            let lane = |points: &[Vec3<S>]| points.iter().map(|p| p.lane(i)).collect::<Vec<_>>();
            let mut result = lane(v);
            careful(&lane(rest), &mut result);
            projected.iter_mut().zip(&result).for_each(|(to, from)| to.set_lane(i, *from));
        }
    }
}

/// A fitted shape, to be drawn over the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fitted {
    /// A circle in space: centre, unit normal, radius.
    Circle {
        /// Centre.
        centre: Vec3<f64>,
        /// Unit normal of its plane.
        normal: Vec3<f64>,
        /// Radius, positive and finite.
        radius: f64,
    },
    /// A sphere: centre, radius.
    Sphere {
        /// Centre.
        centre: Vec3<f64>,
        /// Radius, positive and finite.
        radius: f64,
    },
}

/// A shape whose radius is so many times the extent of its points is all but a line or a plane there.
const LARGEST_DRAWN: f64 = 4.0;

impl Fitted {
    /// Whether its radius is not many times the extent of its points.
    fn is_of_the_size_of(&self, points: &[Vec3<f64>]) -> bool {
        let (Fitted::Circle { radius, .. } | Fitted::Sphere { radius, .. }) = *self;
        let extent = points.iter().map(|&p| (p - points[0]).length()).fold(0.0, f64::max);
        radius <= LARGEST_DRAWN * extent
    }
}

/// Makes the enum of kinds and everything that is the same for each of them. The only list of
/// kinds in the project.
macro_rules! kinds {
    ($($module:ident :: $Kind:ident),* $(,)?) => {
        /// A kind of constraint with its parameters.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Kind {
            $(#[doc = concat!("See `constraint/", stringify!($module), ".rs`.")]
            $Kind($module::$Kind),)*
        }

        /// Every kind, in the order in which hosts list them.
        pub const KINDS: &[Info] = &[$($module::$Kind::INFO),*];

        /// `#KINDS` rows: see [`Projection::USUAL_FOR`].
        pub const USUAL_FOR: &[&[PlaceShape]] = &[$($module::$Kind::USUAL_FOR),*];

        impl Kind {
            /// The kind named `id` with the parameters `params`.
            ///
            /// # Errors
            /// When no kind has that id, or a parameter is unknown or out of type.
            pub fn new(id: &str, params: serde_json::Value) -> Result<Kind, KindError> {
                $(if id == $module::$Kind::INFO.id {
                    let kind = Kind::$Kind(params::read(&params)?);
                    info::check_ranges($module::$Kind::INFO.params, &kind.params())?;
                    return Ok(kind);
                })*
                Err(KindError::Unknown)
            }

            /// The declaration.
            pub fn info(&self) -> &'static Info {
                const ALL: &[Info] = KINDS;
                let id = match self { $(Kind::$Kind(_) => $module::$Kind::INFO.id),* };
                ALL.iter().find(|info| info.id == id).expect("every kind is in the list of kinds")
            }

            /// Whether its projection is the closest point of the set, with these parameters.
            pub fn is_exact(&self) -> bool {
                match self { $(Kind::$Kind(p) => p.is_exact()),* }
            }

            /// Whether the total energy can rise with it where the scene has no `monotone` guard.
            pub fn can_rise(&self) -> bool {
                match self { $(Kind::$Kind(p) => !(p.is_exact() || $module::$Kind::GUARDED)),* }
            }

            /// The parameters as the object of a scene file.
            pub fn params(&self) -> serde_json::Value {
                match self { $(Kind::$Kind(p) => serde_json::to_value(p)),* }
                    .expect("parameters are plain numbers, strings and arrays")
            }

            /// Calls `visitor` with the operator itself.
            pub fn visit<V: KindVisitor>(&self, visitor: V) -> V::Output {
                match self { $(Kind::$Kind(p) => visitor.visit(p)),* }
            }
        }
    };
}

/// A computation that needs the operator's type, such as making a batch of it.
pub trait KindVisitor {
    /// What it gives.
    type Output;
    /// The computation for one operator.
    fn visit<P: Projection>(self, operator: &P) -> Self::Output;
}

/// Why [`Kind::new`] gave none.
#[derive(Clone, Debug, PartialEq)]
pub enum KindError {
    /// No kind has that id.
    Unknown,
    /// A parameter is unknown, missing or out of type.
    Params {
        /// Where below the constraint, such as `scale[0]`.
        path: String,
        /// What is wrong and what was expected.
        message: String,
    },
}

kinds! {
    line::Line,
    plane::Plane,
    circle::Circle,
    sphere::Sphere,
    line_segment::LineSegment,
    rigid::Rigid,
    similar::Similar,
    planar_similar::PlanarSimilar,
    regular_polygon::RegularPolygon,
    square::Square,
    parallelogram::Parallelogram,
    rectangle::Rectangle,
    angle::Angle,
    equal_length::EqualLength,
    area::Area,
    volume::Volume,
    bending::Bending,
    incircle::Incircle,
    tangent_incircles::TangentIncircles,
    conical::Conical,
    symmetry::Symmetry,
    on_curve::OnCurve,
    on_surface::OnSurface,
}
