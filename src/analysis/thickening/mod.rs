//! Which part of the wall does not thicken?
mod params; mod error; 
pub mod curve; pub mod diffusion;
