//! `demo`: the built-in cohort as a study on disk.

use serde_json::json;

use crate::cli::args::DemoArgs;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::work::run_work;
use crate::io::write_study;
use crate::study::built_in::{BuiltInParams, cohort};

pub(super) fn demo(args: &DemoArgs) -> Result<(), CliError> {
    let params = BuiltInParams {
        seed: args.seed,
        vertices: args.vertices,
    };
    // The number of vertices is an option, so what is wrong with it is wrong usage.
    let study = cohort(&params)
        .map_err(|error| CliError::Usage(error.to_string()))?
        .study;
    let (folder, format) = (args.out.clone(), args.format);
    let (subjects, first) = (study.subjects.len(), study.subjects.first().cloned());
    run_work(move |progress| {
        progress.begin_phase("writing meshes", 0.0, 1.0);
        write_study(&study, &folder, format, progress)
    })?;
    let frames = first.as_ref().map_or(0, |s| s.sequence.frame_count());
    let vertices = first.as_ref().map_or(0, |s| s.sequence.vertex_count());
    let folder = args.out.display().to_string();
    if args.json {
        return print_json(&json!({
            "folder": folder, "subjects": subjects, "frames": frames, "vertices": vertices,
            "seed": args.seed,
        }));
    }
    print(&format!(
        "{subjects} subjects, {frames} frames each, {vertices} vertices: {folder}"
    ))
}
