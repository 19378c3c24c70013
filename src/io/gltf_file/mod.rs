//! glTF 2.0, as text (`.gltf`) and binary (`.glb`): meshes of the scene, and their morph targets
//! as the frames of a sequence.
//!
//! The `gltf` crate parses and validates the JSON; what its validation leaves out is checked in
//! `container`. Its readers of containers and numbers panic on damage (subtraction below zero in
//! the header's length, sparse values that are missing), so bytes are read by our own code.

mod accessors;
mod animation;
mod buffers;
mod container;
mod frames;
mod read;
mod scene;

pub(super) use read::read_gltf;
