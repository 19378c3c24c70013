//! `metric`: one distance between two meshes in correspondence.

use serde_json::json;

use crate::analysis::metrics::{EnergyShares, Metric, PairNorms, PairScratch};
use crate::cli::args::MetricArgs;
use crate::cli::corresponding::{aligned, read_pair};
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::mesh::area;

pub(super) fn metric(args: &MetricArgs) -> Result<(), CliError> {
    let params = args.metric.checked()?;
    let [a, b] = read_pair(&args.a, &args.b)?;
    for (mesh, path) in [(&a, &args.a), (&b, &args.b)] {
        // A metric is a sum over areas: of none, every distance is zero.
        if area(mesh.vertices(), mesh.triangles()) == 0.0 {
            let reason =
                "no face has an area: the mesh is a line or a point, or too small for numbers";
            return Err(CliError::Unusable(format!("{reason}: {}", path.display())));
        }
    }
    let moved = aligned(a.vertices(), b.vertices(), args.align)?;
    let metric = Metric::new(a.faces(), params);
    let pose_a = metric.prepare(a.vertices()).map_err(CliError::unusable)?;
    let pose_b = metric.prepare(&moved).map_err(CliError::unusable)?;
    let scratch = &mut PairScratch::default();
    let norms = metric.pair(&pose_a, &pose_b, scratch);
    let shares = metric.shares(&pose_a, &pose_b, scratch);
    let numbers = [
        norms.norm2_a,
        norms.norm2_b,
        norms.energy(),
        norms.distance(),
    ];
    if numbers.iter().any(|number| !number.is_finite()) {
        return Err(CliError::Unusable(format!(
            "the distance is no number: coordinates are too large or too small for their squares: {}, {}",
            args.a.display(),
            args.b.display()
        )));
    }
    report(norms, shares, params.kind.words().term, args.json)
}

fn report(
    norms: PairNorms,
    shares: Option<EnergyShares>,
    own_term: &str,
    as_json: bool,
) -> Result<(), CliError> {
    if as_json {
        return print_json(&json!({
            "norm2_a": norms.norm2_a,
            "norm2_b": norms.norm2_b,
            "energy": norms.energy(),
            "distance": norms.distance(),
            "shares": shares.map(|shares| json!({
                "own_term": own_term,
                "own": shares.own,
                "curvature": shares.curvature,
                "displacement": shares.displacement,
            })),
        }));
    }
    let shares = shares.map_or_else(String::new, |shares| {
        let [own, curvature, displacement] =
            [shares.own, shares.curvature, shares.displacement].map(|share| 100.0 * share);
        format!(
            "\nof the energy: {own_term} {own:.1} %, change of curvature {curvature:.1} %, displacement {displacement:.1} %"
        )
    });
    print(&format!(
        "norm2_a {}\nnorm2_b {}\nenergy {}\ndistance {}{shares}",
        norms.norm2_a,
        norms.norm2_b,
        norms.energy(),
        norms.distance()
    ))
}
