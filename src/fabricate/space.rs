//! A build in space: everything as objects on layers, for CAD programs (panels, offset, beams, node
//! axes, and the sheets at their real size beside the shape); the shape with its offset, and its fins and
//! node discs or else its beams, as one file for presentations; and as groups of one mesh in the unit and
//! the coordinates of the model.

use crate::fabricate::beam::Prism;
use crate::fabricate::build::Build;
use crate::fabricate::file::{Drawing, GlbLayer, GlbPart, glb};
use crate::fabricate::panel::triangles_in_space;
use crate::fabricate::sheet::Role;
use crate::fabricate::surface::{Edge, distinct};
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Group, GroupKeyword, Mesh};
use crate::scene::Product;
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

/// A body, a surface or a polygon in space, about the centre of the shape, in the unit of the mesh.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// The name of its part; may be empty.
    pub name: String,
    /// Its points.
    pub points: Vec<Vec3<f64>>,
    /// Its faces over the points, counterclockwise seen from outside.
    pub faces: Vec<Vec<u32>>,
}

impl Body {
    /// A single polygon.
    fn polygon(name: String, points: Vec<Vec3<f64>>) -> Body {
        let faces = vec![(0..points.len() as u32).collect()];
        Body { name, points, faces }
    }

    /// The corners of each of its faces.
    fn polygons(&self) -> impl Iterator<Item = Vec<Vec3<f64>>> {
        self.faces.iter().map(|face| face.iter().map(|&v| self.points[v as usize]).collect())
    }

