//! A build in space: everything as objects on layers, for CAD programs (panels, offset, beams, node
//! axes, and the sheets at their real size beside the shape); the shape with its offset and beams
//! as one file for presentations; and as groups of one mesh in the unit and the coordinates of the
//! model.

use crate::fabricate::beam::Prism;
use crate::fabricate::build::Build;
use crate::fabricate::file::{Drawing, GlbLayer, GlbPart, glb};
use crate::fabricate::panel::triangles_in_space;
use crate::fabricate::plates::Solid;
use crate::fabricate::sheet::Role;
use crate::fabricate::surface::{PanelSurface, beam_name, distinct, node_name};
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Group, GroupKeyword, Mesh};
use serde::Serialize;

/// An object on a layer, in the unit of the mesh; z is up.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct SpatialPart {
    /// The name of its layer.
    pub layer: String,
    /// The colour of the layer: red, green, blue.
    pub colour: [u8; 3],
    /// Its name; may be empty.
    pub name: String,
    /// Its points.
    pub points: Vec<[f64; 3]>,
    /// Its faces over the points, counterclockwise seen from outside; empty for a line. Faces that a
    /// program could fill wrongly are triangles: those with more than four corners or a notch.
    pub faces: Vec<Vec<u32>>,
    /// Whether a line leads back to its first point, which is not repeated.
    pub closed: bool,
}

/// The vertices of panels, and the panels over these alone. To other vertices belongs nothing that is
/// built, and one far away would move what is laid beside the shape.
fn used(surface: &PanelSurface) -> (Vec<u32>, Vec<Vec<u32>>) {
    let used = distinct(surface.faces.indices().iter().copied());
    let mut place = vec![0; surface.positions.len()];
    used.iter().zip(0..).for_each(|(&v, k)| place[v as usize] = k);
    let faces = surface.faces.iter();
    let faces = faces.map(|face| face.iter().map(|&v| place[v as usize]).collect()).collect();
    (used, faces)
}

/// Faces, those with more than four corners or a notch as triangles.
fn filled(faces: &[Vec<u32>], points: &[Vec3<f64>]) -> Vec<Vec<u32>> {
    let mut found = Vec::new();
    for face in faces {
        let corners: Vec<Vec3<f64>> = face.iter().map(|&v| points[v as usize]).collect();
        let outside = twice_vector_area(corners.iter().copied());
        let n = corners.len();
        let turns_left = |k: usize| {
            let [a, b, c] = [k, k + 1, k + 2].map(|k| corners[k % n]);
            (b - a).cross(c - b).dot(outside) >= 0.0
        };
        match n <= 4 && (0..n).all(turns_left) {
            true => found.push(face.clone()),
            false => found.extend(
                triangles_in_space(&corners).into_iter().map(|own| own.map(|k| face[k]).into()),
            ),
        }
    }
    found
}

/// Distance of sheets from the shape and from each other, as a fraction of their width.
const BESIDE: f64 = 0.1;

