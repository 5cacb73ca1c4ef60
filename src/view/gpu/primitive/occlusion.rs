//! Computes the ambient occlusion of the faces in three passes at half the size of the picture:
//! `shaders/occlusion.wgsl`. [`super::Faces`] reads the result.

use super::faces::{CORNER_OF_FACE, Faces};
use crate::view::gpu::pipeline::{DEPTH_FORMAT, TEXTURE_FORMAT};
use crate::view::gpu::{GpuTables, Layer, OCCLUSION, Onto, Recipe, build_onto};

/// Maximum side of the textures: occlusion varies slowly.
const LONGEST: u32 = 2048;

/// The passes and their textures.
#[derive(Debug)]
pub struct Occlusion {
    layout: wgpu::BindGroupLayout,
    depths: wgpu::RenderPipeline,
    gathered: wgpu::RenderPipeline,
    smoothed: wgpu::RenderPipeline,
    textures: Textures,
}

/// The textures that the passes draw to.
#[derive(Debug)]
struct Textures {
    size: (u32, u32),
    depth: wgpu::TextureView,
    /// Depths and normals, gathered occlusion, smoothed occlusion.
    passes: [wgpu::TextureView; 3],
    /// The bind groups for reading each of them.
    groups: [wgpu::BindGroup; 3],
}

impl Occlusion {
    /// Creates the passes; nothing is computed yet.
    pub fn new(device: &wgpu::Device, tables: &GpuTables) -> Occlusion {
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("occlusion passes"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                count: None,
            }],
        });
        let seen = Recipe {
            label: "occlusion",
            source: &OCCLUSION,
            vertex: "corner_of_depth",
            fragment: "depth_and_normal",
            attributes: &CORNER_OF_FACE,
            step: wgpu::VertexStepMode::Vertex,
            layer: Layer::Surface,
        };
        let over = |fragment: &str| {
            let (vertex, layer) = ("corner_of_screen", Layer::Over);
            let recipe = Recipe { vertex, fragment, attributes: &[], layer, ..seen };
            build_onto(device, &[Some(tables.layout()), Some(&layout)], Onto::Texture, &recipe)
        };
        Occlusion {
            depths: build_onto(device, &[Some(tables.layout())], Onto::Texture, &seen),
            gathered: over("gathered"),
            smoothed: over("smoothed"),
            textures: Textures::new(device, &layout, (1, 1)),
            layout,
        }
    }

    /// Returns the layout of the bind group of the result.
    pub fn layout(&self) -> &wgpu::BindGroupLayout {
        &self.layout
    }

    /// Returns the bind group of the result, for drawing the faces.
    pub fn group(&self) -> &wgpu::BindGroup {
        &self.textures.groups[2]
    }

    /// Computes the occlusion of the faces for a picture of this size in pixels.
    pub fn find(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        tables: &GpuTables,
        faces: &Faces,
        (width, height): (u32, u32),
    ) {
        let part = (f64::from(LONGEST) / f64::from(width.max(height))).min(0.5);
        let size = [width, height].map(|side| ((f64::from(side) * part).round() as u32).max(1));
        if (size[0], size[1]) != self.textures.size {
            self.textures = Textures::new(device, &self.layout, (size[0], size[1]));
        }
        let Textures { depth, passes, groups, .. } = &self.textures;
        {
            let mut pass = begin(encoder, &passes[0], Some(depth));
            pass.set_bind_group(0, tables.group(), &[]);
            faces.draw_with(&mut pass, &self.depths);
        }
        for (pipeline, i) in [(&self.gathered, 0), (&self.smoothed, 1)] {
            let mut pass = begin(encoder, &passes[i + 1], None);
            pass.set_bind_group(0, tables.group(), &[]);
            pass.set_bind_group(1, &groups[i], &[]);
            pass.set_pipeline(pipeline);
            pass.draw(0..3, 0..1);
        }
    }
}

impl Textures {
    fn new(
        device: &wgpu::Device,
        layout: &wgpu::BindGroupLayout,
        (width, height): (u32, u32),
    ) -> Textures {
        let texture = |format: wgpu::TextureFormat, usage: wgpu::TextureUsages| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some("occlusion passes"),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let passes =
            [(); 3].map(|()| texture(TEXTURE_FORMAT, wgpu::TextureUsages::TEXTURE_BINDING));
        let groups = [0, 1, 2].map(|i| {
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("occlusion passes"),
                layout,
                entries: &[wgpu::BindGroupEntry {
                    binding: 0,
                    resource: wgpu::BindingResource::TextureView(&passes[i]),
                }],
            })
        });
        let depth = texture(DEPTH_FORMAT, wgpu::TextureUsages::empty());
        Textures { size: (width, height), depth, passes, groups }
    }
}

/// Begins a pass onto a texture, which is cleared to empty.
fn begin<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    view: &wgpu::TextureView,
    depth: Option<&wgpu::TextureView>,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("occlusion"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::WHITE),
                store: wgpu::StoreOp::Store,
            },
        })],
        depth_stencil_attachment: depth.map(|view| wgpu::RenderPassDepthStencilAttachment {
            view,
            depth_ops: Some(wgpu::Operations {
                load: wgpu::LoadOp::Clear(1.0),
                store: wgpu::StoreOp::Discard,
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}
