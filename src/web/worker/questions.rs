//! Questions about the open model: its report, verdicts in words, lists of elements, selections, and
//! what is offered.

use super::solver::Solver;
use crate::mesh::Scheme;
use crate::session::{
    ConstraintOffers, ExactWords, OfferedOperation, Refinement, Remeshing, RemeshingPreview,
    Report, RunVerdict, SelectRequest, Session, Shape, VariantRow, Verdict, VerdictReport,
    VerdictWords, WorstElement,
};
use crate::web::thrown;
use crate::web::values::{AsIs, Js, indices, plain, plains, read, refused, thrown_at};
use js_sys::Uint32Array;
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// The report of the command line. Only the benchmark reads it, which has no types.
#[derive(Serialize, Tsify)]
#[tsify(type = "any")]
pub struct WholeReport(Report);

/// The verdict on the panels, in numbers and in words.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct PanelVerdict {
    /// As in the report of the command line; better choices are tried elsewhere.
    #[serde(flatten)]
    report: VerdictReport,
    #[serde(flatten)]
    said: VerdictWords,
}

impl PanelVerdict {
    fn of(session: &Session, numbers: Verdict) -> PanelVerdict {
        let said = session.verdict_words(&numbers);
        PanelVerdict { report: VerdictReport::new(numbers, said.full(), Vec::new()), said }
    }
}

/// Histograms of the corner angles of the faces, in bins of equal width from 0 to 180 degrees.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Angles {
    original: Vec<u32>,
    now: Vec<u32>,
}

/// Elements of the mesh, ascending; edges as in `edges()`.
#[derive(Serialize, Tsify)]
pub struct Elements {
    vertices: AsIs<Uint32Array>,
    edges: AsIs<Uint32Array>,
    faces: AsIs<Uint32Array>,
}

impl Elements {
    fn of(vertices: &[u32], edges: &[u32], faces: &[u32]) -> Elements {
        Elements { vertices: indices(vertices), edges: indices(edges), faces: indices(faces) }
    }
}

/// The faces and vertices on which a row of constraints acts.
#[derive(Serialize, Tsify)]
pub struct Members {
    faces: AsIs<Uint32Array>,
    vertices: AsIs<Uint32Array>,
}

#[wasm_bindgen]
impl Solver {
    /// Returns the report, in the words and units of the command line.
    pub fn report(&self) -> Result<Js<WholeReport>, JsValue> {
        plain(&WholeReport(self.open()?.report()))
    }

    /// Returns how many panels meet their requirement within the tolerance; undefined if no row
    /// requires a shape of the panels.
    pub fn verdict(&mut self) -> Result<Option<Js<PanelVerdict>>, JsValue> {
        let session = self.open_mut()?;
        let verdict = session.verdict(session.tolerance());
        verdict.map(|verdict| plain(&PanelVerdict::of(session, verdict))).transpose()
    }

    /// Says how many panels meet their requirement within the tolerance so far; undefined if no row
    /// requires a shape of the panels.
    #[wasm_bindgen(js_name = panelProgress)]
    pub fn panel_progress(&mut self) -> Result<Option<String>, JsValue> {
        let session = self.open_mut()?;
        Ok(session.panel_progress(session.tolerance()))
    }

    /// Returns whether the constraints are met within the tolerance, after a run without hard
    /// constraints; undefined if no constraint has a weight.
    #[wasm_bindgen(js_name = runVerdict)]
    pub fn run_verdict(&mut self) -> Result<Option<Js<RunVerdict>>, JsValue> {
        let session = self.open_mut()?;
        session.run_verdict(session.tolerance()).as_ref().map(plain).transpose()
    }

    /// Returns how well the hard constraints are met; undefined if they have not been met for the
    /// current shape.
    #[wasm_bindgen(js_name = exactWords)]
    pub fn exact_words(&self) -> Result<Option<Js<ExactWords>>, JsValue> {
        self.open()?.exact_words().as_ref().map(plain).transpose()
    }

