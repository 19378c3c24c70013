//! Numbers on a heart that it does not have by itself: how it differs from another one.

use std::sync::Arc;

use crate::mesh::Point3;
use crate::picture::prepared::{PreparedSubject, SurfaceRole, gathered};
use crate::picture::quantity::Quantity;
use crate::render::VertexScalars;

/// Numbers on every surface of one prepared heart.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceScalars {
    /// What they stand for.
    pub quantity: Quantity,
    surfaces: Vec<(SurfaceRole, Arc<VertexScalars>)>,
}

impl SurfaceScalars {
    /// Divides numbers over the surfaces of a heart. `lists` has one list for all poses or one per
    /// pose, each with a number per vertex of all surfaces, one surface after the other. `None`
    /// where counts do not fit.
    pub fn of_heart(
        prepared: &PreparedSubject,
        quantity: Quantity,
        lists: &[Vec<f32>],
    ) -> Option<Self> {
        let mut offset = 0;
        let mut surfaces: Vec<(SurfaceRole, Arc<VertexScalars>)> = Vec::new();
        for surface in &prepared.surfaces {
            if surface.role == SurfaceRole::Rim {
                continue;
            }
            let count = surface.geometry.positions.first()?.len();
            let values = lists
                .iter()
                .map(|list| list.get(offset..offset + count).map(<[f32]>::to_vec))
                .collect::<Option<Vec<_>>>()?;
            offset += count;
            surfaces.push((surface.role, Arc::new(VertexScalars { values })));
        }
        if lists.is_empty() || lists.iter().any(|list| list.len() != offset) {
            return None;
        }
        let of = |wanted| surfaces.iter().find(|(role, _)| *role == wanted);
        if let Some(rim) = &prepared.rim
            && let (Some((_, inner)), Some((_, outer))) =
                (of(SurfaceRole::Inner), of(SurfaceRole::Outer))
        {
            let frames = inner.values.iter().zip(&outer.values);
            let values = frames.map(|(a, b)| gathered(rim, a, b)).collect();
            surfaces.push((SurfaceRole::Rim, Arc::new(VertexScalars { values })));
        }
        Some(Self { quantity, surfaces })
    }

    /// The numbers of the surface that plays a part.
    pub fn of(&self, role: SurfaceRole) -> Option<&Arc<VertexScalars>> {
        self.surfaces
            .iter()
            .find(|(other, _)| *other == role)
            .map(|(_, scalars)| scalars)
    }
}

/// How densely faces contribute to a whole, at every vertex, relative to the mean: 1 everywhere if
/// each part of the surface contributes by its area.
///
/// With cᶠ the contribution of face f, aᶠ the mean of its shares of the areas of both poses, and
/// sums over the faces around vertex v: ρᵥ = (Σ cᶠ / Σ c) / Σ aᶠ. NaN, which is shown grey, where
/// faces have no area; `None` where counts do not fit or nothing contributes.
pub fn relative_density(
    faces: &[[u32; 3]],
    poses: [&[Point3]; 2],
    contributions: &[f64],
) -> Option<Vec<f32>> {
    let count = poses[0].len();
    let total: f64 = contributions.iter().sum();
    let fits = poses[1].len() == count && contributions.len() == faces.len();
    let in_range = |face: &[u32; 3]| face.iter().all(|&vertex| (vertex as usize) < count);
    if !(fits && faces.iter().all(in_range) && total.is_finite() && total > 0.0) {
        return None;
    }
    let areas = poses.map(|points| relative_areas(faces, points));
    let mut shares = vec![[0.0_f64; 2]; count];
    for (index, face) in faces.iter().enumerate() {
        let area = 0.5 * (areas[0][index] + areas[1][index]);
        for &vertex in face {
            let share = &mut shares[vertex as usize];
            share[0] += contributions[index] / total;
            share[1] += area;
        }
    }
    let density = |[contribution, area]: [f64; 2]| {
        if area > 0.0 {
            (contribution / area) as f32
        } else {
            f32::NAN
        }
    };
    Some(shares.into_iter().map(density).collect())
}

