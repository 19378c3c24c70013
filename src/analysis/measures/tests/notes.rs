//! Measures that are missing say why, and no number is made up in their place.

use super::*;

/// Balls of these radii as a cavity.
fn beating(radii: &[f64]) -> Subject {
    let frames = radii.iter().map(|&radius| phantom::sphere(2, radius));
    subject(
        vec![(SurfaceKind::Cavity, frames.collect())],
        LengthUnit::Millimetre,
    )
}

#[test]
fn a_frame_that_is_both_phases_has_no_ejection_fraction_and_says_why() {
    let with = |radii: &[f64], phases: [Option<usize>; 2]| {
        let mut subject = beating(radii);
        [subject.end_diastole, subject.end_systole] = phases;
        measure_subject(&subject)
    };
    let systole = with(&[20.0], [None, Some(0)]);
    assert_eq!((systole.edv, systole.ef, systole.sv), (None, None, None));
    assert!(systole.esv.is_some());
    assert_eq!(systole.notes, [MeasureNote::EndSystoleOnly]);
    assert_eq!(with(&[20.0], [None, None]).notes, [MeasureNote::OneFrame]);
    assert_eq!(
        with(&[20.0], [Some(0), None]).notes,
        [MeasureNote::OneFrame]
    );
    assert_eq!(
        with(&[20.0], [Some(0); 2]).notes,
        [MeasureNote::SameFrame(0)]
    );
    for (radii, phases, note) in [
        (
            &[20.0, 18.0, 19.0][..],
            [Some(1), Some(1)],
            MeasureNote::SameFrame(1),
        ),
        // End-systole is said to be the largest frame, end-diastole the smallest.
        (
            &[20.0, 18.0, 19.0],
            [None, Some(0)],
            MeasureNote::SameFrame(0),
        ),
        (
            &[20.0, 18.0, 19.0],
            [Some(1), None],
            MeasureNote::SameFrame(1),
        ),
        (&[20.0, 20.0, 20.0], [None, None], MeasureNote::EqualVolumes),
        (
            &[20.0, 18.0, 20.0],
            [Some(0), Some(2)],
            MeasureNote::EqualVolumes,
        ),
        (&[20.0, 20.0], [Some(0), Some(1)], MeasureNote::EqualVolumes),
    ] {
        let found = with(radii, phases);
        assert_eq!((found.sv, found.ef), (None, None), "{note:?}");
        assert_eq!(found.notes, [note]);
    }
    let sound = with(&[20.0, 18.0], [None, None]);
    assert!(sound.ef.is_some() && sound.notes.is_empty());
}

/// Two bowls as a wall, the outer one placed as asked.
fn bowls(outer_radius: f64, place: impl Fn(&Point3) -> Point3) -> Subject {
    let away = nalgebra::Vector3::new(40.0, 25.0, -90.0);
    let bowl = |radius: f64| moved(&phantom::bowl(radius, 8, 24), |p| p + away);
    let inner = [24.0, 19.0].map(bowl).to_vec();
    let outer = [outer_radius, outer_radius - 1.0]
        .map(|r| moved(&bowl(r), &place))
        .to_vec();
    subject(
        vec![
            (SurfaceKind::Endocardium, inner),
            (SurfaceKind::Epicardium, outer),
        ],
        LengthUnit::Millimetre,
    )
}

#[test]
fn surfaces_that_make_no_wall_have_volumes_but_no_mass_and_say_why() {
    let sound = measure_subject(&bowls(33.0, |p| *p));
    assert!(sound.mass.is_some() && sound.notes.is_empty());
    let flipped = |p: &Point3| Point3::new(-p.x, -p.y, p.z);
    let around_both = |p: &Point3| Point3::new(p.x + (p.x - 40.0).max(0.0) * 1.2, p.y, p.z);
    for (what, found) in [
        ("LPS", measure_subject(&bowls(33.0, flipped))),
        (
            "different units",
            measure_subject(&bowls(33.0, |p| {
                let apex = Point3::new(40.0, 25.0, -90.0);
                apex + (p - apex) * 10.0
            })),
        ),
        (
            "right ventricle",
            measure_subject(&bowls(33.0, around_both)),
        ),
    ] {
        assert_eq!(found.mass, None, "{what}");
        assert!(found.frames.iter().all(|frame| frame.wall_volume.is_none()));
        assert_eq!((found.edv, found.ef), (sound.edv, sound.ef));
        assert!(found.frames[0].epi_volume.is_some());
        let notes: Vec<String> = found.notes.iter().map(ToString::to_string).collect();
        assert!(notes.len() == 1 && notes[0].contains(what), "{notes:?}");
    }
}

#[test]
fn measures_far_from_the_origin_are_those_at_the_origin() {
    let here = bowls(33.0, |p| *p);
    for far in [1e6, 1e8] {
        let shift = nalgebra::Vector3::new(far, -far, far);
        let surfaces = here.sequence.surfaces().iter().map(|surface| {
            let frames = surface
                .frames()
                .iter()
                .map(|mesh| moved(mesh, |p| p + shift));
            (surface.kind(), frames.collect())
        });
        let there = subject(surfaces.collect(), LengthUnit::Millimetre);
        let (near, far) = (measure_subject(&here), measure_subject(&there));
        let sizes = |m: &SubjectMeasures| {
            [m.edv, m.esv, m.ef, m.mass.map(|mass| mass.0)].map(Option::unwrap)
        };
        for (a, b) in sizes(&near).into_iter().zip(sizes(&far)) {
            // Coordinates of 10⁸ are rounded to 1.5·10⁻⁸.
            assert!((a - b).abs() < 1e-8 * a, "{a} {b}");
        }
        assert_eq!(near.notes, far.notes);
    }
}
