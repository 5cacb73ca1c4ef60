//! Shape-Up in a browser tab: shaping discrete geometry with projections.
//!
//! An implementation of *Shape-Up: Shaping Discrete Geometry with Projections* (Bouaziz, Deuss,
//! Schwartzburg, Weise, Pauly; Symposium on Geometry Processing 2012), for polygon meshes, curves,
//! tetrahedra and point sets. Everything is computed in the browser: the solver is compiled to
//! WebAssembly and runs in a worker, the view draws with wgpu, and a thin page connects them.
//!
//! # Data flow
//!
//! ```text
//! OBJ  ->  mesh  ->  constraint  ->  solve  ->  scene  ->  session  ->  positions  ->  view
//!                    all of them use math and sparse
//! ```
//!
//! Each stage depends only on those to its left; [`view`] receives positions and index buffers,
//! never the solver. `tests/rooms.rs` enforces the dependencies of this table: a room may use any
//! item of the rooms that it knows of.
//!
//! | room | contents | knows of |
//! |---|---|---|
//! | [`math`] | vectors in SIMD lanes and of the plane, eigenvectors, closest rotations, fitted circles and spheres; on nalgebra, dense matrices of any size | nothing |
//! | [`words`] | words for readers: numbers, lengths with units, counts, lists | nothing |
//! | `json` | what `serde_json` lacks: errors with paths in our words, repeated keys, lists of indices | nothing |
//! | [`mesh`] | polygon mesh, reading and writing of files, topology, Laplacian, closest point, error measures | math, words |
//! | [`constraint`] | one projection operator per file, the list of kinds, selectors, batches | math, json, mesh |
//! | [`sparse`] | `L D L^T` on the types of sprs: ordering, symbolic analysis, two numeric factors, triangular sweeps | math |
//! | [`quads`] | quads along the lines of curvature: cross field, seamless map, exact extraction | math, words, mesh, sparse |
//! | [`solve`] | energies, assembly, the two-step iteration, accelerators, conformal maps | math, mesh, constraint, sparse |
//! | [`scene`] | the scene file: serde types, validation, and the optimisation problem that it defines | math, words, json, mesh, constraint, sparse, solve |
//! | [`fabricate`] | parts to cut: panels on sheets, offsets, the build check, files for machines | math, words, mesh, sparse, scene |
//! | [`session`] | the interface of all hosts: load, edit, drag, step, undo, report | all above |
//! | [`generate`] | new meshes: by kind and sizes, from a plan, or between curves; the example scenes and their meshes | math, json, mesh, constraint, sparse, scene, session |
//! | [`experiment`] | the paper's comparisons with other methods (Fig. 10, 11), run live | all above |
//! | [`view`] | wgpu: camera, picking, faces, edges, handles, fitted shapes | math |
//! | `web` | wasm-bindgen interfaces: one for the workers (engine), one for the page (view) | all above |
//!
//! `src/bin` is outside: the command line, which drives sessions.
//!
//! Beside the pipeline, [`experiment`] contains the methods that the paper compares with: gradient
//! descent, quasi-Newton without a metric, and a penalty method with Gauss-Newton. It drives
//! sessions as a host does; only the command line runs it.
//!
//! # One drag
//!
//! 1. The page's view finds the handle under the pointer (`view::picking`) and converts the motion
//!    of the pointer to a target (`view::gizmo`). The page sends vertex and target to the worker.
//! 2. `web::worker` calls `Session::drag_through` (`session/dragging`), which checks the target and
//!    passes it to the solver. Only the gradient of the handle's energy changes, no matrix. What
//!    leads back to the state before the drag is kept in `session/undo/transaction`.
//! 3. The next iteration uses it: `Session::step` calls `Solver::step` (`solve/solver/step`).
//!    - Local step: each batch of constraints projects its points (`constraint/batch` and
//!      `constraint/kinds`).
//!    - `solve::energy` sums energies and gradients of shape, closeness, smoothness and handles.
//!    - Global step: `solve::system` applies the inverse of the normal matrix, by triangular sweeps through
//!      the factor of [`sparse`]; `solve::accelerate` improves the step, or falls back to it.
//! 4. The worker copies the positions to the page, which passes them to `view::state`; `view::gpu`
//!    draws.
//! 5. The end of the drag records it as one step of undo (`session/undo/history`).
//!
//! # One run
//!
//! 1. [`mesh`] reads a file, or [`scene`] a scene and its mesh. `Session::open` (`session/load`)
//!    validates the scene against the mesh and resolves the selectors (`session/state/rows`).
//! 2. `Solver::new` assembles the normal matrix (`solve::assemble`); [`sparse`] orders and factors it.
//! 3. `Session::begin_run`, then `Session::step` until it reports the end: converged, collapsed
//!    (`session/run/collapse_guard`), or after as many iterations as the scene allows. Where
//!    constraints are hard, `solve/exact` then meets them (`session/run/meeting`), by one attempt
//!    after another (`session/searching`, `session/run/attempts`) until a shape is good by the measure
//!    of `session/run/shape_measure`. A press for panels tries all of them, and at last larger
//!    tolerances (`session/run/easing`).
//! 4. `Session::end_run` keeps the iterate of least energy, or the best shape for the hard
//!    constraints, and records the run as one step of undo. The scene names the attempt that found it
//!    ([`scene::ChosenAttempt`]), so that every host gets the same shape from it.
//! 5. `Session::report` measures the shape (`mesh/measure`), and the verdicts on it are worded beside
//!    it: `session/report/verdict_words` on panels, `run_verdict`, and `exact_words` on hard
//!    constraints. `session/export` writes OBJ or the scene.
//!
//! # Other ways through the rooms
//!
//! - The text of a scene: `Scene::from_json` (`scene/json/file`) gives the typed [`scene::Scene`],
//!   `Scene::validate` (`scene/validate`) checks it against the mesh, and `scene/problem` makes the
//!   [`solve::Problem`] of it.
//! - A setting of Build: a field of [`scene::BuildSettings`] and its declaration in
//!   [`scene::BUILD_SETTINGS`], of which hosts make their forms and options. The edit `SetBuild`
//!   stores it in the scene; the page's second worker passes it to `web::jobs::build`, which calls
//!   [`fabricate::Build::new`].
//! - A question of the page: a method in `web/worker`, such as `verdict` in `web/worker/questions`, whose
//!   types wasm-bindgen writes; and its use in the page, `ask.verdict()` of
//!   `www/solver/solver-client.ts`. What takes long is a method in `web/jobs`, for the second worker
//!   (`www/solver/jobs-client.ts`).
//! - An edit of the page: a variant of [`session::Edit`], whose TypeScript type is generated, and its
//!   effect in `session/edit/apply`. The page calls `actions.edit({ removeSet: { name } })`;
//!   `web/values` reads the object, and refuses fields that the variant does not have.
//! - A setting of the solver: a declaration in [`session::SETTINGS`]. Hosts build their controls from
//!   that list.
//! - An operator: a file in `constraint/kinds`, and a line in the list there. See [`constraint`].
//!
//! # From a shape to parts
//!
//! [`fabricate`] takes a mesh and settings (the key `build` of a scene), and needs no
//! solver. The command line calls it with the shape of a scene; the page in the second worker
//! (`www/worker/jobs/build.ts`), so that iterations do not wait for it. Both write the same bytes, and say
//! the same words (`fabricate/build_words`).
//!
//! # Two numeric factors
//!
//! The normal matrix is a [`sprs::CsMatI`], and `sprs-ldl` factors it up to
//! [`sparse::Factorization::MOST_SIMPLICIAL`] unknowns. It computes `L` column by column, which
//! suffices for small systems. In larger ones most columns of `L` have the same rows as their
//! neighbours: our own numeric phase computes such runs of columns (supernodes) as dense blocks in
//! 128-bit lanes, with the same pattern and order, about three times faster at 10,000 vertices
//! (`npm run bench -- --parts factors`). Both fill the same panels, so that an iteration costs the
//! same, and the same tests compare both with dense factors.
//!
//! # Notation of the paper, and its names here
//!
//! | paper | code |
//! |---|---|
//! | `C_i`, `P_i`, `n_i`, `w_i` | constraint, [`constraint::Projection::project`], `n`, `weight` |
//! | `V`, `V'`, `V*` | positions, rest positions (`rest`), the projection |
//! | `N_i` (Eq. 5) | mean-centring: `centre` |
//! | `phi` = `E_shape` (Eq. 4) | `energy.shape` |
//! | `Q`, `p`, `Q^T Q` (Eq. 6) | `Q` is never formed; `Q^T Q` is the normal matrix |
//! | step I, step II | local step, global step |
//! | `lambda_shape`, `lambda_close`, `lambda_smooth` (Eq. 13) | `weights.{shape, close, smooth}` |
//! | `c(v)` (Eq. 11) | closest point on the reference surface |
//! | `P_i` as a matrix (Eq. 8, 14) | `planar-similar`, and [`solve::Parametrization`] |
//! | `w_ij`, `l_i` (Eq. 12) | edge weight; the smoothed quantity, position or displacement |
//! | `e_p`, `e_c` (Fig. 5) | planarity and circularity error: mean squared distance |
//!
//! # Coverage of the paper
//!
//! See [`capabilities`].
//!
//! # Conventions
//!
//! Array shapes are written as `#V by 3`. Indices are 0-based except in file formats that count
//! from one. Lengths are in the units of the mesh. Energies, gradients and positions are `f64`. The
//! solver uses only `+ - * / sqrt` and, for angles, `libm`, so that native and wasm builds give the
//! same bits.

#[cfg(feature = "engine")]
pub mod constraint;
#[cfg(feature = "cli")]
pub mod experiment;
#[cfg(feature = "engine")]
pub mod fabricate;
#[cfg(feature = "engine")]
pub mod generate;
#[cfg(feature = "engine")]
mod json;
pub mod math;
#[cfg(feature = "engine")]
pub mod mesh;
#[cfg(feature = "engine")]
pub mod quads;
#[cfg(feature = "engine")]
pub mod scene;
#[cfg(feature = "engine")]
pub mod session;
#[cfg(feature = "engine")]
pub mod solve;
#[cfg(feature = "engine")]
pub mod sparse;
#[cfg(feature = "view")]
pub mod view;
#[cfg(all(target_arch = "wasm32", any(feature = "engine", feature = "view")))]
pub mod web;
#[cfg(feature = "engine")]
pub mod words;

#[cfg(doc)]
#[doc = include_str!("capabilities.md")]
pub mod capabilities {}
