//! Looks for the folder of real data, so that the tests that need it report themselves as ignored where it is absent.
//!
//! It stands beside the checkout, or where `CARDIOMORPH_SHARED` says. A path that does not exist cannot be watched (cargo would
//! build everything anew each time); so `shared::the_folder_of_real_data_is_where_it_was` fails when it came or went since.

use std::path::{Path, PathBuf};

fn main() {
    println!("cargo::rerun-if-changed=tests/it/build.rs");
    println!("cargo::rerun-if-env-changed=CARDIOMORPH_SHARED");
    println!("cargo::rustc-check-cfg=cfg(shared_data)");
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let folder = std::env::var_os("CARDIOMORPH_SHARED").map_or_else(beside, PathBuf::from);
    if folder.join("data").exists() {
        println!("cargo::rustc-cfg=shared_data");
    }
    println!("cargo::rustc-env=SHARED_FOLDER={}", folder.display());
}
