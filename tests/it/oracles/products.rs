//! Products of fields in every metric of the list against NumPy, see `tests/oracles/metrics/make.py`.

use cardiomorph::analysis::metrics::METRICS;

use super::*;

/// The test that a new metric fails until `tests/oracles/metrics/make.py` knows it.
#[test]
fn every_metric_of_the_list_has_the_products_of_numpy() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracles/metrics");
    let text = std::fs::read_to_string(folder.join("products.json")).unwrap();
    let all: Value = serde_json::from_str(&text).unwrap();
    for (name, kind) in MESHES
        .iter()
        .flat_map(|name| METRICS.map(|kind| (name, kind)))
    {
        let case = Case::load("metrics", name);
        let (points, faces) = case.mesh();
        let (x, y) = (case.field("X"), case.field("Y"));
        for (word, corners) in [("raw", Corners::Raw), ("scale-free", Corners::ScaleFree)] {
            let prepared =
                Prepared::new(&faces, &points, as_printed(kind, Form::Bilinear, corners));
            let id = kind.words().id;
            let expected = |pair: &str| {
                let value = all[name][id][word][pair].as_f64();
                value.unwrap_or_else(|| panic!("no oracle of {id}: see metrics/make.py"))
            };
            // The sum of XY cancels: its tolerance is relative to its terms.
            let terms = (expected("XX") * expected("YY")).sqrt();
            for (pair, found, of) in [
                ("XX", prepared.product(&x, &x), expected("XX")),
                ("XY", prepared.product(&x, &y), terms),
                ("YY", prepared.product(&y, &y), expected("YY")),
                ("XX", prepared.of_pair(&points, &x), expected("XX")),
            ] {
                let off = (found - expected(pair)).abs();
                assert!(off <= 1e-8 * of, "{name} {id} {word} {pair}: {found}");
            }
        }
    }
}
