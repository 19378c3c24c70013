//! Atoms, numbers and borders of a wall between two bowls.

use std::sync::Arc;

use crate::analysis::medial::{MedialBeat, MedialParams, medial_beat};
use crate::mesh::phantom;
use crate::picture::{
    PreparedSubject, Quantity, SceneSettings, SubjectExtras, SurfaceRole, scene_with_extras,
};
use crate::progress::Progress;
use crate::render::{GeometryPose, SurfaceColour};
use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

use super::*;

fn wall() -> Subject {
    let side = |kind, radii: [f64; 2]| {
        let frames = radii.map(|radius| phantom::bowl(radius, 10, 24)).to_vec();
        SurfaceSequence::new(kind, frames).unwrap()
    };
    let sequence = MeshSequence::new(vec![
        side(SurfaceKind::Endocardium, [24.0, 20.0]),
        side(SurfaceKind::Epicardium, [32.0, 32.0]),
    ])
    .unwrap();
    Subject::new("P", sequence, LengthUnit::Millimetre)
}

fn beat(subject: &Subject) -> Arc<MedialBeat> {
    let params = MedialParams {
        smoothing: 0.0,
        ..MedialParams::default()
    };
    let params = params.check().unwrap();
    Arc::new(medial_beat(subject, &params, &Progress::default()).unwrap())
}

#[test]
fn the_outer_wall_takes_the_number_of_the_atom_whose_spoke_ends_there() {
    let subject = wall();
    let medial = PreparedMedial::new(&subject, &beat(&subject), 0);
    let heart = PreparedSubject::new(&subject, 0);
    let numbers = medial.numbers(&heart).unwrap();
    for role in [SurfaceRole::Inner, SurfaceRole::Outer] {
        let values = &numbers.of(role).unwrap().values;
        assert_eq!(values.len(), 2);
        let known: Vec<f32> = values[1].iter().copied().filter(|v| !v.is_nan()).collect();
        assert!(known.len() > values[1].len() / 2);
        // The wall is 8 thick, then 12.
        assert!(known.iter().all(|ratio| (ratio - 1.5).abs() < 0.05));
        let rest = values[0].iter().filter(|v| !v.is_nan());
        assert!(rest.into_iter().all(|&ratio| ratio == 1.0));
    }
}

#[test]
fn between_frames_numbers_and_poses_go_in_proportion() {
    let subject = wall();
    let medial = PreparedMedial::new(&subject, &beat(&subject), 0);
    let pose = |frame: usize| subject.sequence.pose(frame).unwrap();
    let between = [pose(0), pose(1), pose(1)];
    let heart = PreparedSubject::with_interpolated_poses(&subject, 0, &[&between, &[]]);
    let place = |from, to, blend| heart.pose_in_frames(GeometryPose { from, to, blend });
    assert_eq!((place(1, 2, 0.0).from, place(1, 2, 0.0).blend), (0, 0.25));
    assert_eq!(place(1, 2, 0.5).blend, 0.375);
    assert_eq!((place(4, 4, 0.0).from, place(4, 4, 0.0).blend), (1, 0.0));
    let numbers = medial.numbers(&heart).unwrap();
    let values = &numbers.of(SurfaceRole::Inner).unwrap().values;
    let vertex = (0..values[4].len())
        .find(|&v| !values[4][v].is_nan())
        .unwrap();
    let end = values[4][vertex];
    assert!((values[2][vertex] - (1.0 + 0.5 * (end - 1.0))).abs() < 1e-5);
}

#[test]
fn discs_lie_on_the_medial_surface_and_do_not_touch() {
    let subject = wall();
    let beat = beat(&subject);
    let medial = PreparedMedial::new(&subject, &beat, 0);
    let regular = beat.regular.iter().filter(|&&on| on).count();
    assert_eq!(medial.discs.positions[0].len(), regular * medial.corners);
    for frame in 0..2 {
        let atom = (beat.regular.iter().position(|&on| on)).unwrap();
        let pose = GeometryPose {
            from: frame,
            to: frame,
            blend: 0.0,
        };
        let corners = medial.disc(atom as u32, pose);
        let surface = &beat.frames[frame];
        let centre = surface.atoms[atom].position.coords.cast::<f32>();
        let normal = surface.normals[atom].cast::<f32>();
        for corner in corners {
            let offset = nalgebra::Vector3::from(corner) - centre;
            assert!(offset.dot(&normal).abs() < 1e-3);
            assert!(offset.norm() > 0.0);
        }
    }
}

#[test]
fn a_heart_without_numbers_has_no_bar_of_thickness() {
    let subject = wall();
    let heart = PreparedSubject::new(&subject, 0);
    let settings = SceneSettings {
        quantity: Quantity::ThicknessRatio,
        ..SceneSettings::default()
    };
    let scene = scene_with_extras(
        &heart,
        SubjectExtras::default(),
        &settings,
        GeometryPose::default(),
    );
    assert!(scene.legend.is_none());
    assert!(matches!(
        scene.scene.surfaces[0].colour,
        SurfaceColour::Uniform(_)
    ));
}
