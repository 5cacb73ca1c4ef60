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
//! file  ->  mesh  ->  constraint  ->  solve  ->  scene  ->  session  ->  positions  ->  view
//! ```
//!
//! A file becomes a mesh; a scene says which constraints hold there, and is made the problem that the
//! solver iterates; a session does that for a host (the page, the command line), which draws or writes
//! the positions. Each stage depends only on those to its left; [`view`] receives positions and index
//! buffers, never the solver. `tests/rooms.rs` enforces the dependencies of this table: a room may use
//! any item of the rooms that it knows of.
//!
//! | room | contents | knows of |
//! |---|---|---|
//! | [`math`] | vectors in SIMD lanes and of the plane, eigenvectors, closest rotations, fitted circles and spheres; on nalgebra, dense matrices of any size | nothing |
//! | [`words`] | words for readers: numbers, units, lengths, counts, lists | nothing |
//! | `json` | what `serde_json` lacks: errors with paths in our words, repeated keys, lists of indices | nothing |
//! | [`mesh`] | polygon mesh, reading and writing of files, topology, Laplacian, closest point, error measures | math, words |
//! | [`constraint`] | one projection operator per file, the list of kinds, selectors, batches | math, words, json, mesh |
//! | [`sparse`] | `L D L^T` on the types of sprs: ordering, symbolic analysis, two numeric factors, triangular sweeps | math |
//! | [`quads`] | quads along the lines of curvature: cross field, seamless map, exact extraction | math, words, mesh, sparse |
//! | [`solve`] | energies, assembly, the two-step iteration, accelerators, conformal maps | math, mesh, constraint, sparse |
//! | [`scene`] | the scene file: serde types, validation, and the optimisation problem that it defines | math, words, json, mesh, constraint, sparse, solve |
//! | [`fabricate`] | parts to cut: panels on sheets, offsets, the build check, files for machines | math, words, mesh, sparse, scene |
//! | [`session`] | the interface of all hosts: load, edit, drag, step, undo, report | all above |
//! | [`generate`] | new meshes: by kind and sizes, from a plan, or between curves; the example scenes and their meshes | math, words, json, mesh, constraint, sparse, quads, scene, session |
//! | [`experiment`] | the paper's comparisons with other methods (Fig. 10, 11), for the command line | all above |
//! | [`view`] | wgpu: camera, picking, faces, edges, handles, fitted shapes | math |
//! | `web` | wasm-bindgen interfaces: of the solver's worker (`web/worker`), of the second worker (`web/jobs`), of the view (`web/page`), and of words for the page (`web/words`) | all above |
//!
//! `src/bin` is outside: the command line, which drives sessions.
//!
//! The methods of [`experiment`] are gradient descent, quasi-Newton without a metric, and a penalty
//! method with Gauss-Newton. It drives sessions as a host does.
//!
//! # What is stable
//!
//! What the programs in `tests/library` use of [`mesh`], [`scene`], [`session`], [`solve`], [`quads`] and
//! [`fabricate`], and the scene file, the command line and its reports, change only with the major
//! version; while that is 0, with the second number. All else is public for the command line, the page
//! and the tests, and may change with any version.
//!
//! # The page
//!
//! `www` is in TypeScript. Its rooms, from the lowest, and which may import which, are in
//! `.scripts/rooms.mjs`:
//!
//! | room | contents |
//! |---|---|
//! | `ui` | components, controls, dialogs, plots, which know no state |
//! | `solver` | the page's side of the two workers, and the types of what crosses |
//! | `worker` | the workers: one iterates (`solver-worker`, `scheduler`), a second instance of the engine does what takes long (`jobs-worker`) |
//! | `store` | the state of the page, and the actions, which alone change it |
//! | `viewport` | the canvas: frames to the view, pointer, keys and touch |
//! | `documents` | files, links, saved works, examples |
//! | `panels` | the contents of the steps |
//! | `docked` | what a panel beside the view is |
//! | `features` | what is done with a model, each by itself: make panels, build, export, lessons |
//! | `app` | wires them; header, steps, menus and keys |
//! | `pages` | the other pages: gallery, Rhino, teaching, speed, what is checked, licences |
//!
//! The page is five steps: open or make, shape, move, check, build and share. `www/index.html` has them
//! before any script runs, `www/app/steps.ts` opens and closes them, and `www/app/app.tsx` lists what
//! fills them: components of Preact, which read `store.state` and are rendered again when what they
//! read has changed (`www/store/state.ts`). Every command has a name, by which the palette finds it
//! (`www/app/command-table.ts`).
//!
//! The page calls the solver's worker in three ways (`www/solver/solver-client.ts`): `tell` for commands
//! without an answer, `change` for what changes the model, one after another, and `ask` for questions.
//! What they may be is in `www/worker/interface.ts`.
//!
//! Numbers, lengths and counts are written by a small module of Rust on the page's own thread
//! (`www/ui/words.ts`, [`words`]); what imports it waits until it is there.
//!
//! The address of the page takes `?renderer=webgl2` or `webgpu`, which otherwise the view chooses, and
//! `?embed` for a frame in another page, with `&autoplay`, `&panel=model` (the steps), `&measure=` and
//! the id of a measure, `&theme=light` or `dark`. A shared model is in its fragment, with positions
//! rounded to a hundredth of the tolerance.
//!
//! # One drag
//!
//! 1. `www/viewport/input/pointer.ts` asks the view for the handle under the pointer
//!    (`view/state/pick`) and for the target to which a motion of the pointer leads
//!    (`view/state/gizmo_drag`); `www/store/handles.ts` tells it to the worker.
//! 2. The worker keeps the latest target until its next slice of time (`www/worker/scheduler.ts`), then
//!    calls `drag` (`web/worker/solver`), and that `Session::drag_through` (`session/dragging`), which checks
//!    it and passes it to `Solver::move_handles` (`solve/solver/handles`): no matrix changes. What leads
//!    back to the state before the drag is kept in `session/undo/transaction`.
//! 3. Energies, gradients and projections are computed for it, and `Session::step` (`session/iterating`)
//!    calls `Solver::step` (`solve/solver/step`), which begins with the global step.
//!    - Global step: `solve::system` applies the inverse of the normal matrix, by triangular sweeps through
//!      the factor of [`sparse`]; `solve::accelerate` improves the step, or falls back to it.
//!    - Local step: each batch of constraints projects its points (`constraint/batch` and
//!      `constraint/kinds`).
//!    - `solve::energy` sums energies and gradients of shape, closeness, smoothness and handles.
//! 4. The worker copies the positions to the page, which passes them to `view::state`; `view::gpu`
//!    draws.
//! 5. The end of the drag records it as one step of undo (`session/undo/history`); where constraints are
//!    hard, a run follows that meets them.
//!
//! # One run
//!
//! 1. [`mesh`] reads a file, or [`scene`] a scene and its mesh. `Session::open` (`session/load`)
//!    validates the scene against the mesh and resolves the selectors (`session/state/rows`).
//! 2. `Solver::new` assembles the normal matrix (`solve::assemble`); [`sparse`] orders and factors it.
//! 3. `Session::begin_run` (`session/dragging`, since a drag is one too), then `Session::step` until it
//!    reports the end: converged, or after as many iterations as the scene allows. Where constraints are
//!    hard, `solve/exact` then meets them (`session/run/meeting`), by one attempt after another
//!    (`session/searching`, `session/run/attempts`) until a shape is good by the measure of
//!    `session/run/shape_measure`. A press for panels tries all of them, and at last larger tolerances
//!    (`session/run/easing`).
//! 4. `Session::end_run` keeps the iterate of least energy, or the best shape for the hard
//!    constraints, and records the run as one step of undo; if it has collapsed the shape, that is told
//!    (`session/run/collapse`). The scene names the attempt that found it
//!    ([`scene::ChosenAttempt`]), so that every host gets the same shape from it.
//! 5. `Session::report` measures the shape (`mesh/measure`). Verdicts on it are questions of their own
//!    (`session/queries`): after a press for panels `Session::verdict` (worded in
//!    `session/report/verdict_words`), after another run `Session::run_verdict`
//!    (`session/report/run_verdict`), of hard constraints `session/report/exact_words`. `session/export`
//!    writes OBJ or the scene.
//!
//! # Other ways through the rooms
//!
//! - The text of a scene: `session/opened_file` tells what a file is; `Scene::from_json`
//!   (`scene/json/file`) gives the typed [`scene::Scene`] or an error with its JSON path, `Scene::validate`
//!   (`scene/validate`, for `session/load`) checks it against the mesh, and `scene/document` makes the
//!   [`solve::Problem`] of it (for `session/state/solved_scene`).
//! - A setting of Build: a field of [`scene::BuildSettings`] and its declaration in
//!   [`scene::BUILD_SETTINGS`], of which hosts make their forms and options. The edit `SetBuild`
//!   stores it in the scene; the page's second worker passes it to `web::jobs::build`, which calls
//!   [`fabricate::Build::new`]. A kerf, for instance, is applied to outlines in `fabricate/cutting`, to
//!   those of paper in `fabricate/paper/kerf`, to holes in `fabricate/holes` and to slots in
//!   `fabricate/discs` and `fabricate/paper/tongue`; `fabricate/file/drawing` draws them, and
//!   `fabricate/output` writes the files.
//! - A question of the page: a method in `web/worker`, such as `verdict` in `web/worker/questions`, whose
//!   TypeScript types tsify and wasm-bindgen write; and its use in the page, `actions.ask.verdict()`. What
//!   takes long is a method in `web/jobs`, such as `ModelCopy::forecast` on a copy of the model, and its
//!   use in `www/store/trials.ts`, `copy(model).forecast()`. Nothing stands between: the calls cross by name
//!   (`www/solver/remote.ts`).
//! - An edit of the page: a variant of [`session::Edit`], whose TypeScript type is generated, and its
//!   effect in `session/edit/apply`. The page calls `actions.edit({ removeSet: { name } })`; what is no
//!   field of the variant is refused.
//! - A setting of the solver: a declaration in [`session::SETTINGS`]. Hosts build their controls from
//!   that list.
//! - An operator: a file in `constraint/kinds` with its closed form, which may be one of [`math`] (that of a
//!   circle is `math/circle_fit`), and a line in the list there. See [`constraint`].
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
//! | `C_i`, `P_i`, `n_i`, `w_i` | constraint, [`constraint::Projection::project`], which tries the closed form of the kind first, `n`, `weight` |
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
//! # Terms
//!
//! | term | means |
//! |---|---|
//! | host | what uses a session: the page, the command line, a test |
//! | panel | a face of the mesh, as a part that is built |
//! | original, in the code rest shape | the mesh as opened, to which closeness and smoothness refer |
//! | handle | vertices that are pulled to targets |
//! | fixed | of handles that stay at their targets exactly |
//! | tolerance | the distance up to which a panel, or another element, is as it shall be |
//! | row | constraints of one kind that a selector makes: one line of the list on the page |
//! | hard | of constraints that are met within a length, or exactly, instead of being weighed |
//! | satisfied, in the code met | within the length that is required |
//! | press | making all panels circular or flat, by one button: a row of hard constraints and a run |
//! | attempt | one way to meet hard constraints; a run tries several |
//! | relaxed tolerance, in the code eased | a larger tolerance for some panels, where no shape within the required one can be built |
//! | estimate, in the code forecast | said before a press: how far it will move the mesh |
//! | suggestion | an edit that helps, tried before it is offered |
//! | front | the side of a face that its normal points to; the back is bluish in the view |
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
#[cfg(target_arch = "wasm32")]
pub mod web;
pub mod words;

