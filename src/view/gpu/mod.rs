//! Draws view states on a canvas with wgpu. Browser only, except what native tests check.
//!
//! | file | holds |
//! |---|---|
//! | `renderer` | draws a view |
//! | `device` | adapter, device and surface |
//! | `loss` | notification that a device was lost |
//! | `placement` | the position of a picture, or of a tile of it, on the canvas, and the size of that |
//! | `gpu_tables` | buffers and textures that shaders read |
//! | `globals` | the uniform block of all shaders |
//! | `shaders` | the sources of the shaders |
//! | `pipeline` | render pipelines |
//! | `primitive` | the drawing primitives, one file for each kind |

#[cfg(target_arch = "wasm32")]
pub mod device;
pub mod globals;
#[cfg(target_arch = "wasm32")]
pub mod gpu_tables;
pub mod loss;
#[cfg(target_arch = "wasm32")]
pub mod pipeline;
pub mod placement;
#[cfg(target_arch = "wasm32")]
pub mod primitive;
#[cfg(target_arch = "wasm32")]
pub mod renderer;
pub mod shaders;

#[cfg(target_arch = "wasm32")]
pub use device::{Device, DeviceError};
#[cfg(target_arch = "wasm32")]
pub use gpu_tables::GpuTables;
pub use loss::Loss;
#[cfg(target_arch = "wasm32")]
pub use pipeline::{Layer, Onto, Recipe, VertexBuffer, build, build_onto};
pub use placement::Placement;
#[cfg(target_arch = "wasm32")]
pub use renderer::Renderer;
pub use shaders::{
    BACKDROP, CIRCLES, FACES, GIZMO, LINES, OCCLUSION, POINTS, PROJECTIONS, SPHERES,
};
