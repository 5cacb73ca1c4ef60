//! Tables from which shaders read, with four numbers per vertex or face. They are textures because
//! WebGL2 has no storage buffers. Each is written in one call, in whole rows, because the number of
//! calls costs time, not their size.

use super::globals::{NUMBERS, numbers};
use super::placement::Placement;
use crate::view::appearance::{Colour, ColourMap, TEXELS, row_colours};
use crate::view::state::ViewState;
use glam::{Vec3, Vec4};

/// Texels in a row of a table; the shaders use the same constant.
const WIDTH: u32 = 1024;

/// A growable table.
#[derive(Debug)]
struct Table {
    texture: wgpu::Texture,
    label: &'static str,
}

impl Table {
    fn new(device: &wgpu::Device, label: &'static str, format: wgpu::TextureFormat) -> Table {
        Table { texture: create(device, label, format, WIDTH, 1), label }
    }

    fn holds(&self, count: usize) -> bool {
        count <= (WIDTH * self.texture.height()) as usize
    }

    /// Writes all texels; returns whether the texture was replaced.
    fn write<T: bytemuck::Pod>(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        texels: Vec<T>,
    ) -> bool {
        let rows = (size_of_val(&texels[..]) as u32).div_ceil(self.row_bytes()).max(1);
        let grown = rows > self.texture.height();
        if grown {
            // An extra row, so that a few more handles do not need a new texture each time.
            let format = self.texture.format();
            self.texture = create(device, self.label, format, WIDTH, rows + 1);
        }
        self.write_rows(queue, 0, texels);
        grown
    }

    /// Writes texels from the start of a row on. The rest of their last row is filled with zeros.
    fn write_rows<T: bytemuck::Pod>(&self, queue: &wgpu::Queue, first: u32, mut texels: Vec<T>) {
        let row_bytes = self.row_bytes();
        let row = row_bytes as usize / size_of::<T>();
        let rows = texels.len().div_ceil(row);
        texels.resize(rows * row, T::zeroed());
        let bytes = bytemuck::cast_slice(&texels);
        write(queue, &self.texture, bytes, row_bytes, [first, WIDTH, rows as u32]);
    }

    fn row_bytes(&self) -> u32 {
        let texel = self.texture.format().block_copy_size(None);
        WIDTH * texel.expect("tables have plain colour formats")
    }
}

fn create(
    device: &wgpu::Device,
    label: &str,
    format: wgpu::TextureFormat,
    width: u32,
    height: u32,
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

fn write(
    queue: &wgpu::Queue,
    texture: &wgpu::Texture,
    bytes: &[u8],
    row_bytes: u32,
    [first, width, height]: [u32; 3],
) {
    if width == 0 || height == 0 {
        return;
    }
    queue.write_texture(
        wgpu::TexelCopyTextureInfo {
            texture,
            mip_level: 0,
            origin: wgpu::Origin3d { x: 0, y: first, z: 0 },
            aspect: wgpu::TextureAspect::All,
        },
        bytes,
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(row_bytes),
            rows_per_image: Some(height),
        },
        wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
    );
}

/// All data that the shaders read, bound as one group.
#[derive(Debug)]
pub struct GpuTables {
    globals: wgpu::Buffer,
    positions: Table,
    vertex_normals: Table,
    face_normals: Table,
    face_looks: Table,
    colour_map: wgpu::Texture,
    /// The map in row 0 of `colour_map`.
    full_map: ColourMap,
    uv: Table,
    layout: wgpu::BindGroupLayout,
    group: wgpu::BindGroup,
}

