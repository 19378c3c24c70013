//! The built-in subjects have the sizes, motions and illnesses that they were designed with.

use super::*;
use crate::mesh::{CappedSheet, Point3, sheets, vertex_normals};
use crate::study::{Subject, SurfaceKind};

mod turning;

const ENDO: SurfaceKind = SurfaceKind::Endocardium;
const EPI: SurfaceKind = SurfaceKind::Epicardium;

fn small_cohort() -> BuiltInCohort {
    cohort(&BuiltInParams::default()).unwrap()
}

fn vertices(subject: &Subject, kind: SurfaceKind, frame: usize) -> &[Point3] {
    subject.sequence.surface(kind).unwrap().frames()[frame].vertices()
}

fn volumes_ml(subject: &Subject, kind: SurfaceKind) -> Vec<f64> {
    let surface = subject.sequence.surface(kind).unwrap();
    let sheet = &sheets(surface.faces()).unwrap()[0];
    let capped = CappedSheet::new(surface.faces().vertex_count(), sheet).unwrap();
    surface
        .frames()
        .iter()
        .map(|frame| 1e-3 * capped.signed_volume(frame.vertices()))
        .collect()
}

fn extremes(values: &[f64]) -> [f64; 2] {
    values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &v| {
            [low.min(v), high.max(v)]
        })
}

fn ejection_fraction(subject: &Subject) -> f64 {
    let [least, most] = extremes(&volumes_ml(subject, ENDO));
    1.0 - least / most
}

/// Frame of the least volume.
fn end_systole(subject: &Subject) -> usize {
    let volumes = volumes_ml(subject, ENDO);
    let [least, _] = extremes(&volumes);
    volumes.iter().position(|&v| v == least).unwrap()
}

/// Distance from each inner vertex to its outer partner's tangent plane: the thickness of the
/// wall there, to first order.
fn thickness_mm(subject: &Subject, frame: usize) -> Vec<f64> {
    let epi = &subject.sequence.surface(EPI).unwrap().frames()[frame];
    let normals = vertex_normals(epi.vertices(), epi.triangles());
    vertices(subject, ENDO, frame)
        .iter()
        .zip(epi.vertices())
        .zip(&normals)
        .map(|((inner, outer), normal)| (outer - inner).dot(normal))
        .collect()
}

#[test]
fn equal_seeds_give_equal_bits_and_others_other_hearts() {
    let params = BuiltInParams {
        vertices: 400,
        ..BuiltInParams::default()
    };
    let (one, again) = (cohort(&params).unwrap(), cohort(&params).unwrap());
    assert_eq!(one.truths, again.truths);
    assert_eq!(one.study.subjects, again.study.subjects);
    let other = cohort(&BuiltInParams { seed: 7, ..params }).unwrap();
    for (a, b) in one.study.subjects.iter().zip(&other.study.subjects) {
        assert_ne!(vertices(a, ENDO, 0), vertices(b, ENDO, 0));
        assert_eq!(a.sequence.correspondence(), b.sequence.correspondence());
    }
}

#[test]
fn there_are_nine_normal_hearts_and_fourteen_patients_of_eight_poses() {
    let made = small_cohort();
    let ids: Vec<&str> = made.study.subjects.iter().map(|s| s.id.as_str()).collect();
    assert_eq!(ids[0], "N01");
    assert_eq!(ids[8], "N09");
    assert_eq!(ids[9], "P01");
    assert_eq!(ids[22], "P14");
    for (subject, truth) in made.study.subjects.iter().zip(&made.truths) {
        let normal = truth.abnormality == Abnormality::None;
        assert_eq!(
            subject.label.as_deref(),
            Some(if normal { "normal" } else { "abnormal" })
        );
        assert_eq!(normal, subject.id.starts_with('N'));
        assert_eq!(subject.sequence.frame_count(), 8);
        assert!((2_000..=4_000).contains(&subject.sequence.vertex_count()));
        let anatomy = subject.anatomy.unwrap();
        let right_handed = anatomy.septal.cross(&anatomy.anterior);
        assert!(right_handed.dot(&anatomy.long_axis()) > 0.999);
        let rr = subject.timing.rr.unwrap().0;
        assert!((0.6..1.2).contains(&rr));
        let times = subject.timing.frame_times_s.as_ref().unwrap();
        assert!(times[0] == 0.0 && times[7] < rr);
    }
}