    /// Returns the numbers of the variants that were kept.
    #[wasm_bindgen(js_name = variantTable)]
    pub fn variant_table(&mut self) -> Result<Vec<Js<VariantRow>>, JsValue> {
        let session = self.open_mut()?;
        plains(&session.variant_table(session.tolerance()))
    }

    /// Returns the histograms of the corner angles, of the original and of the current shape.
    pub fn angles(&self) -> Result<Js<Angles>, JsValue> {
        let session = self.open()?;
        let [original, now] = [Shape::Original, Shape::Now].map(|shape| session.angles(&shape));
        plain(&Angles { original, now })
    }

    /// Returns the `count` worst faces by a measure; `tolerance` is that of the measure, if it has one.
    #[wasm_bindgen(js_name = worstFaces)]
    pub fn worst_faces(
        &mut self,
        measure: &str,
        count: usize,
        tolerance: Option<f64>,
    ) -> Result<Vec<Js<WorstElement>>, JsValue> {
        let worst = self.open_mut()?.worst_faces(measure, count, tolerance);
        plains(&worst.ok_or_else(|| thrown(format!("unknown measure {measure:?}")))?)
    }

    /// Returns the `count` worst constraints of a row; `tolerance` is that of lengths, if it is known.
    #[wasm_bindgen(js_name = worstConstraints)]
    pub fn worst_constraints(
        &mut self,
        row: usize,
        count: usize,
        tolerance: Option<f64>,
    ) -> Result<Vec<Js<WorstElement>>, JsValue> {
        plains(&self.open_mut()?.worst_constraints(row, count, tolerance))
    }

    /// Returns the vertices, edges and faces with a flaw, as a selection.
    pub fn flawed(&self, name: &str) -> Result<Js<Elements>, JsValue> {
        let session = self.open()?;
        let found = session.elements_with_problem(name);
        let found = found.ok_or_else(|| thrown(format!("unknown flaw {name:?}")))?;
        plain(&Elements::of(&found.vertices, &session.edges_between(&found.edges), &found.faces))
    }

    /// Returns the selection after an operation.
    pub fn select(&mut self, request: Js<SelectRequest>) -> Result<Js<Elements>, JsValue> {
        let found = self.open_mut()?.select(&read(request)?).map_err(|error| thrown_at(&error))?;
        plain(&Elements::of(&found.vertices, &found.edges, &found.faces))
    }

    /// Returns the faces and vertices on which row `constraint` acts.
    pub fn members(&self, constraint: usize) -> Result<Js<Members>, JsValue> {
        let [faces, vertices] = self.open()?.members(constraint);
        plain(&Members { faces: indices(&faces), vertices: indices(&vertices) })
    }

    /// Returns the operations on the mesh, with sizes that suit it.
    #[wasm_bindgen(js_name = meshOperations)]
    pub fn mesh_operations(&self) -> Result<Vec<Js<OfferedOperation>>, JsValue> {
        plains(&self.open()?.operations())
    }

    /// Returns a preview of an operation on the mesh.
    pub fn remeshing(&self, asked: Js<Remeshing>) -> Result<Js<RemeshingPreview>, JsValue> {
        plain(&self.open()?.remeshing(&read(asked)?).map_err(refused)?)
    }

    /// Returns the mesh sizes after refining by a scheme once, twice and so on. Edges at which the
    /// surface turns by more than `keep` degrees stay sharp.
    ///
    /// # Errors
    /// The mesh cannot be refined by this scheme.
    pub fn refinements(
        &self,
        scheme: Js<Scheme>,
        keep: f64,
    ) -> Result<Vec<Js<Refinement>>, JsValue> {
        plains(&self.open()?.refinements(read(scheme)?, keep).map_err(refused)?)
    }

    /// Returns what is offered for a new constraint while `vertices` and `faces` are selected; the
    /// vertices include the corners of the faces.
    #[wasm_bindgen(js_name = constraintOffers)]
    pub fn constraint_offers(
        &self,
        vertices: Vec<u32>,
        faces: Vec<u32>,
    ) -> Result<Js<ConstraintOffers>, JsValue> {
        let offers = self.open()?.constraint_offers(vertices, faces);
        plain(&offers.map_err(|error| thrown_at(&error))?)
    }
}