impl Build {
    /// All objects, rotated so that z is up. `z_up` is whether z is up in the mesh; else y is.
    pub fn spatial_parts(&self, z_up: bool) -> Vec<SpatialPart> {
        let surface = &self.surface;
        let turned = |point: Vec3<f64>| -> [f64; 3] {
            let [x, y, z] = (point + surface.centre).into();
            if z_up { [x, y, z] } else { [x, -z, y] }
        };
        let on = |layer: &str, colour, name: &str, points: &[Vec3<f64>]| SpatialPart {
            layer: layer.to_owned(),
            colour,
            name: name.to_owned(),
            points: points.iter().map(|&point| turned(point)).collect(),
            faces: Vec::new(),
            closed: false,
        };
        let (used, faces) = used(surface);
        let below: Vec<Vec3<f64>> = used.iter().map(|&v| surface.at(v)).collect();
        let (grey, violet, brown, blue) =
            ([110, 110, 115], [90, 50, 165], [115, 75, 45], [0, 90, 160]);
        let mut parts =
            vec![SpatialPart { faces: filled(&faces, &below), ..on("Surface", grey, "", &below) }];
        for (face, name) in surface.faces.iter().zip(&self.names) {
            let corners: Vec<_> = face.iter().map(|&v| surface.at(v)).collect();
            parts.push(SpatialPart { closed: true, ..on("Panels", grey, name, &corners) });
        }
        if let Some((axes, _)) = &self.offset {
            let moved = |&v: &u32| surface.at(v) + axes.axes[v as usize] * self.distance();
            let above: Vec<_> = used.iter().map(moved).collect();
            let own = on("Offset", violet, "", &above);
            parts.push(SpatialPart { faces: filled(&faces, &above), ..own });
            for (&v, (&low, &high)) in used.iter().zip(below.iter().zip(&above)) {
                if low != high {
                    parts.push(on("Nodes", blue, &node_name(v), &[low, high]));
                }
            }
        }
        for (name, prism) in self.prisms() {
            let own = on("Beams", brown, &name, &prism.corners);
            let faces = filled(&Prism::faces(), &prism.corners);
            parts.push(SpatialPart { faces, ..own });
        }
        for (layer, plates) in ["Fins", "Discs"].into_iter().zip(self.plates()) {
            parts.extend(plates.into_iter().map(|own| {
                let placed = on(layer, brown, &own.name, &own.points);
                SpatialPart { faces: own.faces, ..placed }
            }));
        }
        let beside = parts.iter().flat_map(|part| &part.points);
        let (mut right, mut low) = (f64::NEG_INFINITY, [f64::INFINITY; 2]);
        for [x, y, z] in beside {
            (right, low) = (right.max(*x), [low[0].min(*y), low[1].min(*z)]);
        }
        parts.extend(self.sheets_from([right, low[0], low[1]]));
        parts
    }

    /// The beams as solids, with their names; none if no beams are made.
    fn prisms(&self) -> impl Iterator<Item = (String, &Prism)> {
        let prisms = self.frame.iter().flat_map(|frame| &frame.prisms);
        let all = self.surface.edges.iter().zip(prisms);
        all.filter_map(|(edge, prism)| Some((beam_name(edge.ends), prism.as_ref()?)))
    }

    /// The lines of all sheets as they are cut, at their real size, side by side to the right of this
    /// point.
    fn sheets_from(&self, [right, front, ground]: [f64; 3]) -> Vec<SpatialPart> {
        let of_mm = 1.0 / self.mm_of_building();
        let mut parts = Vec::new();
        let mut left = right;
        for drawing in self.drawings().into_iter().map(Drawing::cut_once) {
            left += BESIDE * drawing.size[0] * of_mm;
            for line in &drawing.lines {
                let put = |&[x, y]: &[f64; 2]| [left + x * of_mm, front + y * of_mm, ground];
                let title = if line.role == Role::Sheet { &drawing.name } else { &line.part };
                parts.push(SpatialPart {
                    layer: format!("Sheets {}", line.role.layer()),
                    colour: line.role.rgb(),
                    name: title.clone(),
                    points: line.points.iter().map(put).collect(),
                    faces: Vec::new(),
                    closed: line.closed,
                });
            }
            left += drawing.size[0] * of_mm;
        }
        parts
    }
}

/// The name of the file.
pub const PRESENTATION: &str = "model.glb";

/// The colours of fins and of node discs in a presentation: red, green, blue and opacity, linear.
const BROWN: [f32; 4] = [0.45, 0.30, 0.18, 1.0];
const LIGHT: [f32; 4] = [0.70, 0.55, 0.36, 1.0];

/// Of more panels, each layer of a presentation is one part: viewers, also those of telephones, draw part
/// by part.
const NAMED_PANELS: usize = 2000;

