//! Fits of the reflectance of one scene.
