//! The bubble on a device: a pipeline, and a picture in floating point that is read back.

use crate::bubble::{SurfaceUniforms, WGSL};
use std::error::Error;
use wgpu::util::DeviceExt;

/// How many pixels a side of the picture has: rows of 16 bytes a pixel are as long as copies want them.
pub const SIZE: u32 = 512;

const SPHERE: &str = include_str!("sphere.wgsl");

/// A device with its queue.
pub struct Gpu {
    pub adapter: wgpu::Adapter,
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
}

impl Gpu {
    /// The first device that can draw to the surface; any one where there is none.
    pub fn new(instance: &wgpu::Instance, surface: Option<&wgpu::Surface<'_>>) -> Result<Self, Box<dyn Error>> {
        let options = wgpu::RequestAdapterOptions { compatible_surface: surface, ..Default::default() };
        let adapter = pollster::block_on(instance.request_adapter(&options))
            .map_err(|error| format!("there is no Vulkan device; Debian's mesa-vulkan-drivers has one: {error}"))?;
        let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;
        Ok(Self { adapter, device, queue })
    }
}

/// The pipeline of the bubble, and its uniforms.
pub struct Bubble {
    pipeline: wgpu::RenderPipeline,
    uniforms: wgpu::BindGroup,
}

impl Bubble {
    /// For a square target of so many pixels a side.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat, size: u32, surface: &SurfaceUniforms) -> Self {
        let device = &gpu.device;
        let text = format!("const HALF_SIZE = {:?};\n{WGSL}\n{SPHERE}", size as f32 / 2.0);
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("bubble"),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("bubble"),
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vertex"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: Default::default(),
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fragment"),
                compilation_options: Default::default(),
                targets: &[Some(format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("surface"),
            contents: &surface.to_bytes(),
            usage: wgpu::BufferUsages::UNIFORM,
        });
        let uniforms = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("surface"),
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }],
        });
        Self { pipeline, uniforms }
    }

    /// Draws to a target.
    pub fn draw(&self, encoder: &mut wgpu::CommandEncoder, target: &wgpu::TextureView) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("bubble"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
            })],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.uniforms, &[]);
        pass.draw(0..3, 0..1);
    }
}

/// The picture as linear red, green, blue and alpha, row by row from the top.
pub fn picture(gpu: &Gpu, surface: &SurfaceUniforms) -> Result<Vec<[f32; 4]>, Box<dyn Error>> {
    let format = wgpu::TextureFormat::Rgba32Float;
    let extent = wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("picture"),
        size: extent,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    let bytes_per_row = SIZE * 16;
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("picture"),
        size: u64::from(bytes_per_row * SIZE),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let bubble = Bubble::new(gpu, format, SIZE, surface);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    bubble.draw(&mut encoder, &texture.create_view(&Default::default()));
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(bytes_per_row), rows_per_image: Some(SIZE) };
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
        extent,
    );
    gpu.queue.submit([encoder.finish()]);
    let (sender, receiver) = std::sync::mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        let _ = sender.send(result);
    });
    gpu.device.poll(wgpu::PollType::wait_indefinitely())?;
    receiver.recv()??;
    let bytes = buffer.get_mapped_range(..)?;
    let number = |bytes: &[u8]| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    let pixels = bytes.chunks_exact(16).map(|p| [&p[..4], &p[4..8], &p[8..12], &p[12..]].map(number));
    Ok(pixels.collect())
}