#[cfg(doc)]
#[doc = include_str!("capabilities/overview.md")]
pub mod capabilities {
    /// The picture of an example once it is solved, as the gallery shows it: from the files of the project,
    /// for documentation that is opened where it was made.
    macro_rules! picture {
        ($example:literal) => {
            concat!(
                "\n\n<img alt=\"The example ",
                $example,
                ", solved\" src=\"file://",
                env!("CARGO_MANIFEST_DIR"),
                "/www/pictures/",
                $example,
                "-end.webp\">"
            )
        };
    }

    #[doc = include_str!("capabilities/solver.md")]
    #[doc = picture!("lesson-what-a-projection-is")]
    pub mod solver {}

    #[doc = include_str!("capabilities/operators.md")]
    #[doc = picture!("fig-04-squares")]
    #[doc = picture!("hypar")]
    pub mod operators {}

    #[doc = include_str!("capabilities/energies.md")]
    #[doc = picture!("fig-05-planar")]
    pub mod energies {}

    #[doc = include_str!("capabilities/meshes.md")]
    #[doc = picture!("fig-05-circular")]
    #[doc = picture!("fig-05-mixed")]
    #[doc = picture!("fig-06-web")]
    #[doc = picture!("fig-06-exploration")]
    #[doc = picture!("fig-07-quality")]
    #[doc = picture!("fig-08-similar-blocks")]
    #[doc = picture!("points-pavilion")]
    pub mod meshes {}

    #[doc = include_str!("capabilities/maps.md")]
    #[doc = picture!("fig-09-polygons")]
    pub mod maps {}

    #[doc = include_str!("capabilities/results.md")]
    #[doc = picture!("fig-10-random")]
    #[doc = picture!("fig-11-strip")]
    #[doc = picture!("limits-choice")]
    #[doc = picture!("other-spline")]
    #[doc = picture!("other-strips")]
    pub mod results {}
}