/// Each face's share of the whole area; zeros where there is none.
fn relative_areas(faces: &[[u32; 3]], points: &[Point3]) -> Vec<f64> {
    let area = |face: &[u32; 3]| {
        let [a, b, c] = face.map(|vertex| points[vertex as usize]);
        0.5 * (b - a).cross(&(c - a)).norm()
    };
    let mut areas: Vec<f64> = faces.iter().map(area).collect();
    let total: f64 = areas.iter().sum();
    if total > 0.0 {
        areas.iter_mut().for_each(|area| *area /= total);
    }
    areas
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::picture::{SceneSettings, SubjectExtras, scene_with_extras};
    use crate::render::{GeometryPose, SurfaceColour};
    use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;

    fn wall() -> Subject {
        let side = |kind, radius| {
            SurfaceSequence::new(kind, vec![phantom::bowl(radius, 4, 12); 2]).unwrap()
        };
        let sequence = MeshSequence::new(vec![
            side(SurfaceKind::Endocardium, 20.0),
            side(SurfaceKind::Epicardium, 30.0),
        ])
        .unwrap();
        Subject::new("P", sequence, LengthUnit::Millimetre)
    }

    #[test]
    fn what_contributes_by_area_has_density_one_everywhere() {
        let sphere = phantom::sphere(2, 25.0);
        let faces = sphere.triangles();
        let points = sphere.vertices();
        let larger: Vec<Point3> = points
            .iter()
            .map(|p| Point3::from(2.0 * p.coords))
            .collect();
        let contributions = relative_areas(faces, points)
            .iter()
            .map(|a| 7.0 * a)
            .collect::<Vec<_>>();
        let density = relative_density(faces, [points, &larger], &contributions).unwrap();
        assert!(density.iter().all(|d| (d - 1.0).abs() < 1e-5));
        // All of it in one face: its corners stand out, the opposite side has nothing.
        let mut one = vec![0.0; faces.len()];
        one[0] = 3.0;
        let density = relative_density(faces, [points, points], &one).unwrap();
        for (vertex, value) in density.iter().enumerate() {
            let corner = faces[0].contains(&(vertex as u32));
            assert_eq!(*value > 10.0, corner, "vertex {vertex}: {value}");
        }
    }

    #[test]
    fn numbers_that_do_not_fit_are_refused() {
        let sphere = phantom::sphere(1, 25.0);
        let (faces, points) = (sphere.triangles(), sphere.vertices());
        let zeros = vec![0.0; faces.len()];
        assert_eq!(relative_density(faces, [points, points], &zeros), None);
        assert_eq!(
            relative_density(faces, [points, &points[1..]], &zeros),
            None
        );
        assert_eq!(relative_density(faces, [points, points], &[1.0]), None);
        let heart = PreparedSubject::new(&wall(), 0);
        let quantity = Quantity::Contribution;
        assert_eq!(SurfaceScalars::of_heart(&heart, quantity, &[]), None);
        assert_eq!(
            SurfaceScalars::of_heart(&heart, quantity, &[vec![0.0; 5]]),
            None
        );
    }

    #[test]
    fn a_difference_is_drawn_with_its_legend_and_nothing_where_there_is_none() {
        let subject = wall();
        let heart = PreparedSubject::new(&subject, 0);
        let count = subject.sequence.vertex_count();
        let list: Vec<f32> = (0..count).map(|vertex| vertex as f32).collect();
        let numbers = SurfaceScalars::of_heart(&heart, Quantity::Contribution, &[list]).unwrap();
        let settings = SceneSettings {
            quantity: Quantity::Contribution,
            ..SceneSettings::default()
        };
        let scene = |numbers| {
            let extras = SubjectExtras {
                numbers,
                medial: None,
            };
            scene_with_extras(&heart, extras, &settings, GeometryPose::default())
        };
        let drawn = scene(Some(&numbers));
        let legend = drawn.legend.unwrap();
        assert_eq!(
            legend.heading(),
            "Contribution to the distance, relative to the mean"
        );
        assert!(legend.above, "vertex numbers go beyond four");
        let SurfaceColour::Scalars { scalars, .. } = &drawn.scene.surfaces[0].colour else {
            panic!("the inner side carries the numbers");
        };
        assert_eq!(scalars.values[0][3], 3.0);
        let rim = numbers.of(SurfaceRole::Rim).unwrap();
        let inner = subject.sequence.surfaces()[0].faces().vertex_count() as f32;
        assert!(
            rim.values[0].iter().any(|value| *value >= inner),
            "the rim joins both sides"
        );
        let bare = scene(None);
        assert_eq!(bare.legend, None);
        assert!(matches!(
            bare.scene.surfaces[0].colour,
            SurfaceColour::Uniform(_)
        ));
    }
}
