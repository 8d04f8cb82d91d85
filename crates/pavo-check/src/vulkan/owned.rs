//! Vulkan objects that are destroyed when they go out of scope.

/// A Vulkan object of a device, destroyed on drop. Declare objects in the order of their creation: Rust drops them in
/// the opposite order, which is what Vulkan asks for.
pub(super) struct Owned<'device, H: Copy> {
    device: &'device ash::Device,
    /// The object.
    pub handle: H,
    destroy: unsafe fn(&ash::Device, H),
}

impl<'device, H: Copy> Owned<'device, H> {
    /// Takes an object over.
    ///
    /// # Safety
    /// `handle` is an object of `device` that nobody else destroys, `destroy` destroys objects of its kind, and no
    /// work that uses it is pending when it is dropped.
    pub unsafe fn new(device: &'device ash::Device, handle: H, destroy: unsafe fn(&ash::Device, H)) -> Self {
        Owned { device, handle, destroy }
    }
}

impl<H: Copy> Drop for Owned<'_, H> {
    fn drop(&mut self) {
        // SAFETY: by the contract of `new`, the object is alive, ours alone, and not in use.
        unsafe { (self.destroy)(self.device, self.handle) }
    }
}
