//! The pipeline of a full-screen triangle, and the pass that it draws in.

use ash::vk;

use super::compute_pipeline::entry_name;
use super::device::shader_module;
use super::driver::failure;
use super::owned::Owned;
use super::render::RenderShaders;
use crate::CheckError;

/// The format of the one colour target.
pub(super) const FORMAT: vk::Format = vk::Format::R32G32B32A32_SFLOAT;

/// A pass that clears the target, draws, and leaves it to be copied from.
pub(super) fn render_pass(device: &ash::Device) -> Result<Owned<'_, vk::RenderPass>, CheckError> {
    let attachments = [vk::AttachmentDescription::default()
        .format(FORMAT)
        .samples(vk::SampleCountFlags::TYPE_1)
        .load_op(vk::AttachmentLoadOp::CLEAR)
        .store_op(vk::AttachmentStoreOp::STORE)
        .stencil_load_op(vk::AttachmentLoadOp::DONT_CARE)
        .stencil_store_op(vk::AttachmentStoreOp::DONT_CARE)
        .initial_layout(vk::ImageLayout::UNDEFINED)
        .final_layout(vk::ImageLayout::TRANSFER_SRC_OPTIMAL)];
    let colors = [vk::AttachmentReference { attachment: 0, layout: vk::ImageLayout::COLOR_ATTACHMENT_OPTIMAL }];
    let subpasses = [vk::SubpassDescription::default()
        .pipeline_bind_point(vk::PipelineBindPoint::GRAPHICS)
        .color_attachments(&colors)];
    let dependencies = [vk::SubpassDependency::default()
        .src_subpass(0)
        .dst_subpass(vk::SUBPASS_EXTERNAL)
        .src_stage_mask(vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT)
        .src_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_WRITE)
        .dst_stage_mask(vk::PipelineStageFlags::TRANSFER)
        .dst_access_mask(vk::AccessFlags::TRANSFER_READ)];
    let information =
        vk::RenderPassCreateInfo::default().attachments(&attachments).subpasses(&subpasses).dependencies(&dependencies);
    // SAFETY: the device is alive and the structures are complete.
    unsafe {
        let pass =
            device.create_render_pass(&information, None).map_err(|result| failure("create a render pass", result))?;
        Ok(Owned::new(device, pass, |device, pass| device.destroy_render_pass(pass, None)))
    }
}

/// The graphics pipeline of a full-screen triangle.
pub(super) struct GraphicsPipeline<'device> {
    // In the order in which they are to be destroyed.
    pipeline: Owned<'device, vk::Pipeline>,
    _layout: Owned<'device, vk::PipelineLayout>,
}

impl<'device> GraphicsPipeline<'device> {
    /// Compiles the two shaders, whose entry points `module_interface` has found.
    pub fn new(
        device: &'device ash::Device,
        shaders: &RenderShaders<'_>,
        pass: vk::RenderPass,
        extent: vk::Extent2D,
        flags: vk::PipelineCreateFlags,
    ) -> Result<Self, CheckError> {
        let (vertex_name, fragment_name) = (entry_name(shaders.vertex_entry)?, entry_name(shaders.fragment_entry)?);
        let (vertex, fragment) = (shader_module(device, shaders.vertex)?, shader_module(device, shaders.fragment)?);
        let stages = [
            vk::PipelineShaderStageCreateInfo::default()
                .stage(vk::ShaderStageFlags::VERTEX)
                .module(vertex.handle)
                .name(&vertex_name),
            vk::PipelineShaderStageCreateInfo::default()
                .stage(vk::ShaderStageFlags::FRAGMENT)
                .module(fragment.handle)
                .name(&fragment_name),
        ];
        let vertex_input = vk::PipelineVertexInputStateCreateInfo::default();
        let assembly =
            vk::PipelineInputAssemblyStateCreateInfo::default().topology(vk::PrimitiveTopology::TRIANGLE_LIST);
        let (width, height) = (extent.width as f32, extent.height as f32);
        let viewports = [vk::Viewport { x: 0.0, y: 0.0, width, height, min_depth: 0.0, max_depth: 1.0 }];
        let scissors = [vk::Rect2D { offset: vk::Offset2D::default(), extent }];
        let viewport = vk::PipelineViewportStateCreateInfo::default().viewports(&viewports).scissors(&scissors);
        let rasterization = vk::PipelineRasterizationStateCreateInfo::default()
            .polygon_mode(vk::PolygonMode::FILL)
            .cull_mode(vk::CullModeFlags::NONE)
            .front_face(vk::FrontFace::COUNTER_CLOCKWISE)
            .line_width(1.0);
        let multisample =
            vk::PipelineMultisampleStateCreateInfo::default().rasterization_samples(vk::SampleCountFlags::TYPE_1);
        let attachments =
            [vk::PipelineColorBlendAttachmentState::default().color_write_mask(vk::ColorComponentFlags::RGBA)];
        let blend = vk::PipelineColorBlendStateCreateInfo::default().attachments(&attachments);
        // SAFETY: all objects belong to this device and outlive what is made of them; the entry points were found in
        // their modules.
        unsafe {
            let layout = device
                .create_pipeline_layout(&vk::PipelineLayoutCreateInfo::default(), None)
                .map_err(|result| failure("create a pipeline layout", result))?;
            let layout = Owned::new(device, layout, |device, layout| device.destroy_pipeline_layout(layout, None));
            let information = [vk::GraphicsPipelineCreateInfo::default()
                .flags(flags)
                .stages(&stages)
                .vertex_input_state(&vertex_input)
                .input_assembly_state(&assembly)
                .viewport_state(&viewport)
                .rasterization_state(&rasterization)
                .multisample_state(&multisample)
                .color_blend_state(&blend)
                .layout(layout.handle)
                .render_pass(pass)];
            let pipelines = device
                .create_graphics_pipelines(vk::PipelineCache::null(), &information, None)
                .map_err(|(_, result)| failure("create the graphics pipeline", result))?;
            let pipeline = Owned::new(device, pipelines[0], |device, pipeline| device.destroy_pipeline(pipeline, None));
            Ok(GraphicsPipeline { pipeline, _layout: layout })
        }
    }

    /// The Vulkan object.
    pub fn handle(&self) -> vk::Pipeline {
        self.pipeline.handle
    }
}
