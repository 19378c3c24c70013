//! The doors of the program, tried from outside: one binary, one module per door.

mod clinical_oracles;
mod real_data;
mod real_measures;