impl Build {
    /// Writes panels, offset panels and flat beams between them as binary glTF, in metres about the
    /// centre of the bounding box: panels and beams by their names, up to a number. `z_up` is whether z
    /// is up in the mesh; else y is.
    pub fn presentation(&self, z_up: bool) -> Vec<u8> {
        let is_named = self.names.len() <= NAMED_PANELS;
        let layer = |name, colour, polygons: Vec<(String, Vec<Vec3<f64>>)>| {
            let mut parts = vec![GlbPart::named(name)];
            for (own, corners) in polygons {
                if is_named && !own.is_empty() {
                    parts.push(GlbPart::named(&own));
                }
                parts.last_mut().expect("there is the first").add_polygon(&corners);
            }
            GlbLayer { name, colour, parts }
        };
        let metres = self.unit.metres;
        let surface = &self.surface;
        let below = |v: u32| surface.at(v) * metres;
        let panels = self.names.iter().cloned().zip(surface.faces.iter());
        let panels = panels.map(|(name, face)| (name, face.iter().map(|&v| below(v)).collect()));
        let mut layers = vec![layer("panels", [0.80, 0.81, 0.83, 1.0], panels.collect())];
        if let Some((axes, _)) = &self.offset {
            let by = self.distance() * metres;
            let above = |v: u32| -> Vec3<f64> { below(v) + axes.axes[v as usize] * by };
            let panels = surface.faces.iter();
            let panels =
                panels.map(|face| (String::new(), face.iter().map(|&v| above(v)).collect()));
            layers.push(layer("offset", [0.35, 0.20, 0.65, 0.35], panels.collect()));
            let beams = surface.beams().map(|(edge, _)| edge.ends);
            let beams = beams
                .map(|[i, j]| (beam_name([i, j]), vec![below(i), below(j), above(j), above(i)]));
            let plates = self.plates();
            // Plates have the beams within them.
            if plates.iter().all(Vec::is_empty) {
                layers.push(layer("beams", BROWN, beams.collect()));
            }
            for ((name, colour), own) in [("fins", BROWN), ("discs", LIGHT)].into_iter().zip(plates)
            {
                let of_plate = |plate: Solid| {
                    let corners = |face: &Vec<u32>| -> Vec<Vec3<f64>> {
                        face.iter().map(|&v| plate.points[v as usize] * metres).collect()
                    };
                    // Only the first face of a part has its name.
                    let names =
                        std::iter::once(plate.name.clone()).chain(std::iter::repeat(String::new()));
                    names.zip(plate.faces.iter().map(corners)).collect::<Vec<_>>()
                };
                layers.push(layer(name, colour, own.into_iter().flat_map(of_plate).collect()));
            }
        }
        glb(&layers, z_up)
    }
}

/// Panels and their offset, together and each panel by its name, and every prism by its name; none if no
/// beams are made.
pub(in crate::fabricate) fn solids(build: &Build) -> Option<Mesh> {
    let (axes, _) = build.offset.as_ref().filter(|_| build.frame.is_some())?;
    let mut mesh = Mesh::default();
    let (used, faces) = used(&build.surface);
    let moved = |by: f64| -> Vec<Vec3<f64>> {
        used.iter().map(|&v| build.surface.at(v) + axes.axes[v as usize] * by).collect()
    };
    let centre = build.surface.centre;
    add(&mut mesh, "panels", &moved(0.0), centre, faces.clone());
    // The faces of the panels are the first ones of the mesh.
    mesh.groups.extend((0..).zip(&build.names).map(|(face, name)| group(name, vec![face])));
    add(&mut mesh, "offset", &moved(build.distance()), centre, faces);
    for (name, prism) in build.prisms() {
        add(&mut mesh, &name, &prism.corners, centre, Prism::faces());
    }
    Some(mesh)
}

/// All fins and node discs as plates; none without discs.
pub(in crate::fabricate) fn assembled(build: &Build) -> Option<Mesh> {
    let mut mesh = Mesh::default();
    for Solid { name, points, faces } in build.plates().into_iter().flatten() {
        add(&mut mesh, &name, &points, build.surface.centre, faces);
    }
    (!mesh.faces.is_empty()).then_some(mesh)
}

fn add(
    mesh: &mut Mesh,
    name: &str,
    points: &[Vec3<f64>],
    centre: Vec3<f64>,
    faces: impl IntoIterator<Item = Vec<u32>>,
) {
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(points.iter().map(|&point| <[f64; 3]>::from(point + centre)));
    let first_face = mesh.faces.len() as u32;
    for face in faces {
        mesh.faces.push(&face.iter().map(|v| v + first).collect::<Vec<_>>());
    }
    mesh.groups.push(group(name, (first_face..mesh.faces.len() as u32).collect()));
}

fn group(name: &str, faces: Vec<u32>) -> Group {
    Group { name: name.to_owned(), keyword: GroupKeyword::Group, faces, curves: Vec::new() }
}
