//! New panels along the lines of curvature of the copy, for
//! [`crate::web::worker::Solver::take_panels`].

use super::model_copy::ModelCopy;
use crate::session::{LayoutSettings, LayoutWords, PanelLayout};
use crate::web::thrown;
use crate::web::values::{AsIs, Js, flat, indices, plain, read};
use js_sys::{Float64Array, Function, Uint32Array};
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// Panels on the surface, to draw and to take.
#[derive(Serialize, Tsify)]
pub struct LaidOut {
    #[serde(flatten)]
    said: LayoutWords,
    /// `#V by 3`.
    positions: AsIs<Float64Array>,
    /// Panel `k` has the corners from `offsets[k]` to `offsets[k + 1]` of `indices`.
    offsets: AsIs<Uint32Array>,
    indices: AsIs<Uint32Array>,
    /// Points of lines over the surface along the edges, `#points by 3`.
    points: AsIs<Float64Array>,
    /// Line `k` has the points from `ends[k]` to `ends[k + 1]`.
    ends: AsIs<Uint32Array>,
    /// The number of lines at irregular points, which come first.
    irregular: usize,
}

#[wasm_bindgen]
impl ModelCopy {
    /// Lays out panels along the lines of curvature; `told` is called with what is being done, in
    /// words. Curvature, fields and maps are kept with the copy.
    #[wasm_bindgen(js_name = layOutPanels)]
    pub fn lay_out_panels(
        &mut self,
        settings: Js<LayoutSettings>,
        told: &Function,
    ) -> Result<Js<LaidOut>, JsValue> {
        let settings = read(settings)?;
        let mut last = "";
        let layouts = match &mut self.layouts {
            Some(layouts) => layouts,
            none => none.insert(self.session.panel_layouts().map_err(thrown)?),
        };
        let layout = layouts.lay_out(&settings, &mut |stage, _| {
            if last != stage.words() {
                last = stage.words();
                // That nobody listens changes nothing.
                let _ = told.call1(&JsValue::NULL, &last.into());
            }
            true
        });
        plain(&LaidOut::of(&layout.map_err(thrown)?))
    }
}

impl LaidOut {
    fn of(layout: &PanelLayout) -> LaidOut {
        let faces = &layout.mesh.faces;
        let mut offsets = vec![0];
        offsets.extend(faces.iter().scan(0, |end, face| {
            *end += face.len() as u32;
            Some(*end)
        }));
        let mut ends = vec![0];
        ends.extend(layout.lines.iter().scan(0, |end, line| {
            *end += line.len() as u32;
            Some(*end)
        }));
        LaidOut {
            said: layout.in_words(),
            positions: AsIs(flat(&layout.mesh.positions)),
            offsets: indices(&offsets),
            indices: indices(faces.indices()),
            points: AsIs(flat(&layout.lines.concat())),
            ends: indices(&ends),
            irregular: layout.irregular_lines,
        }
    }
}