#[test]
fn resolution_reaches_from_200_to_40_000_vertices() {
    for vertices in [200, 40_000] {
        let made = cohort(&BuiltInParams {
            vertices,
            ..BuiltInParams::default()
        })
        .unwrap();
        let count = made.study.subjects[0].sequence.vertex_count();
        assert!(count <= vertices && count as f64 > 0.85 * vertices as f64);
    }
    for vertices in [0, 199, 40_001, usize::MAX] {
        let refused = cohort(&BuiltInParams {
            vertices,
            ..BuiltInParams::default()
        });
        assert!(matches!(refused, Err(BuiltInError::Vertices { asked, .. }) if asked == vertices));
    }
}

#[test]
fn every_heart_has_the_volume_and_ejection_fraction_it_was_designed_with() {
    let made = small_cohort();
    for (subject, truth) in made.study.subjects.iter().zip(&made.truths) {
        let volumes = volumes_ml(subject, ENDO);
        let [_, most] = extremes(&volumes);
        assert_eq!(volumes[0], most, "{}: frame 0 is end-diastole", subject.id);
        // Flat faces cut off 0.5 % of the volume at 48 vertices around.
        let faceting = volumes[0] / truth.end_diastolic_volume_ml;
        assert!((0.990..1.0).contains(&faceting), "{faceting}");
        // Lids on rims that a patch tilts, and coarse borders of patches, add to that.
        let error = ejection_fraction(subject) - truth.ejection_fraction;
        assert!(error.abs() < 0.008, "{}: {error}", subject.id);
    }
}

#[test]
fn volumes_converge_to_the_designed_ones_as_the_mesh_is_refined() {
    let errors: Vec<f64> = [600, 2_400, 9_600]
        .into_iter()
        .map(|vertices| {
            let made = cohort(&BuiltInParams {
                vertices,
                ..BuiltInParams::default()
            })
            .unwrap();
            let volume = volumes_ml(&made.study.subjects[3], ENDO)[0];
            1.0 - volume / made.truths[3].end_diastolic_volume_ml
        })
        .collect();
    for pair in errors.windows(2) {
        // Edges halve when vertices quadruple; rings come in whole numbers.
        assert!((2.8..5.5).contains(&(pair[0] / pair[1])), "{errors:?}");
    }
}

#[test]
fn normal_hearts_lie_in_published_ranges() {
    let made = small_cohort();
    for subject in &made.study.subjects[..9] {
        let volumes = volumes_ml(subject, ENDO);
        let ef = ejection_fraction(subject);
        assert!((100.0..190.0).contains(&volumes[0]), "{}", volumes[0]);
        assert!((0.55..0.72).contains(&ef), "{ef}");
        let walls = [0, end_systole(subject)].map(|frame| {
            let mut all = thickness_mm(subject, frame);
            all.sort_by(f64::total_cmp);
            all[all.len() / 2]
        });
        assert!((5.5..11.0).contains(&walls[0]), "{walls:?}");
        let thickening = walls[1] / walls[0] - 1.0;
        assert!(
            (0.30..0.75).contains(&thickening),
            "{}: {thickening}",
            subject.id
        );
    }
}

