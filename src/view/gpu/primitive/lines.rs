//! Draws edges, polylines, selected edges and seams, outlines of flipped faces, and the lines from handles
//! to targets: `shaders/lines.wgsl`.

use crate::view::appearance::LineKind;
use crate::view::gpu::{GpuTables, LINES, Layer, Recipe, VertexBuffer, build};
use crate::view::model::RenderMesh;
use crate::view::state::ViewState;

const LINE: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Uint32x2, 1 => Uint32];

/// Lines between entries of the table of positions.
#[derive(Debug)]
pub struct Lines {
    in_front: wgpu::RenderPipeline,
    behind: wgpu::RenderPipeline,
    /// The two ends of each line and its [`LineKind`].
    edges: VertexBuffer,
    curves: VertexBuffer,
    pulls: VertexBuffer,
    selected: VertexBuffer,
    flipped: VertexBuffer,
    /// Between bands of values.
    bands: VertexBuffer,
}

impl Lines {
    /// Creates the pipelines.
    pub fn new(device: &wgpu::Device, tables: &GpuTables, format: wgpu::TextureFormat) -> Lines {
        let pipeline = |fragment: &str, layer: Layer| {
            let recipe = Recipe {
                label: "lines",
                source: &LINES,
                vertex: "corner_of_line",
                fragment,
                attributes: &LINE,
                step: wgpu::VertexStepMode::Instance,
                layer,
            };
            build(device, tables, format, &recipe)
        };
        Lines {
            in_front: pipeline("in_front", Layer::InFront),
            behind: pipeline("behind", Layer::Behind),
            edges: VertexBuffer::new(device),
            curves: VertexBuffer::new(device),
            pulls: VertexBuffer::new(device),
            selected: VertexBuffer::new(device),
            flipped: VertexBuffer::new(device),
            bands: VertexBuffer::new(device),
        }
    }

    /// Uploads the edges and curves of a mesh.
    pub fn update_mesh(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, mesh: &RenderMesh) {
        self.edges.write(device, queue, &edge_lines(mesh));
        let curves: Vec<[u32; 3]> = mesh
            .curves
            .iter()
            .flat_map(|curve| curve.windows(2).map(|ends| line(ends[0], ends[1], LineKind::Curve)))
            .collect();
        self.curves.write(device, queue, &curves);
    }

    /// Uploads the edges between faces in different bands.
    pub fn update_bands(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, state: &ViewState) {
        let appearance = state.appearance();
        let seams = state.mesh().seams().filter(|_| appearance.bands().is_some());
        let parting = seams.filter(|(_, faces)| {
            let [a, b] = faces.map(|face| appearance.band_of(face));
            a.is_some() && b.is_some() && a != b
        });
        let bands: Vec<[u32; 3]> = parting.map(|([a, b], _)| line(a, b, LineKind::Band)).collect();
        self.bands.write(device, queue, &bands);
    }

    /// Uploads the seams of a paper model, over them the selected edges, and the measuring tape.
    pub fn update_marks(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, state: &ViewState) {
        let of_kind =
            |edges: &[[u32; 2]], kind| edges.iter().map(|&[a, b]| line(a, b, kind)).collect();
        let appearance = state.appearance();
        let mut selected: Vec<[u32; 3]> = of_kind(&appearance.seams, LineKind::Seam);
        selected.append(&mut of_kind(&appearance.selected_edges, LineKind::Selected));
        if let &[from, to] = state.tape() {
            selected.push(line(from, to, LineKind::Tape));
        }
        self.selected.write(device, queue, &selected);
    }

    /// Uploads the sides of the faces that the flat map `map` flips.
    pub fn update_map(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, map: &ViewState) {
        let sides = map.flipped().iter();
        let flipped: Vec<[u32; 3]> = sides.map(|&[a, b]| line(a, b, LineKind::Flipped)).collect();
        self.flipped.write(device, queue, &flipped);
    }

    /// Uploads the handles; their targets come after the vertices in the table of positions.
    pub fn update_handles(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        state: &ViewState,
    ) {
        let first = state.counts().0 as u32;
        let pulls: Vec<[u32; 3]> = state
            .handles()
            .iter()
            .zip(first..)
            .map(|(handle, target)| line(handle.vertex, target, LineKind::Pull))
            .collect();
        self.pulls.write(device, queue, &pulls);
    }

    /// Draws the curves, the lines between bands and, if requested, the edges.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, edges: bool) {
        if edges {
            self.edges.draw_each(pass, &self.in_front, 6);
        }
        self.curves.draw_each(pass, &self.in_front, 6);
        self.bands.draw_each(pass, &self.in_front, 6);
    }

    /// Draws the flat map: the edges, if requested, and the outlines of the faces that it flips. It has
    /// no place for curves beside the surface.
    pub fn draw_map(&self, pass: &mut wgpu::RenderPass<'_>, edges: bool) {
        if edges {
            self.edges.draw_each(pass, &self.in_front, 6);
        }
        self.flipped.draw_each(pass, &self.in_front, 6);
    }

    /// Draws other lines where visible; the first `through` of them also dim where hidden.
    pub fn draw_others(&self, pass: &mut wgpu::RenderPass<'_>, lines: &VertexBuffer, through: u32) {
        lines.draw_first(pass, &self.behind, 6, through);
        lines.draw_each(pass, &self.in_front, 6);
    }

    /// Draws seams, selected edges, the tape and the pull lines: dim where hidden, then where visible.
    pub fn draw_marks(&self, pass: &mut wgpu::RenderPass<'_>) {
        for lines in [&self.selected, &self.pulls] {
            self.draw_others(pass, lines, lines.count());
        }
    }
}

fn line(from: u32, to: u32, kind: LineKind) -> [u32; 3] {
    [from, to, kind as u32]
}

/// Returns the edges, inner ones first, so that the heavier boundary is drawn over them.
fn edge_lines(mesh: &RenderMesh) -> Vec<[u32; 3]> {
    let kinds = [(false, LineKind::Edge), (true, LineKind::Boundary)];
    kinds
        .into_iter()
        .flat_map(|(boundary, kind)| {
            let chosen = mesh.edges.iter().filter(move |edge| edge.boundary == boundary);
            chosen.map(move |edge| line(edge.ends[0], edge.ends[1], kind))
        })
        .collect()
}
