//! How deformations are best compared, found on the data at hand: radii of smoothing, with what is chosen for a case
//! without that case.

use cardiomorph::analysis::classification::{Accuracy, ClassesParams, classify};
use cardiomorph::analysis::deformations::{
    DeformationMapParams, PartDistances, PartParams, PartWeights, map_of_distances, part_distances,
};
use cardiomorph::analysis::experiments::patient_of;
use cardiomorph::analysis::metrics::{MetricKind, MetricParams};
use cardiomorph::analysis::pose_distances::{DistanceMatrix, PoseDistanceParams};
use cardiomorph::analysis::transport::CohortTransportParams;
use cardiomorph::progress::Progress;
use cardiomorph::study::Study;
use cardiomorph::study::built_in::{BuiltInParams, cohort};

use crate::shared::{opened, shared_data};

/// Radii that are tried, in √area.
const RADII: [f64; 8] = [0.0, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15];

/// A study with the class of each subject; subjects of one group are left out together.
struct Cases {
    name: &'static str,
    study: Study,
    classes: Vec<String>,
    groups: Vec<usize>,
}

impl Cases {
    /// Told apart by their labels.
    fn labelled(name: &'static str, study: Study) -> Self {
        let labels = study.subjects.iter().map(|subject| subject.label.clone());
        Self {
            name,
            classes: labels.map(Option::unwrap_or_default).collect(),
            groups: (0..study.subjects.len()).collect(),
            study,
        }
    }

    /// Told apart by whose they are.
    fn partners(name: &'static str, study: Study) -> Self {
        let patient = |id: &str| patient_of(id).unwrap_or(id).to_owned();
        let classes: Vec<String> = (study.subjects.iter())
            .map(|subject| patient(&subject.id))
            .collect();
        let first = |class| classes.iter().position(|other| other == class);
        let groups = classes.iter().filter_map(first).collect();
        Self {
            name,
            groups,
            classes,
            study,
        }
    }

    /// The same cases classified as normal or not; `None` where no label says it.
    fn normal_or_not(&self) -> Option<Self> {
        let normal = |class: &String| class == "NOR" || class == "normal";
        let words = |class| if normal(class) { "normal" } else { "abnormal" };
        self.classes.iter().any(normal).then(|| Self {
            name: self.name,
            study: self.study.clone(),
            classes: self
                .classes
                .iter()
                .map(|class| words(class).to_owned())
                .collect(),
            groups: self.groups.clone(),
        })
    }

    fn parts(&self, poses: &PoseDistanceParams, smoothing: f64) -> PartDistances {
        let params = PartParams::like(poses, smoothing).check().unwrap();
        let parts = part_distances(&self.study, &params, &Progress::default()).unwrap();
        assert_eq!(parts.subjects.len(), self.study.subjects.len());
        parts
    }

    /// Whether the nearest subject outside a group is of the class of the case.
    fn right(&self, distances: &DistanceMatrix, case: usize, without: Option<usize>) -> bool {
        let others = (0..self.classes.len())
            .filter(|&other| other != case && Some(self.groups[other]) != without);
        let nearest =
            others.min_by(|a, b| distances.get(case, *a).total_cmp(&distances.get(case, *b)));
        nearest.is_some_and(|nearest| self.classes[nearest] == self.classes[case])
    }

    fn count_right(&self, distances: &DistanceMatrix, without: Option<usize>) -> usize {
        let cases = (0..self.classes.len()).filter(|case| Some(self.groups[*case]) != without);
        cases
            .filter(|case| self.right(distances, *case, without))
            .count()
    }

    /// Of each case, the radius by which most cases of other groups are right, of equals the least, and whether the case is
    /// right by it.
    fn nested(&self, curve: &[DistanceMatrix]) -> Vec<(f64, bool)> {
        let choose = |case: usize| {
            let group = Some(self.groups[case]);
            let counts = curve
                .iter()
                .map(|distances| self.count_right(distances, group));
            let counts: Vec<usize> = counts.collect();
            let most = counts.iter().max().copied();
            let chosen = counts.iter().position(|count| Some(*count) == most);
            let chosen = chosen.unwrap_or_default();
            (RADII[chosen], self.right(&curve[chosen], case, None))
        };
        (0..self.classes.len()).map(choose).collect()
    }

    /// A row of a table: right by the nearest neighbour, and where classes have more than two cases by the linear
    /// classifier, by that in the plane and by clusters.
    fn row(&self, distances: &DistanceMatrix) -> String {
        let nearest = self.count_right(distances, None);
        let progress = Progress::default();
        let map = DeformationMapParams::default().check().unwrap();
        let plane = map_of_distances(distances, &map, &progress).unwrap();
        let labels: Vec<Option<&str>> = self.classes.iter().map(|class| Some(&**class)).collect();
        let params = ClassesParams {
            permutations: 1,
            ..ClassesParams::default()
        };
        let params = params.check().unwrap();
        let classes = classify(distances, &plane, &labels, &params, &progress).unwrap();
        let right = |accuracy: Option<_>| accuracy.map_or(0, |accuracy: Accuracy| accuracy.correct);
        let [linear, in_plane, tau] = [
            classes.linear_classifier,
            classes.plane_classifier,
            classes.tau,
        ]
        .map(right);
        format!(
            "{nearest} | {linear} | {in_plane} | {tau} of {}",
            labels.len()
        )
    }
}

