//! Creates the pipeline of a primitive from its shader, and growable vertex buffers.

use super::gpu_tables::GpuTables;

/// Samples per pixel.
pub const SAMPLES: u32 = 4;
/// Format of the depth buffer.
pub const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

/// Depth test and blending of a primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// Opaque, with a depth bias so that lines on it are visible; WebGPU biases only triangles.
    Surface,
    /// Blended where nothing is in front, with a larger bias than a surface: where both coincide,
    /// the surface is seen and nothing flickers.
    Veil,
    /// Blended where nothing is in front.
    InFront,
    /// Blended where something is in front.
    Behind,
    /// Blended, over everything.
    Over,
}

/// The target of a pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Onto {
    /// The picture, in the format of its canvas, with several samples per pixel.
    Picture(wgpu::TextureFormat),
    /// A texture of [`TEXTURE_FORMAT`] for later passes; only a surface uses a depth buffer with it.
    Texture,
}

/// Format of intermediate results: four bytes, which every device can render to.
pub const TEXTURE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// The description of a primitive's pipeline.
#[derive(Clone, Copy, Debug)]
pub struct Recipe<'a> {
    /// The primitive's name.
    pub label: &'a str,
    /// The parts of the shader source.
    pub source: &'a [&'a str],
    /// Vertex entry point.
    pub vertex: &'a str,
    /// Fragment entry point.
    pub fragment: &'a str,
    /// Vertex attributes, one after another without gaps.
    pub attributes: &'a [wgpu::VertexAttribute],
    /// Per vertex or per instance.
    pub step: wgpu::VertexStepMode,
    /// Depth and blending.
    pub layer: Layer,
}

/// Creates a pipeline that draws triangles from both sides onto the picture and reads the tables.
pub fn build(
    device: &wgpu::Device,
    tables: &GpuTables,
    format: wgpu::TextureFormat,
    recipe: &Recipe<'_>,
) -> wgpu::RenderPipeline {
    build_onto(device, &[Some(tables.layout())], Onto::Picture(format), recipe)
}

/// Creates a pipeline that draws triangles from both sides, with bind groups of these layouts.
pub fn build_onto(
    device: &wgpu::Device,
    groups: &[Option<&wgpu::BindGroupLayout>],
    onto: Onto,
    recipe: &Recipe<'_>,
) -> wgpu::RenderPipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(recipe.label),
        source: wgpu::ShaderSource::Wgsl(recipe.source.concat().into()),
    });
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(recipe.label),
        bind_group_layouts: groups,
        immediate_size: 0,
    });
    let surface = recipe.layer == Layer::Surface;
    let bias = match recipe.layer {
        Layer::Surface => wgpu::DepthBiasState { constant: 2, slope_scale: 1.5, clamp: 0.0 },
        Layer::Veil => wgpu::DepthBiasState { constant: 8, slope_scale: 3.0, clamp: 0.0 },
        Layer::InFront | Layer::Behind | Layer::Over => wgpu::DepthBiasState::default(),
    };
    let compare = match recipe.layer {
        Layer::Surface | Layer::Veil | Layer::InFront => wgpu::CompareFunction::LessEqual,
        Layer::Behind => wgpu::CompareFunction::Greater,
        Layer::Over => wgpu::CompareFunction::Always,
    };
    let (format, samples) = match onto {
        Onto::Picture(format) => (format, SAMPLES),
        Onto::Texture => (TEXTURE_FORMAT, 1),
    };
    let depth = wgpu::DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(surface),
        depth_compare: Some(compare),
        stencil: wgpu::StencilState::default(),
        bias,
    };
    let vertex_buffers = [Some(wgpu::VertexBufferLayout {
        array_stride: recipe.attributes.iter().map(|attribute| attribute.format.size()).sum(),
        step_mode: recipe.step,
        attributes: recipe.attributes,
    })];
    let has_vertices = !recipe.attributes.is_empty();
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(recipe.label),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some(recipe.vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: if has_vertices { &vertex_buffers } else { &[] },
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: (samples > 1 || surface).then_some(depth),
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some(recipe.fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format,
                blend: (!surface).then_some(wgpu::BlendState::ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::COLOR,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// A vertex buffer that grows.
#[derive(Debug)]
pub struct VertexBuffer {
    buffer: wgpu::Buffer,
    count: u32,
}

impl VertexBuffer {
    /// Creates an empty buffer.
    pub fn new(device: &wgpu::Device) -> VertexBuffer {
        VertexBuffer { buffer: Self::create(device, 256), count: 0 }
    }

    fn create(device: &wgpu::Device, size: u64) -> wgpu::Buffer {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("vertices"),
            size,
            usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    }

    /// Replaces all elements.
    pub fn write<T: bytemuck::NoUninit>(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        elements: &[T],
    ) {
        let bytes: &[u8] = bytemuck::cast_slice(elements);
        self.count = elements.len() as u32;
        if bytes.len() as u64 > self.buffer.size() {
            self.buffer = Self::create(device, (bytes.len() as u64).next_power_of_two());
        }
        if !bytes.is_empty() {
            queue.write_buffer(&self.buffer, 0, bytes);
        }
    }

    /// Returns the number of elements.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Draws triangles whose corners are the elements.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline) {
        if self.count > 0 {
            pass.set_pipeline(pipeline);
            pass.set_vertex_buffer(0, self.buffer.slice(..));
            pass.draw(0..self.count, 0..1);
        }
    }

    /// Draws each element as an instance of `corners` corners of triangles.
    pub fn draw_each(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipeline: &wgpu::RenderPipeline,
        corners: u32,
    ) {
        self.draw_first(pass, pipeline, corners, self.count);
    }

    /// As [`VertexBuffer::draw_each`], for the first `count` elements only.
    pub fn draw_first(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipeline: &wgpu::RenderPipeline,
        corners: u32,
        count: u32,
    ) {
        if count > 0 {
            pass.set_pipeline(pipeline);
            pass.set_vertex_buffer(0, self.buffer.slice(..));
            pass.draw(0..corners, 0..count);
        }
    }
}
