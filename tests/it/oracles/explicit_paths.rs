//! Energies of paths against a statement of the formulas in numpy.

use cardiomorph::analysis::metrics::PathEnergy;

use super::*;

/// Metrics as the oracle names them, with what they mean here.
fn named() -> Vec<(String, MetricParams)> {
    let kinds = [
        ("iso", MetricKind::Isometric),
        ("ap", MetricKind::AnglePreserving),
        ("qc", MetricKind::QuasiConformal),
    ];
    let mut all = Vec::new();
    for (short, kind) in kinds {
        for (form_name, form) in [("printed", Form::Printed), ("bilinear", Form::Bilinear)] {
            for (suffix, corners) in [("", Corners::Raw), ("_norm", Corners::ScaleFree)] {
                if (kind, form) != (MetricKind::Isometric, Form::Printed) {
                    let params = as_printed(kind, form, corners);
                    all.push((format!("{short}_{form_name}{suffix}"), params));
                }
            }
        }
    }
    all
}

struct Ends {
    case: Case,
    faces: Faces,
    start: Vec<Point3>,
    end: Vec<Point3>,
}

impl Ends {
    fn load() -> Self {
        let case = Case::load("degeneracy", "explicit_paths");
        let (start, faces) = case.input_mesh("start");
        let (end, _) = case.input_mesh("end");
        Self {
            case,
            faces,
            start,
            end,
        }
    }

    fn metric(&self, params: MetricParams) -> Metric {
        Metric::new(&self.faces, params.check().unwrap())
    }

    fn check(&self, path: &str, inner: &[Vec<Point3>]) {
        let flat: Vec<f64> = (inner.iter().flatten())
            .flat_map(|p| p.iter().copied())
            .collect();
        for (name, params) in named() {
            let metric = self.metric(params);
            let mut energy = PathEnergy::new(&metric, &self.start, &self.end, inner.len()).unwrap();
            let expected = self.case.value["expected"][path][&name].as_f64().unwrap();
            close(
                &format!("{path} {name}"),
                energy.energy(&flat),
                expected,
                1e-8,
            );
        }
    }
}

#[test]
fn energies_of_straight_paths_agree_with_numpy_at_any_number_of_steps() {
    let ends = Ends::load();
    ends.check("direct", &[]);
    for steps in [1, 2, 4, 8, 16] {
        let inner: Vec<Vec<Point3>> = (1..steps)
            .map(|k| {
                let t = f64::from(k) / f64::from(steps);
                let both = ends.start.iter().zip(&ends.end);
                both.map(|(a, b)| a + (b - a) * t).collect()
            })
            .collect();
        ends.check(&format!("linear_{steps}_steps"), &inner);
    }
}

#[test]
fn shrinking_saves_what_it_saves_in_numpy() {
    let ends = Ends::load();
    for s in [0.5, 0.25, 0.1] {
        let inner = [&ends.start, &ends.end]
            .map(|pose| pose.iter().map(|p| p * s).collect::<Vec<Point3>>());
        ends.check(&format!("shrink_{s}"), &inner);
    }
}

#[test]
fn the_quasi_conformal_product_is_of_fourth_degree_as_in_numpy() {
    let ends = Ends::load();
    let x: Vec<Vector3> = (ends.end.iter().zip(&ends.start))
        .map(|(b, a)| b - a)
        .collect();
    for (key, kind) in [
        ("ap", MetricKind::AnglePreserving),
        ("qc", MetricKind::QuasiConformal),
    ] {
        let metric = ends.metric(as_printed(kind, Form::Bilinear, Corners::ScaleFree));
        let pose = metric.prepare(&ends.start).unwrap();
        let [small, double] = [1e-3, 2e-3].map(|c| {
            let scaled: Vec<Vector3> = x.iter().map(|x| x * c).collect();
            metric.norm2(&pose, &scaled)
        });
        let expected = &ends.case.value["expected"]["homogeneity_degree"][key];
        let apart = (double / small).log2() - expected.as_f64().unwrap();
        // Curvature changes of 10⁻⁴ carry round-off of 10⁻¹⁵ each.
        assert!(apart.abs() < 1e-8, "{key}: {apart}");
    }
}