    /// Its faces, those with more than four corners or a notch as triangles.
    fn filled(&self) -> Vec<Vec<u32>> {
        let mut found = Vec::new();
        for (face, corners) in self.faces.iter().zip(self.polygons()) {
            let outside = twice_vector_area(corners.iter().copied());
            let n = corners.len();
            let turns_left = |k: usize| {
                let [a, b, c] = [k, k + 1, k + 2].map(|k| corners[k % n]);
                (b - a).cross(c - b).dot(outside) >= 0.0
            };
            if n <= 4 && (0..n).all(turns_left) {
                found.push(face.clone());
                continue;
            }
            let triangles = triangles_in_space(&corners).into_iter();
            found.extend(triangles.map(|own| own.map(|k| face[k]).to_vec()));
        }
        found
    }
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
        let line = |layer: &str, colour, name: &str, points: &[Vec3<f64>]| SpatialPart {
            layer: layer.to_owned(),
            colour,
            name: name.to_owned(),
            points: points.iter().map(|&point| turned(point)).collect(),
            faces: Vec::new(),
            closed: false,
        };
        let solid = |layer: &str, colour, body: &Body| SpatialPart {
            faces: body.filled(),
            ..line(layer, colour, &body.name, &body.points)
        };
        let (grey, violet, brown, blue) =
            ([110, 110, 115], [90, 50, 165], [115, 75, 45], [0, 90, 160]);
        let below = self.moved("", 0.0);
        let mut parts = vec![solid("Surface", grey, &below)];
        for (own, f) in self.panels().iter().zip(0..) {
            parts.extend(surface.rings(f).into_iter().map(|ring| {
                let corners: Vec<Vec3<f64>> = ring.into_iter().map(|k| own.points[k]).collect();
                SpatialPart { closed: true, ..line("Panels", grey, &own.name, &corners) }
            }));
        }
        if self.offset.is_some() {
            let above = self.moved("", self.distance());
            parts.push(solid("Offset", violet, &above));
            for (v, ends) in self.nodes().into_iter().zip(below.points.iter().zip(&above.points)) {
                if ends.0 != ends.1 {
                    parts.push(line("Nodes", blue, &self.node_name(v), &[*ends.0, *ends.1]));
                }
            }
        }
        let [fins, discs] = self.plates();
        for (layer, bodies) in [("Beams", self.prisms()), ("Fins", fins), ("Discs", discs)] {
            parts.extend(bodies.iter().map(|own| solid(layer, brown, own)));
        }
        let beside = parts.iter().flat_map(|part| &part.points);
        let (mut right, mut low) = (f64::NEG_INFINITY, [f64::INFINITY; 2]);
        for [x, y, z] in beside {
            (right, low) = (right.max(*x), [low[0].min(*y), low[1].min(*z)]);
        }
        parts.extend(self.sheets_from([right, low[0], low[1]]));
        parts
    }

    /// The vertices of panels. To other vertices belongs nothing that is built, and one far away would
    /// move what is laid beside the shape.
    fn nodes(&self) -> Vec<u32> {
        distinct(self.surface.faces.indices().iter().copied())
    }

    /// All panels as one surface over their vertices, which are moved this far along their axes.
    fn moved(&self, name: &str, by: f64) -> Body {
        let (surface, nodes) = (&self.surface, self.nodes());
        let mut place = vec![0; surface.positions.len()];
        nodes.iter().zip(0..).for_each(|(&v, k)| place[v as usize] = k);
        let faces = surface.faces.iter();
        let faces = faces.map(|face| face.iter().map(|&v| place[v as usize]).collect()).collect();
        let axis = |v: u32| match &self.offset {
            Some((axes, _)) => axes.axes[v as usize],
            None => Vec3::zero(),
        };
        let points = nodes.iter().map(|&v| surface.at(v) + axis(v) * by).collect();
        Body { name: name.to_owned(), points, faces }
    }

    /// Each panel.
    fn panels(&self) -> Vec<Body> {
        let whole = self.moved("", 0.0);
        let panels = whole.polygons().zip(&self.names);
        panels.map(|(corners, name)| Body::polygon(name.clone(), corners)).collect()
    }

    /// The beams as prisms; none if no beams are made.
    fn prisms(&self) -> Vec<Body> {
        let prisms = self.frame.iter().flat_map(|frame| &frame.prisms);
        let all = self.surface.edges.iter().zip(prisms);
        let body = |(edge, prism): (&Edge, &Option<Prism>)| {
            let (name, points) = (self.beam_name(edge.ends), prism.as_ref()?.corners.to_vec());
            Some(Body { name, points, faces: Prism::faces() })
        };
        all.filter_map(body).collect()
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
/// by part. Names of panels are then at points, of which nothing is drawn.
const NAMED_PANELS: usize = 2000;

impl Build {
    /// Writes panels, offset panels and, between them, fins and node discs or else flat beams as binary
    /// glTF, in metres about the centre of the bounding box: by name unless there are more than
    /// `NAMED_PANELS` panels. Nodes are named points. `z_up` is whether z is up in the mesh; else y is.
    pub fn presentation(&self, z_up: bool) -> Vec<u8> {
        let is_named = self.names.len() <= NAMED_PANELS;
        let metres = self.unit.metres;
        let layer = |name, colour, bodies: Vec<Body>| {
            let mut parts = vec![GlbPart::named(name)];
            for body in bodies {
                if is_named && !body.name.is_empty() {
                    parts.push(GlbPart::named(&body.name));
                }
                let part = parts.last_mut().expect("there is the first");
                for corners in body.polygons() {
                    part.add_polygon(&corners.iter().map(|&at| at * metres).collect::<Vec<_>>());
                }
            }
            GlbLayer { name, colour, parts, points: Vec::new() }
        };
        let mut layers = vec![layer("panels", [0.80, 0.81, 0.83, 1.0], self.panels())];
        if let Some((axes, _)) = &self.offset {
            let by = self.distance();
            layers.push(layer("offset", [0.35, 0.20, 0.65, 0.35], vec![self.moved("", by)]));
            let below = |v: u32| self.surface.at(v);
            let above = |v: u32| below(v) + axes.axes[v as usize] * by;
            let [fins, discs] = self.plates();
            // Plates have the beams within them.
            if fins.is_empty() && discs.is_empty() {
                let beam = |[i, j]: [u32; 2]| {
                    let corners = vec![below(i), below(j), above(j), above(i)];
                    Body::polygon(self.beam_name([i, j]), corners)
                };
                let beams = self.surface.beams().map(|(edge, _)| beam(edge.ends));
                layers.push(layer("beams", BROWN, beams.collect()));
            }
            layers.extend([layer("fins", BROWN, fins), layer("discs", LIGHT, discs)]);
        }
        let point =
            |name: String, at: Vec3<f64>| (name, <[f64; 3]>::from(at * metres).map(|x| x as f32));
        if !is_named {
            let middle = |face: &[u32]| {
                let sum = face.iter().fold(Vec3::zero(), |sum, &v| sum + self.surface.at(v));
                sum * (1.0 / face.len() as f64)
            };
            let middles = self.surface.faces.iter().map(middle).zip(&self.names);
            layers[0].points = middles.map(|(at, name)| point(name.clone(), at)).collect();
        }
        let nodes = self.nodes().into_iter();
        let points = nodes.map(|v| point(self.node_name(v), self.surface.at(v))).collect();
        layers.push(GlbLayer { name: "nodes", points, ..GlbLayer::default() });
        glb(&layers, z_up)
    }
}

/// The panels by their names, over the nodes in the order of their numbers; none with fins, whose beams
/// are a file with panels.
pub(in crate::fabricate) fn named_panels(build: &Build) -> Option<Mesh> {
    let surface = &build.surface;
    let at = |point: &Vec3<f64>| <[f64; 3]>::from(*point + surface.centre);
    (build.settings.product != Product::Fins).then(|| Mesh {
        positions: surface.positions.iter().map(at).collect(),
        faces: surface.faces.clone(),
        groups: (0..).zip(&build.names).map(|(face, name)| group(name, vec![face])).collect(),
        ..Mesh::default()
    })
}

/// Panels and their offset, together and each panel by its name, and every prism by its name; none if no
/// beams are made.
pub(in crate::fabricate) fn solids(build: &Build) -> Option<Mesh> {
    build.offset.as_ref().filter(|_| build.frame.is_some())?;
    let bodies = [build.moved("panels", 0.0), build.moved("offset", build.distance())];
    let mut mesh = joined(bodies.into_iter().chain(build.prisms()), build.surface.centre);
    // The faces of the panels are the first ones of the mesh.
    let panels = (0..).zip(&build.names).map(|(face, name)| group(name, vec![face]));
    mesh.groups.splice(1..1, panels);
    Some(mesh)
}

/// All fins and node discs as plates; none without discs.
pub(in crate::fabricate) fn assembled(build: &Build) -> Option<Mesh> {
    let mesh = joined(build.plates().into_iter().flatten(), build.surface.centre);
    (!mesh.faces.is_empty()).then_some(mesh)
}

/// Bodies as one mesh, each as a group of its name.
fn joined(bodies: impl Iterator<Item = Body>, centre: Vec3<f64>) -> Mesh {
    let mut mesh = Mesh::default();
    for Body { name, points, faces } in bodies {
        let (first, first_face) = (mesh.positions.len() as u32, mesh.faces.len() as u32);
        mesh.positions.extend(points.iter().map(|&point| <[f64; 3]>::from(point + centre)));
        for face in faces {
            mesh.faces.push(&face.iter().map(|v| v + first).collect::<Vec<_>>());
        }
        mesh.groups.push(group(&name, (first_face..mesh.faces.len() as u32).collect()));
    }
    mesh
}

fn group(name: &str, faces: Vec<u32>) -> Group {
    Group { name: name.to_owned(), keyword: GroupKeyword::Group, faces, curves: Vec::new() }
}
