//! `metric`: one distance between two meshes in correspondence.

use std::path::Path;

use serde_json::json;

use crate::analysis::alignment::{rigid_motion, similarity};
use crate::analysis::metrics::{Metric, MetricParams, PairNorms, PairScratch};
use crate::cli::args::MetricArgs;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json, say};
use crate::cli::words::{AlignWord, Switch};
use crate::io::{Limits, read_mesh_with_siblings};
use crate::mesh::{Point3, TriMesh};

pub(super) fn metric(args: &MetricArgs) -> Result<(), CliError> {
    let params = MetricParams {
        kind: args.metric.into(),
        form: args.form.into(),
        corners: args.corners.into(),
        area_weights: args.area_weights == Switch::On,
        mu: args.mu,
        lambda: args.lambda,
        regulariser: args.regulariser.into(),
        ..MetricParams::default()
    };
    let params = params
        .check()
        .map_err(|error| CliError::Usage(error.to_string()))?;
    let (a, b) = (read(&args.a)?, read(&args.b)?);
    if a.faces() != b.faces() {
        return Err(CliError::Unusable(format!(
            "the meshes do not correspond: {} has {} vertices and {} faces, {} has {} and {}{}",
            args.a.display(),
            a.vertices().len(),
            a.triangles().len(),
            args.b.display(),
            b.vertices().len(),
            b.triangles().len(),
            if a.triangles().len() == b.triangles().len() {
                ", connected otherwise"
            } else {
                ""
            }
        )));
    }
    let moved = aligned(&a, &b, args.align)?;
    let metric = Metric::new(a.faces(), params);
    let pose_a = metric.prepare(a.vertices()).map_err(CliError::unusable)?;
    let pose_b = metric.prepare(&moved).map_err(CliError::unusable)?;
    let norms = metric.pair(&pose_a, &pose_b, &mut PairScratch::default());
    report(norms, args.json)
}

fn report(norms: PairNorms, as_json: bool) -> Result<(), CliError> {
    if as_json {
        return print_json(&json!({
            "norm2_a": norms.norm2_a,
            "norm2_b": norms.norm2_b,
            "energy": norms.energy(),
            "distance": norms.distance(),
        }));
    }
    print(&format!(
        "norm2_a {}\nnorm2_b {}\nenergy {}\ndistance {}",
        norms.norm2_a,
        norms.norm2_b,
        norms.energy(),
        norms.distance()
    ))
}

/// The vertices of B, laid onto A as asked.
fn aligned(a: &TriMesh, b: &TriMesh, align: AlignWord) -> Result<Vec<Point3>, CliError> {
    let (target, source) = (a.vertices(), b.vertices());
    Ok(match align {
        AlignWord::None => source.to_vec(),
        AlignWord::Rigid => {
            let motion = rigid_motion(source, target).map_err(CliError::unusable)?;
            source.iter().map(|point| motion.apply(point)).collect()
        }
        AlignWord::Similarity => {
            let map = similarity(source, target).map_err(CliError::unusable)?;
            source.iter().map(|point| map.apply(point)).collect()
        }
    })
}

/// The mesh in a file, or the first frame of a sequence in one.
fn read(path: &Path) -> Result<TriMesh, CliError> {
    let wrong = |reason: String| CliError::Unusable(format!("{reason}: {}", path.display()));
    let limits = Limits::default();
    let size = std::fs::metadata(path)
        .map_err(|error| wrong(error.to_string()))?
        .len();
    if size > limits.file_bytes {
        let most = limits.file_bytes;
        return Err(wrong(format!("{size} bytes; at most {most} are read")));
    }
    let bytes = std::fs::read(path).map_err(|error| wrong(error.to_string()))?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let sibling = |name: &str| std::fs::read(folder.join(name)).ok();
    let file = read_mesh_with_siblings(&name, &bytes, &limits, &sibling)
        .map_err(|error| wrong(error.to_string()))?;
    for notice in &file.notices {
        say(&format!("{}: {}", path.display(), notice.text));
    }
    file.frames
        .into_iter()
        .next()
        .ok_or_else(|| wrong("holds no mesh".to_owned()))
}