#[test]
fn dilated_hearts_are_wide_and_weak_and_hypertrophic_ones_thick_and_small() {
    let made = small_cohort();
    for (subject, truth) in made.study.subjects.iter().zip(&made.truths) {
        let edv = volumes_ml(subject, ENDO)[0];
        let ef = ejection_fraction(subject);
        match truth.abnormality {
            Abnormality::Dilated => assert!(edv > 220.0 && (0.15..0.35).contains(&ef)),
            Abnormality::Hypertrophic => {
                let mean = thickness_mm(subject, 0).iter().sum::<f64>()
                    / thickness_mm(subject, 0).len() as f64;
                assert!(edv < 115.0 && mean > 12.0, "{edv} ml, {mean} mm");
            }
            _ => {}
        }
    }
}

#[test]
fn patches_are_as_large_as_their_names_say() {
    let made = small_cohort();
    for (subject, truth) in made.study.subjects.iter().zip(&made.truths) {
        let inner = &subject.sequence.surface(ENDO).unwrap().frames()[0];
        let area = |in_patch: &dyn Fn(u8) -> bool| {
            inner
                .triangles()
                .iter()
                .filter(|t| {
                    t.iter()
                        .all(|&v| in_patch(truth.surfaces[0].patch[v as usize]))
                })
                .map(|t| crate::mesh::area(inner.vertices(), &[*t]))
                .sum::<f64>()
        };
        let share = area(&|patch| patch > 0) / area(&|_| true);
        let expected = match truth.abnormality {
            Abnormality::SmallPatch => 0.03..0.085,
            Abnormality::MediumPatch => 0.085..0.17,
            Abnormality::LargePatch => 0.17..0.32,
            Abnormality::VeryLargePatch => 0.32..0.60,
            Abnormality::TwoPatches => 0.08..0.30,
            _ => 0.0..1e-9,
        };
        assert!(expected.contains(&share), "{}: {share}", subject.id);
    }
}

#[test]
fn a_large_patch_lowers_the_ejection_fraction_and_a_very_large_one_more() {
    let made = small_cohort();
    let mean_ef = |kind: Abnormality| {
        let of_kind = made.truths.iter().filter(|t| t.abnormality == kind);
        let fractions: Vec<f64> = of_kind.map(|truth| truth.ejection_fraction).collect();
        fractions.iter().sum::<f64>() / fractions.len() as f64
    };
    let [medium, large, very_large] = [
        Abnormality::MediumPatch,
        Abnormality::LargePatch,
        Abnormality::VeryLargePatch,
    ]
    .map(mean_ef);
    assert!(very_large < large - 0.04 && large < medium - 0.04);
}

#[test]
fn the_wall_keeps_its_volume_through_the_beat() {
    let made = small_cohort();
    for subject in &made.study.subjects {
        let wall: Vec<f64> = volumes_ml(subject, EPI)
            .iter()
            .zip(volumes_ml(subject, ENDO))
            .map(|(outer, inner)| outer - inner)
            .collect();
        // The motion is exactly incompressible; flat faces, and the flat lids on rims that
        // patches warp, leave about a percent.
        for volume in &wall {
            assert!(
                (volume / wall[0] - 1.0).abs() < 0.02,
                "{}: {wall:?}",
                subject.id
            );
        }
    }
}

#[test]
fn the_apex_is_still_and_the_base_descends() {
    let made = small_cohort();
    for (subject, truth) in made.study.subjects.iter().zip(&made.truths) {
        let anatomy = subject.anatomy.unwrap();
        let es = end_systole(subject);
        let apex = |frame: usize| vertices(subject, EPI, frame)[0];
        for frame in 0..8 {
            assert!((apex(frame) - apex(0)).norm() < 1e-9);
        }
        let rim = &subject
            .sequence
            .surface(ENDO)
            .unwrap()
            .faces()
            .boundary_loops()[0];
        let height = |frame: usize| {
            let points = vertices(subject, ENDO, frame);
            rim.iter()
                .map(|&v| (points[v as usize] - apex(0)).dot(&anatomy.long_axis()))
                .sum::<f64>()
                / rim.len() as f64
        };
        let descent = height(0) - height(es);
        let expected = match truth.abnormality {
            Abnormality::None => 9.0..18.0,
            Abnormality::Dilated => 2.0..9.0,
            _ => 2.0..16.0,
        };
        assert!(expected.contains(&descent), "{}: {descent} mm", subject.id);
    }
}

