//! Adapter, device, and the canvas on which pictures appear.
//!
//! A canvas that has once provided a WebGPU context can never provide a WebGL one. Therefore the
//! WebGPU adapter and device are requested without a canvas, and the canvas is touched only when it
//! is certain which backend draws on it.

use super::loss::Loss;
use super::pipeline::{DEPTH_FORMAT, SAMPLES};
use super::placement::clamp_size;
use std::sync::Arc;

/// Device, queue and canvas.
#[derive(Debug)]
pub struct Device {
    /// Creates resources.
    pub device: wgpu::Device,
    /// Receives commands.
    pub queue: wgpu::Queue,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    colour: wgpu::TextureView,
    depth: wgpu::TextureView,
    loss: Arc<Loss>,
}

/// Why nothing can be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceError(pub String);

impl std::fmt::Display for DeviceError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for DeviceError {}

/// The frame that is being drawn.
#[derive(Debug)]
pub struct SurfaceFrame {
    texture: wgpu::SurfaceTexture,
    view: wgpu::TextureView,
}

type Opened = (wgpu::Instance, wgpu::Adapter, wgpu::Device, wgpu::Queue);

fn instance(backends: wgpu::Backends) -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    wgpu::Instance::new(descriptor)
}

async fn open(
    instance: wgpu::Instance,
    surface: Option<&wgpu::Surface<'static>>,
) -> Result<Opened, String> {
    let options = wgpu::RequestAdapterOptions { compatible_surface: surface, ..Default::default() };
    let adapter = instance.request_adapter(&options).await.map_err(|e| e.to_string())?;
    // The limits of WebGL2 suffice for both backends; only the canvas may be larger.
    let required_limits =
        wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
    let descriptor =
        wgpu::DeviceDescriptor { label: Some("view"), required_limits, ..Default::default() };
    let (device, queue) = adapter.request_device(&descriptor).await.map_err(|e| e.to_string())?;
    Ok((instance, adapter, device, queue))
}

impl Device {
    /// Opens a WebGPU device for the canvas. On failure the canvas is untouched.
    ///
    /// # Errors
    /// There is no adapter.
    #[cfg(feature = "view-webgpu")]
    pub async fn webgpu(target: wgpu::SurfaceTarget<'static>) -> Result<Device, DeviceError> {
        let opened = open(instance(wgpu::Backends::BROWSER_WEBGPU), None).await;
        let opened = opened.map_err(|e| DeviceError(format!("No WebGPU adapter: {e}")))?;
        let surface = opened.0.create_surface(target).map_err(|e| DeviceError(e.to_string()))?;
        Device::new(opened, surface)
    }

    /// Opens a WebGL2 device for the canvas.
    ///
    /// # Errors
    /// The canvas already has another context, or WebGL2 is not available.
    #[cfg(feature = "view-webgl2")]
    pub async fn webgl2(target: wgpu::SurfaceTarget<'static>) -> Result<Device, DeviceError> {
        let instance = instance(wgpu::Backends::GL);
        let failed = |e: String| DeviceError(format!("No WebGL2 context: {e}"));
        let surface = instance.create_surface(target).map_err(|e| failed(e.to_string()))?;
        let opened = open(instance, Some(&surface)).await.map_err(failed)?;
        Device::new(opened, surface)
    }

    fn new(
        (_, adapter, device, queue): Opened,
        surface: wgpu::Surface<'static>,
    ) -> Result<Device, DeviceError> {
        let mut config = surface
            .get_default_config(&adapter, 1, 1)
            .ok_or_else(|| DeviceError("The adapter cannot draw on a canvas".to_owned()))?;
        // Whether the first format is sRGB depends on the backend: choose one that is not.
        let formats = surface.get_capabilities(&adapter).formats;
        if let Some(&format) = formats.iter().find(|format| !format.is_srgb()) {
            config.format = format;
        }
        let loss = Arc::new(Loss::default());
        let lost = Arc::clone(&loss);
        device.set_device_lost_callback(move |_, _| lost.happen());
        surface.configure(&device, &config);
        let colour = target(&device, &config, config.format);
        let depth = target(&device, &config, DEPTH_FORMAT);
        Ok(Device { device, queue, surface, config, colour, depth, loss })
    }

    /// Returns the format of the canvas.
    pub fn format(&self) -> wgpu::TextureFormat {
        self.config.format
    }

    /// Returns the width and height of the canvas in pixels.
    pub fn size(&self) -> (u32, u32) {
        (self.config.width, self.config.height)
    }

    /// Returns the notification of the loss of the device.
    pub fn loss(&self) -> Arc<Loss> {
        Arc::clone(&self.loss)
    }

    /// Sets the size of the canvas, limited to what the adapter allows, with the same proportions.
    pub fn resize(&mut self, width: u32, height: u32) {
        let (width, height) =
            clamp_size(width, height, self.device.limits().max_texture_dimension_2d);
        if (width, height) == self.size() {
            return;
        }
        (self.config.width, self.config.height) = (width, height);
        self.surface.configure(&self.device, &self.config);
        self.colour = target(&self.device, &self.config, self.config.format);
        self.depth = target(&self.device, &self.config, DEPTH_FORMAT);
    }

    /// Returns the next frame; `None` if the canvas is not visible at the moment.
    ///
    /// # Errors
    /// The device is lost.
    pub fn frame(&mut self) -> Result<Option<SurfaceFrame>, DeviceError> {
        use wgpu::CurrentSurfaceTexture as Current;
        for _ in 0..2 {
            if self.loss.happened() {
                break;
            }
            match self.surface.get_current_texture() {
                Current::Success(texture) | Current::Suboptimal(texture) => {
                    let view = texture.texture.create_view(&wgpu::TextureViewDescriptor::default());
                    return Ok(Some(SurfaceFrame { texture, view }));
                }
                Current::Timeout | Current::Occluded => return Ok(None),
                Current::Outdated | Current::Lost => {
                    self.surface.configure(&self.device, &self.config);
                }
                Current::Validation => break,
            }
        }
        Err(DeviceError("The graphics device was lost".to_owned()))
    }

    /// Begins a pass that clears the frame and draws on it.
    pub fn pass<'a>(
        &self,
        encoder: &'a mut wgpu::CommandEncoder,
        frame: &SurfaceFrame,
        background: [f32; 4],
    ) -> wgpu::RenderPass<'a> {
        let [r, g, b, a] = background.map(f64::from);
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.colour,
                depth_slice: None,
                resolve_target: Some(&frame.view),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        })
    }

    /// Submits the commands and shows the frame.
    pub fn show(&self, encoder: wgpu::CommandEncoder, frame: SurfaceFrame) {
        self.queue.submit([encoder.finish()]);
        self.queue.present(frame.texture);
    }
}

/// Creates a multisampled texture of the size of the canvas.
fn target(
    device: &wgpu::Device,
    config: &wgpu::SurfaceConfiguration,
    format: wgpu::TextureFormat,
) -> wgpu::TextureView {
    let size =
        wgpu::Extent3d { width: config.width, height: config.height, depth_or_array_layers: 1 };
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("target"),
        size,
        mip_level_count: 1,
        sample_count: SAMPLES,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