fn all() -> [Cases; 3] {
    let built_in = cohort(&BuiltInParams::default()).unwrap();
    [
        Cases::labelled("acdc_walls", opened(shared_data("acdc_walls"))),
        Cases::partners("gated_spect", opened(shared_data("gated_spect/meshes"))),
        Cases::labelled("built-in", built_in.study),
    ]
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_default_smoothing_does_as_well_as_one_chosen_without_the_case() {
    let usual = DeformationMapParams::default().smoothing;
    let usual = RADII.iter().position(|radius| *radius == usual).unwrap();
    for cases in all() {
        println!(
            "{}: nearest neighbour | linear | in the plane | τ",
            cases.name
        );
        let mut curve = Vec::new();
        for radius in RADII {
            let parts = cases.parts(&PoseDistanceParams::default(), radius);
            let [alone, both] = [PartWeights::DEFORMATION, PartWeights::BOTH]
                .map(|weights| cases.row(&parts.weighted(weights)));
            println!("| {radius} | {alone} | with shape {both} |");
            curve.push(parts.deformation);
        }
        let nested = cases.nested(&curve);
        let right = nested.iter().filter(|(_, right)| *right).count();
        let chosen = RADII.map(|radius| nested.iter().filter(|(r, _)| *r == radius).count());
        println!(
            "nested: {right} of {} right, radii chosen {chosen:?} times",
            nested.len()
        );
        let usual = cases.count_right(&curve[usual], None);
        assert!(10 * usual >= 9 * right, "{usual}, nested {right}");
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn no_other_metric_tells_deformations_apart_much_better_than_the_default() {
    use MetricKind::{AnglePreserving, Displacement, Isometric, QuasiConformal};
    let default = MetricParams::default();
    let quasi = MetricParams::of(QuasiConformal);
    let mixed = MetricParams {
        mu: 1e-3,
        lambda: 3.0,
        ..quasi
    };
    for cases in all() {
        println!(
            "{}: nearest neighbour | linear | in the plane | τ",
            cases.name
        );
        let normal_or_not = cases.normal_or_not();
        let mut counts = Vec::new();
        for (name, metric, kind) in [
            ("displacement (default)", default, None),
            ("displacement, motions copied", default, Some(Displacement)),
            (
                "displacement, motions transported by angles",
                default,
                Some(AnglePreserving),
            ),
            ("angle-preserving", MetricParams::of(AnglePreserving), None),
            ("isometric", MetricParams::of(Isometric), None),
            (
                "quasi-conformal, motions transported by lengths",
                quasi,
                Some(Isometric),
            ),
            ("quasi-conformal, μ = 0.001, λ = 3", mixed, None),
        ] {
            let poses = PoseDistanceParams {
                metric,
                transport: Some(CohortTransportParams {
                    kind,
                    ..CohortTransportParams::default()
                }),
                ..PoseDistanceParams::default()
            };
            let parts = cases.parts(&poses, DeformationMapParams::default().smoothing);
            let two = (normal_or_not.as_ref()).map_or_else(String::new, |two| {
                format!("; normal or not {}", two.row(&parts.deformation))
            });
            println!("| {name} | {}{two} |", cases.row(&parts.deformation));
            counts.push(cases.count_right(&parts.deformation, None));
        }
        let best = counts.iter().max().copied().unwrap_or_default();
        // Patients are recognised by what transport leaves of their shape, which is no merit.
        let motions_alone = normal_or_not.is_some();
        assert!(!motions_alone || 10 * counts[0] >= 9 * best, "{counts:?}");
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn rest_and_stress_of_one_patient_deform_alike() {
    let cases = Cases::partners("gated_spect", opened(shared_data("gated_spect/meshes")));
    let parts = cases.parts(
        &PoseDistanceParams::default(),
        DeformationMapParams::default().smoothing,
    );
    let right = cases.count_right(&parts.deformation, None);
    let both = cases.count_right(&parts.weighted(PartWeights::BOTH), None);
    // 8 and 10 of 20; in random order one.
    assert!(right >= 6 && both >= 8, "{right}, with shape {both}");
    // What is chosen without a patient does as well on that patient.
    let curve = [0.0, 0.1].map(|radius| {
        cases
            .parts(&PoseDistanceParams::default(), radius)
            .deformation
    });
    let nested = cases
        .nested(&curve)
        .iter()
        .filter(|(_, right)| *right)
        .count();
    assert!(nested + 2 >= right, "{nested} of {right}");
}
