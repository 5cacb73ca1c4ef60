//! From a shape to parts: an independent implementation, identities of offsets and panels, files
//! that are read back by other readers, and meshes that cannot be built.

mod assembly;
mod assembly_order;
mod bad_input;
mod beams;
mod check;
mod discs;
mod dxf;
mod expected;
mod facade;
mod files;
mod glb;
mod identities;
mod key;
mod nesting;
mod no_area;
mod paper;
mod picture;
mod printed;
mod report_page;
mod sheets;
mod space;
mod words;
mod workshop;

use shape_up::fabricate::offset::axes_of;
use shape_up::fabricate::{Build, PanelSurface, Stand};
use shape_up::math::Vec3;
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, OffsetKind};
use shape_up::words::{LengthUnit, UNITS};

/// Whether no file has a number that is none. The pages of a PDF are compressed.
pub(crate) fn without_nan(made: &Build) -> bool {
    let is_without = |text: &[u8]| !text.windows(3).any(|word| word == b"NaN");
    made.files(true).iter().all(|file| {
        if !file.name.ends_with(".pdf") {
            return is_without(&file.bytes);
        }
        let document = lopdf::Document::load_mem(&file.bytes).expect("it is PDF");
        document.get_pages().values().all(|page| {
            let content = document.get_page_content(*page);
            is_without(&content)
        })
    })
}

/// The content of the file of this name.
pub(crate) fn bytes_of(made: &Build, name: &str) -> Vec<u8> {
    made.files(true).into_iter().find(|file| file.name == name).expect("it is there").bytes
}

/// The text of the file of this name.
pub(crate) fn text_of(made: &Build, name: &str) -> String {
    String::from_utf8(bytes_of(made, name)).expect("it is text")
}

/// The unit of a mesh in metres.
pub(crate) fn metres() -> LengthUnit {
    UNITS[0]
}

/// A build of a mesh in metres.
pub(crate) fn build(mesh: &Mesh, settings: &BuildSettings) -> Build {
    Build::new(mesh, settings, metres(), &Stand::default()).expect("it can be built")
}

/// The least-squares axes: no tolerance lets the exact ones pass.
pub(crate) fn fit(surface: &PanelSurface, kind: OffsetKind, mu: f64) -> Vec<Vec3<f64>> {
    axes_of(surface, &[kind], mu, 1.0, -1.0).remove(0).axes
}

/// The axes of the exact pass.
pub(crate) fn exact(surface: &PanelSurface, kind: OffsetKind) -> Vec<Vec3<f64>> {
    let found = axes_of(surface, &[kind], 1.0, 1.0, f64::INFINITY).remove(0);
    assert_eq!(found.inexact, [], "{kind:?}");
    found.axes
}

/// Length of a vector in the plane.
fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}
