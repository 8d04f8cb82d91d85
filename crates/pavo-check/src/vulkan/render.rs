//! Renders a full-screen triangle into a picture of 32-bit floats.

use ash::vk;

use super::buffer::{Buffer, allocate, memory_type};
use super::device::Device;
use super::driver::failure;
use super::graphics_pipeline::{FORMAT, GraphicsPipeline, render_pass};
use super::module_interface::{FRAGMENT, ModuleInterface, VERTEX};
use super::owned::Owned;
use crate::CheckError;

/// The two shaders of a picture. Both entry points may lie in one module.
#[derive(Clone, Copy, Debug)]
pub struct RenderShaders<'module> {
    /// A valid SPIR-V module for Vulkan 1.1 with the vertex shader. It places three vertices by their index, without
    /// attributes, so that they cover the screen.
    pub vertex: &'module [u32],
    /// The name of the vertex shader's entry point.
    pub vertex_entry: &'module str,
    /// A valid SPIR-V module for Vulkan 1.1 with the fragment shader, which writes a colour to location 0.
    pub fragment: &'module [u32],
    /// The name of the fragment shader's entry point.
    pub fragment_entry: &'module str,
}

impl Device {
    /// Renders three vertices without attributes or resources, and returns the pixels row by row from the top left.
    ///
    /// The target has 32-bit float channels without blending; where nothing is drawn, a pixel is `[0.0; 4]`. The
    /// fragment coordinate of the first pixel is `(0.5, 0.5)`. The top of the picture is at `y == -1` of the clip space
    /// in SPIR-V from GLSL and at `y == 1` in that from WGSL, as naga flips it.
    ///
    /// Both modules must be valid ([`judge_spirv`](crate::judge_spirv)); a driver may do anything with one that is not.
    ///
    /// # Errors
    /// [`CheckError::Input`] when a module has no such entry point or declares resources; [`CheckError::Limit`] when
    /// the picture is empty or larger than the device allows; [`CheckError::Vulkan`] when the driver fails.
    pub fn render(&self, shaders: &RenderShaders<'_>, width: u32, height: u32) -> Result<Vec<[f32; 4]>, CheckError> {
        for (module, entry, model) in
            [(shaders.vertex, shaders.vertex_entry, VERTEX), (shaders.fragment, shaders.fragment_entry, FRAGMENT)]
        {
            let interface = ModuleInterface::read(module)?;
            self.check_precision(&interface)?;
            interface.entry_point(entry, model)?;
            interface.check_resources(&[])?;
        }
        self.check_size(width, height)?;
        let extent = vk::Extent2D { width, height };
        let pass = render_pass(&self.device)?;
        let target = Target::new(self, pass.handle, extent)?;
        let none = vk::PipelineCreateFlags::empty();
        let pipeline = GraphicsPipeline::new(&self.device, shaders, pass.handle, extent, none)?;
        let channels = width as usize * height as usize * 4;
        let pixels = Buffer::new(self, channels, vk::BufferUsageFlags::TRANSFER_DST)?;
        self.draw(pass.handle, &target, &pipeline, &pixels, extent)?;
        let (pixels, _) = pixels.read(channels).as_chunks::<4>();
        Ok(pixels.to_vec())
    }

    fn check_size(&self, width: u32, height: u32) -> Result<(), CheckError> {
        let limits = &self.limits;
        for (what, asked, framebuffer, viewport) in [
            ("width", width, limits.max_framebuffer_width, limits.max_viewport_dimensions[0]),
            ("height", height, limits.max_framebuffer_height, limits.max_viewport_dimensions[1]),
        ] {
            if asked == 0 {
                return Err(CheckError::Input(format!("a picture of {width} by {height} pixels is empty")));
            }
            let allowed = framebuffer.min(viewport).min(limits.max_image_dimension2_d);
            if asked > allowed {
                let what = format!("the {what} of a picture in pixels");
                return Err(CheckError::Limit { what, asked: u64::from(asked), allowed: u64::from(allowed) });
            }
        }
        Ok(())
    }

