//! Meshes from a plan, and the plan as it is drawn and changed in the page. Points of a plan are named
//! by their loop, the outline being loop 0, and their index in it.

use super::generate::obj;
use super::thrown;
use super::values::{Js, plain, plains, read};
use crate::generate::{
    Plan, PlanDrawing, PlanError, PlanLoops, PlanPoint, bulge_of, bulge_through, end_of_side,
    loop_through,
};
use crate::math::grid_step;
use crate::scene::Up;
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// The surface over a drawn plan.
#[derive(Serialize, Tsify)]
pub struct NewPlan {
    /// The text of an OBJ file.
    text: String,
    /// The vertices that the surface stands on, if those are only its corners; else empty.
    supports: Vec<u32>,
}

/// Returns the surface over a drawn plan.
///
/// # Errors
/// The fault of the plan, in one sentence. If two sides cross, the error has `sides`: for each, its
/// loop and the point where it begins; the outline is loop 0.
#[wasm_bindgen(js_name = newPlan)]
pub fn new_plan(plan: Js<Plan>, units: &str) -> Result<Js<NewPlan>, JsValue> {
    let surface = read::<Plan>(plan)?.surface().map_err(|why| refused(&why))?;
    plain(&NewPlan { text: obj(&surface.mesh, units, Up::Z), supports: surface.feet })
}

fn refused(why: &PlanError) -> JsValue {
    let error = thrown(format_args!("{why:#}"));
    if let PlanError::Crossing(sides) = why {
        let numbers = sides.map(|side| [side.hole.map_or(0, |hole| hole + 1), side.point]);
        let numbers: js_sys::Array =
            numbers.as_flattened().iter().map(|&number| JsValue::from(number as u32)).collect();
        // Setting a property of a new object cannot fail.
        let _ = js_sys::Reflect::set(&error, &"sides".into(), &numbers);
    }
    error
}

/// Returns the plan to start with, in a unit of which a metre has `metre`.
#[wasm_bindgen(js_name = firstPlan)]
pub fn first_plan(metre: f64) -> Result<Js<Plan>, JsValue> {
    plain(&Plan::first(metre))
}

/// Returns the plan with all lengths multiplied by `factor`.
///
/// # Errors
/// If it is no plan.
#[wasm_bindgen(js_name = scaledPlan)]
pub fn scaled_plan(plan: Js<Plan>, factor: f64) -> Result<Js<Plan>, JsValue> {
    plain(&read::<Plan>(plan)?.scaled(factor))
}

/// Returns the sides of the loops, as they are drawn.
#[wasm_bindgen(js_name = drawnPlan)]
pub fn drawn_plan(loops: Js<PlanLoops>) -> Result<Js<PlanDrawing>, JsValue> {
    plain(&PlanDrawing::of(&read(loops)?))
}

/// Returns the bulge of the side that begins at a point, if its middle is pulled to the place nearest
/// to `through`, two coordinates.
///
/// # Errors
/// If there is no such point.
#[wasm_bindgen(js_name = bulgeThrough)]
pub fn pulled_bulge(
    loops: Js<PlanLoops>,
    of: usize,
    point: usize,
    through: &[f64],
) -> Result<f64, JsValue> {
    let PlanLoops(loops) = read(loops)?;
    let &[x, y] = through else { return Err(thrown("expected two coordinates")) };
    let points = loops.get(of).map_or(&[][..], |points| points);
    bulge_through(points, point, [x, y]).ok_or_else(|| thrown("there is no such point"))
}

/// Returns the bulge of a side by its rise, limited to a half circle.
#[wasm_bindgen(js_name = bulgeOf)]
pub fn risen_bulge(rise: f64, chord: f64) -> f64 {
    bulge_of(rise, chord)
}

/// Returns where the side that begins at a point ends, two coordinates, if its chord gets another
/// `length` in the same direction; undefined for no length above 0.
#[wasm_bindgen(js_name = endOfSide)]
pub fn moved_end(
    loops: Js<PlanLoops>,
    of: usize,
    point: usize,
    length: f64,
) -> Result<Option<Vec<f64>>, JsValue> {
    let PlanLoops(loops) = read(loops)?;
    let points = loops.get(of).map_or(&[][..], |points| points);
    Ok(end_of_side(points, point, length).map(Vec::from))
}

/// Returns a drawn loop through `places` (#points by 2), made counterclockwise. With `has_corners`, its
/// sharp convex turns become corners.
#[wasm_bindgen(js_name = loopThrough)]
pub fn drawn_loop(places: &[f64], has_corners: bool) -> Result<Vec<Js<PlanPoint>>, JsValue> {
    let (places, _) = places.as_chunks::<2>();
    plains(&loop_through(places, has_corners))
}

/// Returns the step of a grid with about `count` steps over a length.
#[wasm_bindgen(js_name = planGridStep)]
pub fn plan_grid_step(length: f64, count: f64) -> f64 {
    grid_step(length, count)
}
