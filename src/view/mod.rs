//! The picture: camera, picking, and one primitive per file with its shader. Sees positions and
//! index buffers, never the solver.
//!
//! The room has two halves. [`stage`] and what it holds know the mesh as it is shown, the camera,
//! and what is picked or marked; they need no GPU, so that native tests can hold them to account.
//! `picture` and the primitives turn a stage into draw calls; they are compiled for the browser only.
//! `still` writes a stage as SVG, for a page that cannot draw yet, `thumbnail`
//! writes small ones for the gallery.
//!
//! | file | holds |
//! |---|---|
//! | `stage` | everything that a picture shows, and what has changed since the last one |
//! | `lists`, `subject`, `triangulate`, `normals`, `polygon_edges` | the mesh as it is shown |
//! | `camera`, `framing`, `flight`, `kept_camera` | where it is looked at from, and the way from there to elsewhere |
//! | `picking`, `ray`, `region`, `depth_map` | what is under the cursor, inside an outline, in front |
//! | `gizmo`, `gizmo_shape`, `grip` | handles that the pointer takes hold of |
//! | `looks`, `colour_map`, `colour_scale`, `bands`, `row_colours`, `light`, `palette` | colours of faces and of all else |
//! | `projections` | where constraints want their vertices |
//! | `surroundings`, `ground`, `tape`, `scale_bar`, `round_length` | what is about the mesh, and how large it is |
//! | `flat_map`, `checks`, `split` | two pictures on one canvas |
//! | `still`, `thumbnail` | pictures as SVG |
//! | `picture`, `pane`, `device`, `loss`, `canvas_size` | the GPU: from a stage to a canvas |
//! | `store`, `globals`, `shaders`, `pipeline` | what shaders read, and what runs them |
//! | `faces`, `lines`, `points`, `circles`, `spheres`, `projection_lines`, `projected_faces`, `surrounding_lines`, `gizmo_marks` | the primitives, each with its shader |
//!
//! Positions come in as `f64` in file coordinates. The view subtracts its own centre, the middle
//! of the first bounding box of the mesh, before it rounds to `f32`: a mesh at site coordinates
//! neither jitters nor loses digits.

pub mod bands;
pub mod camera;
pub mod canvas_size;
pub mod checks;
#[cfg(target_arch = "wasm32")]
pub mod circles;
pub mod colour_map;
pub mod colour_scale;
pub mod depth_map;
#[cfg(target_arch = "wasm32")]
pub mod device;
#[cfg(target_arch = "wasm32")]
pub mod faces;
pub mod flat_map;
pub mod flight;
pub mod framing;
pub mod gizmo;
#[cfg(target_arch = "wasm32")]
pub mod gizmo_marks;
pub mod gizmo_shape;
pub mod globals;
pub mod grip;
pub mod ground;
pub mod kept_camera;
pub mod light;
#[cfg(target_arch = "wasm32")]
pub mod lines;
pub mod lists;
pub mod looks;
pub mod loss;
pub mod normals;
pub mod palette;
#[cfg(target_arch = "wasm32")]
pub mod pane;
pub mod picking;
#[cfg(target_arch = "wasm32")]
pub mod picture;
#[cfg(target_arch = "wasm32")]
pub mod pipeline;
#[cfg(target_arch = "wasm32")]
pub mod points;
pub mod polygon_edges;
pub mod projected_faces;
#[cfg(target_arch = "wasm32")]
pub mod projection_lines;
pub mod projections;
pub mod ray;
pub mod region;
pub mod round_length;
pub mod row_colours;
pub mod scale_bar;
pub mod shaders;
#[cfg(target_arch = "wasm32")]
pub mod spheres;
pub mod split;
pub mod stage;
pub mod still;
#[cfg(target_arch = "wasm32")]
pub mod store;
pub mod subject;
#[cfg(target_arch = "wasm32")]
pub mod surrounding_lines;
pub mod surroundings;
pub mod tape;
pub mod thumbnail;
pub mod triangulate;
