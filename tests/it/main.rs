//! The doors of the program, tried from outside: one binary, one module per door.

mod cli;
mod oracles;
mod panels;
mod real_data;
mod real_mesh_files;
mod robustness;