#[test]
fn a_patch_neither_thickens_nor_moves_inwards_while_the_rest_does_both() {
    let made = small_cohort();
    for (subject, truth) in made.study.subjects.iter().zip(&made.truths) {
        if truth.patches == 0 {
            continue;
        }
        let es = end_systole(subject);
        let (before, after) = (thickness_mm(subject, 0), thickness_mm(subject, es));
        let anatomy = subject.anatomy.unwrap();
        let axis = anatomy.long_axis();
        let radius = |point: &Point3| {
            let offset = point - anatomy.apex;
            (offset - axis * axis.dot(&offset)).norm()
        };
        let [inner, outer] = [0, 1].map(|surface| &truth.surfaces[surface].severity);
        let mean = |wanted: &dyn Fn(f64) -> bool, value: &dyn Fn(usize) -> f64| {
            let chosen: Vec<usize> = (0..inner.len())
                .filter(|&v| wanted(inner[v]) && wanted(outer[v]))
                .collect();
            assert!(chosen.len() > 10, "{}: {}", subject.id, chosen.len());
            chosen.iter().map(|&v| value(v)).sum::<f64>() / chosen.len() as f64
        };
        let thickening = |v: usize| after[v] / before[v];
        let (p, q) = (vertices(subject, ENDO, 0), vertices(subject, ENDO, es));
        let inward = |v: usize| (radius(&p[v]) - radius(&q[v])) / radius(&p[v]).max(5.0);
        let (ill, well) = (|s: f64| s > 0.93, |s: f64| s < 0.02);
        let thickenings = [mean(&ill, &thickening), mean(&well, &thickening)];
        let motions = [mean(&ill, &inward), mean(&well, &inward)];
        assert!(
            (0.93..1.12).contains(&thickenings[0]),
            "{}: {thickenings:?}",
            subject.id
        );
        assert!(thickenings[1] > 1.25, "{}: {thickenings:?}", subject.id);
        assert!(motions[0].abs() < 0.08, "{}: {motions:?}", subject.id);
        assert!(motions[1] > 0.2, "{}: {motions:?}", subject.id);
    }
}

#[test]
fn patches_lie_in_the_segments_they_were_put_in() {
    let made = small_cohort();
    let segments = |id: &str| {
        let index = made.study.index_of(id).unwrap();
        made.truths[index].segments.clone()
    };
    assert!(segments("P01").contains(&11));
    assert!(segments("P02").contains(&7));
    assert!(segments("P03").contains(&10));
    assert!(segments("P07").contains(&17));
    assert!(segments("P10").contains(&17) && segments("P10").contains(&3));
    assert!(segments("N01").is_empty() && segments("P11").is_empty());
    assert!(segments("P07").len() > segments("P05").len());
}

#[test]
fn the_outer_surface_is_outside_the_inner_one_at_every_frame() {
    let made = small_cohort();
    for subject in &made.study.subjects {
        let surface = subject.sequence.surface(EPI).unwrap();
        let sheet = &sheets(surface.faces()).unwrap()[0];
        let capped = CappedSheet::new(surface.faces().vertex_count(), sheet).unwrap();
        for frame in 0..8 {
            let outer = vertices(subject, EPI, frame);
            let inner = vertices(subject, ENDO, frame);
            // Rims lie side by side in the base; a few rings below it inside is plain.
            for point in inner[..inner.len() - 150].iter().step_by(29) {
                assert!(
                    capped.winding_number(outer, *point) > 0.99,
                    "{}",
                    subject.id
                );
            }
            let least = extremes(&thickness_mm(subject, frame))[0];
            assert!(least > 3.0, "{}: {least} mm at frame {frame}", subject.id);
        }
    }
}
