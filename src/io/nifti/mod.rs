//! NIfTI-1 and NIfTI-2: volumes of magnetic resonance and of masks, in a world that is RAS.

mod header;
mod placement;
mod read;
#[cfg(test)]
mod tests;

pub(super) use header::recognises;
pub(super) use read::read_nifti;