    fn draw(
        &self,
        pass: vk::RenderPass,
        target: &Target<'_>,
        pipeline: &GraphicsPipeline<'_>,
        pixels: &Buffer<'_>,
        extent: vk::Extent2D,
    ) -> Result<(), CheckError> {
        let device = &self.device;
        self.run(|commands| {
            let clear = [vk::ClearValue { color: vk::ClearColorValue { float32: [0.0; 4] } }];
            let begin = vk::RenderPassBeginInfo::default()
                .render_pass(pass)
                .framebuffer(target.framebuffer.handle)
                .render_area(vk::Rect2D { offset: vk::Offset2D::default(), extent })
                .clear_values(&clear);
            let layers = vk::ImageSubresourceLayers::default().aspect_mask(vk::ImageAspectFlags::COLOR).layer_count(1);
            let regions = [vk::BufferImageCopy::default().image_subresource(layers).image_extent(extent.into())];
            let copied = [vk::MemoryBarrier::default()
                .src_access_mask(vk::AccessFlags::TRANSFER_WRITE)
                .dst_access_mask(vk::AccessFlags::HOST_READ)];
            // SAFETY: the commands are being recorded, and all objects belong to this device and fit each other.
            unsafe {
                device.cmd_begin_render_pass(commands, &begin, vk::SubpassContents::INLINE);
                device.cmd_bind_pipeline(commands, vk::PipelineBindPoint::GRAPHICS, pipeline.handle());
                device.cmd_draw(commands, 3, 1, 0, 0);
                device.cmd_end_render_pass(commands);
                device.cmd_copy_image_to_buffer(
                    commands,
                    target.image.handle,
                    vk::ImageLayout::TRANSFER_SRC_OPTIMAL,
                    pixels.handle(),
                    &regions,
                );
                device.cmd_pipeline_barrier(
                    commands,
                    vk::PipelineStageFlags::TRANSFER,
                    vk::PipelineStageFlags::HOST,
                    vk::DependencyFlags::empty(),
                    &copied,
                    &[],
                    &[],
                );
            }
        })
    }
}

/// The picture on the device.
struct Target<'device> {
    // In the order in which they are to be destroyed.
    framebuffer: Owned<'device, vk::Framebuffer>,
    _view: Owned<'device, vk::ImageView>,
    image: Owned<'device, vk::Image>,
    _memory: Owned<'device, vk::DeviceMemory>,
}

impl<'device> Target<'device> {
    fn new(device: &'device Device, pass: vk::RenderPass, extent: vk::Extent2D) -> Result<Self, CheckError> {
        let handle = &device.device;
        let information = vk::ImageCreateInfo::default()
            .image_type(vk::ImageType::TYPE_2D)
            .format(FORMAT)
            .extent(extent.into())
            .mip_levels(1)
            .array_layers(1)
            .samples(vk::SampleCountFlags::TYPE_1)
            .tiling(vk::ImageTiling::OPTIMAL)
            .usage(vk::ImageUsageFlags::COLOR_ATTACHMENT | vk::ImageUsageFlags::TRANSFER_SRC)
            .sharing_mode(vk::SharingMode::EXCLUSIVE)
            .initial_layout(vk::ImageLayout::UNDEFINED);
        // SAFETY: all objects belong to this device; the memory fits the image's requirements and is bound once.
        unsafe {
            let image = handle.create_image(&information, None).map_err(|result| failure("create an image", result))?;
            let image = Owned::new(handle, image, |device, image| device.destroy_image(image, None));
            let requirements = handle.get_image_memory_requirements(image.handle);
            let local = vk::MemoryPropertyFlags::DEVICE_LOCAL;
            let memory_type = memory_type(&device.memory, requirements, vk::MemoryPropertyFlags::empty(), local)
                .ok_or_else(|| CheckError::Vulkan {
                    action: "create an image",
                    reason: "the device has no memory for it".to_owned(),
                })?;
            let memory = allocate(device, requirements.size, memory_type)?;
            handle
                .bind_image_memory(image.handle, memory.handle, 0)
                .map_err(|result| failure("bind the memory of an image", result))?;

            let range = vk::ImageSubresourceRange::default()
                .aspect_mask(vk::ImageAspectFlags::COLOR)
                .level_count(1)
                .layer_count(1);
            let information = vk::ImageViewCreateInfo::default()
                .image(image.handle)
                .view_type(vk::ImageViewType::TYPE_2D)
                .format(FORMAT)
                .subresource_range(range);
            let view = handle
                .create_image_view(&information, None)
                .map_err(|result| failure("create an image view", result))?;
            let view = Owned::new(handle, view, |device, view| device.destroy_image_view(view, None));

            let attachments = [view.handle];
            let information = vk::FramebufferCreateInfo::default()
                .render_pass(pass)
                .attachments(&attachments)
                .width(extent.width)
                .height(extent.height)
                .layers(1);
            let framebuffer = handle
                .create_framebuffer(&information, None)
                .map_err(|result| failure("create a framebuffer", result))?;
            let framebuffer = Owned::new(handle, framebuffer, |device, framebuffer| {
                device.destroy_framebuffer(framebuffer, None);
            });
            Ok(Target { framebuffer, _view: view, image, _memory: memory })
        }
    }
}
