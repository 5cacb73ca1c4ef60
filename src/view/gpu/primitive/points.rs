//! Draws vertices, marks, handles and targets as dots: `shaders/points.wgsl`.

use crate::view::appearance::DotKind;
use crate::view::gpu::{GpuTables, Layer, POINTS, Recipe, VertexBuffer, build};
use crate::view::state::ViewState;

const DOT: [wgpu::VertexAttribute; 1] = wgpu::vertex_attr_array![0 => Uint32x3];

/// Dots at entries of the table of positions.
#[derive(Debug)]
pub struct Points {
    in_front: wgpu::RenderPipeline,
    behind: wgpu::RenderPipeline,
    /// Index of each dot in the table of positions, its [`DotKind`], and the index of its colour.
    vertices: VertexBuffer,
    members: VertexBuffer,
    marks: VertexBuffer,
}

impl Points {
    /// Creates the pipelines.
    pub fn new(device: &wgpu::Device, tables: &GpuTables, format: wgpu::TextureFormat) -> Points {
        let pipeline = |fragment: &str, layer: Layer| {
            let recipe = Recipe {
                label: "points",
                source: &POINTS,
                vertex: "corner_of_dot",
                fragment,
                attributes: &DOT,
                step: wgpu::VertexStepMode::Instance,
                layer,
            };
            build(device, tables, format, &recipe)
        };
        Points {
            in_front: pipeline("in_front", Layer::InFront),
            behind: pipeline("behind", Layer::Behind),
            vertices: VertexBuffer::new(device),
            members: VertexBuffer::new(device),
            marks: VertexBuffer::new(device),
        }
    }

    /// Uploads the vertices of a mesh.
    pub fn update_mesh(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, state: &ViewState) {
        let count = state.counts().0 as u32;
        let dots: Vec<[u32; 3]> = (0..count).map(|v| dot(v, DotKind::Vertex)).collect();
        self.vertices.write(device, queue, &dots);
    }

    /// Uploads marks and handles.
    pub fn update_marks(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, state: &ViewState) {
        let rows = &state.appearance().rows;
        let members: Vec<[u32; 3]> =
            rows.dots().map(|(v, colour)| [v, DotKind::Member as u32, u32::from(colour)]).collect();
        self.members.write(device, queue, &members);
        self.marks.write(device, queue, &marks(state));
    }

    /// Draws a dot on every visible vertex.
    pub fn draw_vertices(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.vertices.draw_each(pass, &self.in_front, 6);
    }

    /// Draws visible members of constraints, then marks and handles: first hidden ones dim, then
    /// visible ones.
    pub fn draw_marks(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.members.draw_each(pass, &self.in_front, 6);
        self.marks.draw_each(pass, &self.behind, 6);
        self.marks.draw_each(pass, &self.in_front, 6);
    }
}

fn dot(point: u32, kind: DotKind) -> [u32; 3] {
    [point, kind as u32, 0]
}

/// Returns the marks, least important first: later dots cover earlier ones. Targets come after the
/// vertices in the table of positions.
fn marks(state: &ViewState) -> Vec<[u32; 3]> {
    let appearance = state.appearance();
    let tinted = appearance.tinted_dots().iter();
    let mut dots: Vec<[u32; 3]> = tinted.map(|&v| dot(v, DotKind::Tinted)).collect();
    dots.extend(appearance.selected_vertices.iter().map(|&v| dot(v, DotKind::Selected)));
    let first = state.counts().0 as u32;
    let soft = state.handles().iter().zip(first..).filter(|(h, _)| h.kind != DotKind::Fixed);
    dots.extend(soft.map(|(_, target)| dot(target, DotKind::Target)));
    for kind in [DotKind::Fixed, DotKind::Handle, DotKind::Active] {
        let handles = state.handles().iter().filter(|handle| handle.kind == kind);
        dots.extend(handles.map(|handle| dot(handle.vertex, kind)));
    }
    let chosen = state.handles().iter().filter(|handle| appearance.is_selected(handle.vertex));
    dots.extend(chosen.map(|handle| dot(handle.vertex, DotKind::Chosen)));
    dots.extend(state.tape().iter().map(|&end| dot(end, DotKind::Tape)));
    dots
}