impl GpuTables {
    /// Creates empty tables.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> GpuTables {
        GpuTables::with_layout(device, queue, group_layout(device))
    }

    /// Creates empty tables for another view, which the same pipelines can read.
    pub fn beside(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> GpuTables {
        GpuTables::with_layout(device, queue, self.layout.clone())
    }

    fn with_layout(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layout: wgpu::BindGroupLayout,
    ) -> GpuTables {
        let float = wgpu::TextureFormat::Rgba32Float;
        let bytes = wgpu::TextureFormat::Rgba8Unorm;
        let globals = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("globals"),
            size: (NUMBERS * size_of::<f32>()) as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let texels = TEXELS as u32;
        let colours = create(device, "colour maps", bytes, texels, 4);
        for (row, map) in [(0, ColourMap::Viridis), (3, ColourMap::Beyond)] {
            write(queue, &colours, &map.texels(), texels * 4, [row, texels, 1]);
        }
        let positions = Table::new(device, "positions", float);
        let vertex_normals = Table::new(device, "vertex normals", float);
        let face_normals = Table::new(device, "face normals", float);
        let face_looks = Table::new(device, "face appearance", bytes);
        let uv = Table::new(device, "texture coordinates", float);
        let textures = [
            &positions.texture,
            &vertex_normals.texture,
            &face_normals.texture,
            &face_looks.texture,
            &colours,
            &uv.texture,
        ];
        let group = bind(device, &layout, &globals, textures);
        GpuTables {
            globals,
            positions,
            vertex_normals,
            face_normals,
            face_looks,
            colour_map: colours,
            full_map: ColourMap::Viridis,
            uv,
            layout,
            group,
        }
    }

    /// Returns the layout of the bind group.
    pub fn layout(&self) -> &wgpu::BindGroupLayout {
        &self.layout
    }

    /// Returns the bind group.
    pub fn group(&self) -> &wgpu::BindGroup {
        &self.group
    }

    /// Writes what has changed in the state, and always the globals, for a picture at `placement`.
    pub fn update(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        state: &ViewState,
        placement: Placement,
    ) {
        let changes = state.changes();
        let mesh = state.mesh();
        let mut rebind = false;
        let corners = changes.appearance && state.appearance().corner_steps().is_some();
        let vertices_changed = changes.mesh || changes.positions || corners;
        if vertices_changed || changes.targets || changes.projections {
            let vertices = mesh.positions.len();
            let count = vertices + state.handles().len() + state.projections().points.len();
            if vertices_changed || !self.positions.holds(count) {
                rebind |= self.positions.write(device, queue, points(state, 0));
            } else {
                // Only the part after the vertices.
                let row = vertices as u32 / WIDTH;
                self.positions.write_rows(queue, row, points(state, (row * WIDTH) as usize));
            }
        }
        if changes.mesh || changes.positions {
            let normals = &mesh.normals;
            let soft = four_each(normals.vertices.iter().map(|normal| normal.extend(0.0)));
            rebind |= self.vertex_normals.write(device, queue, soft);
            let flat = four_each(normals.faces.iter().map(|normal| normal.extend(0.0)));
            rebind |= self.face_normals.write(device, queue, flat);
        }
        if changes.mesh || changes.appearance {
            let appearance = state.appearance().bytes(mesh.faces.len());
            rebind |= self.face_looks.write(device, queue, appearance);
            let map = state.appearance().map();
            if map != ColourMap::Beyond && map != self.full_map {
                self.full_map = map;
                let width = TEXELS as u32;
                write(queue, &self.colour_map, &map.texels(), width * 4, [0, width, 1]);
            }
        }
        if changes.mesh || changes.marks {
            self.write_colours(queue, 1, &state.appearance().rows.palette);
        }
        if changes.mesh || changes.checks {
            let uv = state.checks().uv.iter();
            let texels = four_each(uv.map(|uv| uv.extend(0.0).extend(0.0)));
            rebind |= self.uv.write(device, queue, texels);
        }
        if changes.projections {
            self.write_colours(queue, 2, &state.projections().palette);
        }
        if rebind {
            self.bind(device);
        }
        let numbers = numbers(state, state.palette().ghost, placement);
        queue.write_buffer(&self.globals, 0, bytemuck::cast_slice(&numbers));
    }

    /// Writes points in place of those of the mesh, and the globals with a veil of this colour.
    pub fn update_points(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        state: &ViewState,
        points: Option<Vec<Vec3>>,
        veil: Colour,
        placement: Placement,
    ) {
        let points =
            points.map(|points| four_each(points.into_iter().map(|point| point.extend(0.0))));
        if points.is_some_and(|points| self.positions.write(device, queue, points)) {
            self.bind(device);
        }
        let numbers = numbers(state, veil, placement);
        queue.write_buffer(&self.globals, 0, bytemuck::cast_slice(&numbers));
    }

    fn bind(&mut self, device: &wgpu::Device) {
        let textures = [
            &self.positions.texture,
            &self.vertex_normals.texture,
            &self.face_normals.texture,
            &self.face_looks.texture,
            &self.colour_map,
            &self.uv.texture,
        ];
        self.group = bind(device, &self.layout, &self.globals, textures);
    }

    /// Writes a palette of rows of constraints into a row of the colour texture.
    fn write_colours(&self, queue: &wgpu::Queue, row: u32, palette: &[[f32; 3]]) {
        let width = TEXELS as u32;
        let texels = row_colours::texels(palette, TEXELS);
        write(queue, &self.colour_map, &texels, width * 4, [row, width, 1]);
    }
}

/// Returns the table of positions from a vertex on: vertices, targets of handles, projected points.
fn points(state: &ViewState, first: usize) -> Vec<[f32; 4]> {
    let vertices = state.mesh().positions.iter().enumerate().skip(first);
    // Negated: shaders take the greater fourth number of a vertex and its projected point, which
    // must be the distance of the projected point.
    let vertices = vertices.map(|(v, at)| at.extend(-state.appearance().corner_in_steps(v)));
    let targets = state.targets().map(|place| place.extend(0.0));
    four_each(vertices.chain(targets).chain(state.projected()))
}

fn four_each(vectors: impl Iterator<Item = Vec4>) -> Vec<[f32; 4]> {
    vectors.map(|vector| vector.to_array()).collect()
}

fn group_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entry = |binding: u32, ty: wgpu::BindingType| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty,
        count: None,
    };
    let globals = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Uniform,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let table = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: false },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let entries: Vec<_> = (0..7).map(|i| entry(i, if i == 0 { globals } else { table })).collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("scene"),
        entries: &entries,
    })
}

fn bind(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    globals: &wgpu::Buffer,
    textures: [&wgpu::Texture; 6],
) -> wgpu::BindGroup {
    let views = textures.map(|t| t.create_view(&wgpu::TextureViewDescriptor::default()));
    let mut entries =
        vec![wgpu::BindGroupEntry { binding: 0, resource: globals.as_entire_binding() }];
    entries.extend(views.iter().zip(1..).map(|(view, binding)| wgpu::BindGroupEntry {
        binding,
        resource: wgpu::BindingResource::TextureView(view),
    }));
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("scene"),
        layout,
        entries: &entries,
    })
}
