//! MetaImage: volumes of the Insight Toolkit, with the values in the same file (`.mha`) or beside it (`.mhd`).

mod header;
mod read;
#[cfg(test)]
mod tests;

pub(super) use header::recognises;
pub(super) use read::read_metaimage;
