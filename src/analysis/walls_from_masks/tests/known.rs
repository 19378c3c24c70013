//! Volumes, forms and directions that are known in closed form.

use crate::analysis::walls_from_masks::{WallParams, walls_from_masks};
use crate::mesh::{ClosestPoint, crossing_faces};
use crate::progress::Progress;
use crate::study::SurfaceKind;

use super::phantom::{Phantom, walls};

#[test]
fn volumes_are_those_of_the_ellipsoids_within_two_percent() {
    let phantom = Phantom::default();
    let walls = walls(&phantom.masks());
    for fit in &walls.fits {
        let kind = usize::from(fit.kind == SurfaceKind::Epicardium);
        let truth = phantom.volumes_ml(fit.frame)[kind];
        assert!(
            (fit.volume_ml / truth - 1.0).abs() < 0.02,
            "{fit:?}, {truth}"
        );
        assert!(
            (fit.volume_ml / fit.mask_volume_ml - 1.0).abs() < 1e-3,
            "{fit:?}"
        );
        assert_eq!(fit.foldovers, 0);
        assert!(fit.mean_mm < 0.5 && fit.p95_mm < 1.1, "{fit:?}");
    }
    assert!(walls.shifts.is_empty(), "{:?}", walls.shifts);
}

#[test]
fn surfaces_lie_on_the_ellipsoids_and_nearer_with_thinner_slices() {
    let mean_off = |pixel, thickness| {
        let phantom = Phantom {
            pixel,
            thickness,
            ..Phantom::default()
        };
        let walls = walls(&phantom.masks());
        let mut off = Vec::new();
        for (surface, kind) in walls.sequence.surfaces().iter().zip(0..) {
            for (mesh, axes) in surface.frames().iter().zip(&phantom.axes) {
                let [a, c]: [f64; 2] = axes[kind];
                off.extend(mesh.vertices().iter().map(|&vertex| {
                    let p = phantom.own(vertex);
                    // To first order, the distance from the ellipsoid f = 1 is |f − 1| / |∇f|.
                    let f = (p.x * p.x + p.y * p.y) / (a * a) + p.z * p.z / (c * c);
                    let slope = 2.0 * (p.x.hypot(p.y) / (a * a)).hypot(p.z / (c * c));
                    (f - 1.0).abs() / slope
                }));
            }
        }
        off.iter().sum::<f64>() / off.len() as f64
    };
    let coarse = mean_off(1.5, 8.0);
    let fine = mean_off(0.75, 4.0);
    assert!(coarse < 0.6, "{coarse}");
    assert!(fine < 0.6 * coarse, "{fine} after {coarse}");
}

#[test]
fn the_epicardium_lies_outside_and_neither_crosses_anything() {
    let walls = walls(&Phantom::default().masks());
    let surfaces = walls.sequence.surfaces();
    for (endo, epi) in surfaces[0].frames().iter().zip(surfaces[1].frames()) {
        let first_epi = endo.vertices().len() as u32;
        let points: Vec<_> = endo
            .vertices()
            .iter()
            .chain(epi.vertices())
            .copied()
            .collect();
        let outer = epi.triangles().iter().map(|t| t.map(|v| v + first_epi));
        let triangles: Vec<_> = endo.triangles().iter().copied().chain(outer).collect();
        assert_eq!(crossing_faces(&points, &triangles, || true), Some(0));
        let tree = ClosestPoint::new(epi.vertices(), epi.triangles()).unwrap();
        let thinnest = endo
            .vertices()
            .iter()
            .map(|&p| (tree.closest(p) - p).norm());
        assert!(thinnest.fold(f64::INFINITY, f64::min) > 3.0);
    }
}

#[test]
fn all_surfaces_have_the_same_faces_and_about_as_many_vertices_as_asked_for() {
    for (asked, expected) in [(481, 481), (800, 775)] {
        let params = WallParams {
            vertices: asked,
            ..WallParams::default()
        };
        let masks = Phantom::default().masks();
        let walls =
            walls_from_masks(&masks, &params.check().unwrap(), &Progress::default()).unwrap();
        let surfaces = walls.sequence.surfaces();
        assert_eq!(surfaces[0].faces(), surfaces[1].faces());
        assert_eq!(surfaces[0].frames().len(), 2);
        assert_eq!(surfaces[0].faces().vertex_count(), expected);
        assert_eq!(surfaces[0].faces().boundary_loops().len(), 1);
    }
}

#[test]
fn directions_are_those_of_the_body() {
    let phantom = Phantom::default();
    let anatomy = walls(&phantom.masks()).anatomy.unwrap();
    let apex = phantom.own(anatomy.apex);
    let base = phantom.own(anatomy.base);
    assert!(
        apex.x.hypot(apex.y) < 1.0 && (apex.z + 79.0).abs() < 3.0,
        "{apex}"
    );
    assert!(base.coords.norm() < 1.0, "{base}");
    let towards = |direction| phantom.own(anatomy.base + direction) - base;
    // The right ventricle lies at negative x, and z points to the base: anterior is at negative y.
    assert!((towards(anatomy.septal).x + 1.0).abs() < 1e-2);
    assert!((towards(anatomy.anterior).y + 1.0).abs() < 1e-2);
    let without = Phantom {
        right: false,
        ..phantom
    };
    let walls = walls(&without.masks());
    assert_eq!(walls.anatomy, None);
    assert!(
        walls
            .notices
            .iter()
            .any(|n| n.text.contains("septum is not known"))
    );
}

#[test]
fn where_the_wall_is_thick_at_the_base_and_the_apex_is_wide_the_right_ventricle_says_which_is_which()
 {
    use super::phantom::with_slices;
    use crate::analysis::walls_from_masks::Tissue;
    let phantom = Phantom::default();
    // The stack ends where the cavity is still wide, and is narrow at the base, as with an aneurysm of the apex.
    let masks = with_slices(&phantom.masks(), |[i, j, k], tissue| {
        let side = phantom.size()[0] as f64 / 2.0;
        let away = (i as f64 - side).hypot(j as f64 - side) * phantom.pixel;
        match tissue {
            _ if k > 6 => Tissue::Other,
            Tissue::Cavity if away > 10.0 + 2.0 * k as f64 => Tissue::Wall,
            other => other,
        }
    });
    let anatomy = walls(&masks).anatomy.unwrap();
    assert!(phantom.own(anatomy.base).z > phantom.own(anatomy.apex).z);
}
