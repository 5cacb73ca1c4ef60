//! The shaders of the primitives, each as a list of source files.
//!
//! Shared declarations are in `shaders/scene.wgsl`, lines of constant width in
//! `shaders/stroke.wgsl`, depths in textures in `shaders/depth.wgsl`.

const SCENE: &str = include_str!("shaders/scene.wgsl");
const STROKE: &str = include_str!("shaders/stroke.wgsl");
const DEPTH: &str = include_str!("shaders/depth.wgsl");

/// The background.
pub const BACKDROP: [&str; 2] = [SCENE, include_str!("shaders/backdrop.wgsl")];
/// Lit faces.
pub const FACES: [&str; 3] = [SCENE, DEPTH, include_str!("shaders/faces.wgsl")];
/// Ambient occlusion.
pub const OCCLUSION: [&str; 3] = [SCENE, DEPTH, include_str!("shaders/occlusion.wgsl")];
/// Edges, curves, pull lines.
pub const LINES: [&str; 3] = [SCENE, STROKE, include_str!("shaders/lines.wgsl")];
/// Outlines of projected shapes, and arrows to projected points.
pub const PROJECTIONS: [&str; 3] = [SCENE, STROKE, include_str!("shaders/projections.wgsl")];
/// Dots.
pub const POINTS: [&str; 2] = [SCENE, include_str!("shaders/points.wgsl")];
/// Fitted circles.
pub const CIRCLES: [&str; 3] = [SCENE, STROKE, include_str!("shaders/circles.wgsl")];
/// The gizmo.
pub const GIZMO: [&str; 2] = [SCENE, include_str!("shaders/gizmo.wgsl")];
/// Fitted spheres.
pub const SPHERES: [&str; 2] = [SCENE, include_str!("shaders/spheres.wgsl")];

#[cfg(test)]
mod tests {
    use super::*;
    use naga::back::glsl;
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    fn all() -> [(&'static str, String); 9] {
        [
            ("backdrop", BACKDROP.concat()),
            ("faces", FACES.concat()),
            ("occlusion", OCCLUSION.concat()),
            ("lines", LINES.concat()),
            ("projections", PROJECTIONS.concat()),
            ("points", POINTS.concat()),
            ("circles", CIRCLES.concat()),
            ("gizmo", GIZMO.concat()),
            ("spheres", SPHERES.concat()),
        ]
    }

    fn validated(name: &str, source: &str) -> (naga::Module, naga::valid::ModuleInfo) {
        let module = naga::front::wgsl::parse_str(source)
            .unwrap_or_else(|e| panic!("{name}: {}", e.emit_to_string(source)));
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        let info = validator.validate(&module).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        (module, info)
    }

    #[test]
    fn every_shader_is_valid() {
        for (name, source) in all() {
            let (module, _) = validated(name, &source);
            assert!(module.entry_points.len() >= 2, "{name}");
        }
    }

    /// WebGL2 uses GLSL ES 3.00, which cannot express everything that WGSL can.
    #[test]
    fn every_shader_can_be_said_in_webgl2() {
        let options = glsl::Options {
            version: glsl::Version::Embedded { version: 300, is_webgl: true },
            ..Default::default()
        };
        for (name, source) in all() {
            let (module, info) = validated(name, &source);
            for entry in &module.entry_points {
                let pipeline = glsl::PipelineOptions {
                    shader_stage: entry.stage,
                    entry_point: entry.name.clone(),
                    multiview: None,
                };
                let mut text = String::new();
                let bounds = naga::proc::BoundsCheckPolicies::default();
                glsl::Writer::new(&mut text, &module, &info, &options, &pipeline, bounds)
                    .and_then(|mut writer| writer.write())
                    .unwrap_or_else(|e| panic!("{name}, {}: {e}", entry.name));
                assert!(text.starts_with("#version 300 es"));
            }
        }
    }

    #[test]
    fn every_shader_file_is_part_of_a_shader() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/view/gpu/shaders");
        for file in std::fs::read_dir(folder).unwrap() {
            let text = std::fs::read_to_string(file.unwrap().path()).unwrap();
            assert!(all().iter().any(|(_, source)| source.contains(&text)));
        }
    }
}
