//! The doors of the program, tried from outside: one binary, one module per door.
//!
//! Modules are marked as tests so that helpers beside the tests may fail loudly.

#[cfg(test)]
mod cli;
#[cfg(test)]
mod clinical_oracles;
#[cfg(test)]
mod curvature_oracles;
#[cfg(test)]
mod damaged_images;
#[cfg(test)]
mod formats;
#[cfg(test)]
mod golden;
#[cfg(test)]
mod known_trouble;
#[cfg(test)]
mod medial_noise;
#[cfg(test)]
mod motions_and_shapes;
#[cfg(test)]
mod obj_by_tobj;
#[cfg(test)]
mod one_patient_two_formats;
#[cfg(test)]
mod opening;
#[cfg(test)]
mod oracles;
#[cfg(test)]
mod panels;
#[cfg(test)]
mod patches;
#[cfg(test)]
mod privacy;
#[cfg(test)]
mod real_cine;
#[cfg(test)]
mod real_contours;
#[cfg(test)]
mod real_data;
#[cfg(test)]
mod real_deformations;
#[cfg(test)]
mod real_dicom;
#[cfg(test)]
mod real_dicom_damage;
#[cfg(test)]
mod real_dicom_tables;
#[cfg(test)]
mod real_images;
#[cfg(test)]
mod real_measures;
#[cfg(test)]
mod real_mesh_files;
#[cfg(test)]
mod real_partners;
#[cfg(test)]
mod real_patches;
#[cfg(test)]
mod real_paths;
#[cfg(test)]
mod real_spect;
#[cfg(test)]
mod real_thickness;
#[cfg(test)]
mod real_verdicts;
#[cfg(test)]
mod real_walls;
#[cfg(test)]
mod robustness;
#[cfg(test)]
mod screenshots;
#[cfg(test)]
mod shared;
#[cfg(test)]
mod small_images;
#[cfg(test)]
mod synthetic_spect;
#[cfg(test)]
mod window;
