//! A prepared heart at a pose as a scene, with the legend of its colours.

use std::sync::Arc;

use crate::picture::fitted_camera::blended;
use crate::picture::legend::{ColourLegend, USER_LIMITS};
use crate::picture::medial::{SubjectMedial, add_marks, atom_legend};
use crate::picture::prepared::{PreparedSubject, PreparedSurface, SurfaceRole};
use crate::picture::quantity::Quantity;
use crate::picture::scene_settings::SceneSettings;
use crate::picture::surface_scalars::SurfaceScalars;
use crate::picture::tokens::{
    ENDOCARDIUM, EPICARDIUM, EPICARDIUM_OPACITY, OTHER_SURFACE, SILHOUETTE, TRANSLUCENT_SILHOUETTE,
    WALL_CUT,
};
use crate::render::{
    ColourRange, GeometryPose, Points, Scene, Surface, SurfaceColour, VertexScalars, Wireframe,
};
use crate::study::SurfaceKind;

/// A scene and what its colours mean.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectScene {
    /// What is to be drawn.
    pub scene: Scene,
    /// The colour bar; `None` where colours are tissue.
    pub legend: Option<ColourLegend>,
    /// The colour bar of atoms, where the surfaces have another one.
    pub atom_legend: Option<ColourLegend>,
}

/// What a heart has beside its surfaces.
#[derive(Clone, Copy, Debug, Default)]
pub struct SubjectExtras<'a> {
    /// Numbers from an analysis.
    pub numbers: Option<&'a SurfaceScalars>,
    /// The middle of its wall.
    pub medial: Option<SubjectMedial<'a>>,
}

/// The scene of a heart at a pose. Cheap: all large arrays are those of `prepared`.
pub fn subject_scene(
    prepared: &PreparedSubject,
    settings: &SceneSettings,
    pose: GeometryPose,
) -> SubjectScene {
    scene_with_extras(prepared, SubjectExtras::default(), settings, pose)
}

/// The scene of a heart with what it does not have by itself, such as its difference to another
/// heart or its medial surface. A quantity of an analysis without numbers is shown as tissue, without a legend.
pub fn scene_with_extras(
    prepared: &PreparedSubject,
    extras: SubjectExtras<'_>,
    settings: &SceneSettings,
    pose: GeometryPose,
) -> SubjectScene {
    let numbers = extras.numbers;
    let last = prepared.pose_count().saturating_sub(1);
    let pose = GeometryPose {
        from: pose.from.min(last),
        to: pose.to.min(last),
        blend: pose.blend.clamp(0.0, 1.0),
    };
    let limits = limits(settings);
    let shown: Vec<&PreparedSurface> = prepared
        .surfaces
        .iter()
        .filter(|surface| shows(surface.role, settings))
        .collect();
    let surfaces = shown
        .iter()
        .map(|surface| drawn(surface, numbers, settings, limits, pose))
        .collect();
    let points = if settings.vertices {
        shown
            .iter()
            .filter(|surface| surface.role != SurfaceRole::Rim)
            .map(|surface| vertex_discs(surface, settings, pose))
            .collect()
    } else {
        Vec::new()
    };
    let [red, green, blue] = settings.theme.background;
    let opacity = if settings.transparent { 0.0 } else { 1.0 };
    let coloured = shown
        .iter()
        .filter(|surface| is_coloured(surface, settings));
    let coloured: Vec<_> = coloured
        .filter_map(|surface| scalars(surface, numbers, settings.quantity))
        .collect();
    let extremes = coloured
        .iter()
        .flat_map(|scalars| scalars.values.iter().flatten())
        .filter(|value| !value.is_nan())
        .fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], &value| {
            [low.min(value), high.max(value)]
        });
    let legend = ColourLegend::of(
        settings.quantity,
        prepared.unit,
        limits,
        limits_note(settings),
        extremes,
    );
    let explained = !settings.quantity.is_analysed() || !coloured.is_empty();
    let mut scene = Scene {
        surfaces,
        lines: Vec::new(),
        points,
        background: [red, green, blue, opacity],
    };
    let mut legend = legend.filter(|_| explained);
    let mut atoms = None;
    if let Some(medial) = &extras.medial {
        let pose = prepared.pose_in_frames(pose);
        add_marks(&mut scene, medial, prepared, settings, pose);
        let shown = settings.medial.atoms && settings.quantity != Quantity::ThicknessRatio;
        atoms = (shown || (settings.medial.atoms && legend.is_none()))
            .then(|| atom_legend(medial, prepared, settings))
            .flatten();
    }
    if legend.is_none() {
        legend = atoms.take();
    }
    SubjectScene {
        legend,
        atom_legend: atoms,
        scene,
    }
}

fn shows(role: SurfaceRole, settings: &SceneSettings) -> bool {
    match role {
        SurfaceRole::Inner => settings.inner,
        SurfaceRole::Outer => settings.outer,
        SurfaceRole::Rim => settings.rim && settings.inner && settings.outer,
        SurfaceRole::Alone(SurfaceKind::Epicardium | SurfaceKind::Wall) => settings.outer,
        SurfaceRole::Alone(_) => settings.inner,
    }
}

/// The outer side has colours only where it is not seen through.
fn is_coloured(surface: &PreparedSurface, settings: &SceneSettings) -> bool {
    !(surface.role == SurfaceRole::Outer && settings.inner)
}

fn scalars<'a>(
    surface: &'a PreparedSurface,
    numbers: Option<&'a SurfaceScalars>,
    quantity: Quantity,
) -> Option<&'a Arc<VertexScalars>> {
    surface.scalars(quantity).or_else(|| {
        numbers
            .filter(|numbers| numbers.quantity == quantity)
            .and_then(|numbers| numbers.of(surface.role))
    })
}

fn limits(settings: &SceneSettings) -> ColourRange {
    let range = settings.cohort_ranges.range(settings.quantity);
    match settings.typed_limits {
        Some([low, high]) if high > low && (low > 0.0 || !range.logarithmic) => ColourRange {
            low: low as f32,
            high: high as f32,
            logarithmic: range.logarithmic,
        },
        _ => range,
    }
}

fn limits_note(settings: &SceneSettings) -> &'static str {
    match (settings.typed_limits, settings.quantity) {
        (Some(_), _) => USER_LIMITS,
        (None, Quantity::AreaRatio | Quantity::ThicknessRatio) => "fixed limits, log scale",
        (None, Quantity::Contribution) => "fixed limits, at the nearest frames",
        (None, _) => "one range for the cohort",
    }
}

fn drawn(
    surface: &PreparedSurface,
    numbers: Option<&SurfaceScalars>,
    settings: &SceneSettings,
    limits: ColourRange,
    pose: GeometryPose,
) -> Surface {
    let translucent = surface.role == SurfaceRole::Outer && settings.inner;
    let scalars = scalars(surface, numbers, settings.quantity).filter(|_| !translucent);
    let colour = match scalars.zip(settings.quantity.colour_map()) {
        Some((scalars, map)) => SurfaceColour::Scalars {
            scalars: Arc::clone(scalars),
            map: map.colours,
            limits,
            below: map.below,
            above: map.above,
        },
        None => SurfaceColour::Uniform(tissue(surface.role)),
    };
    let edges = settings.wireframe && surface.role != SurfaceRole::Rim;
    Surface {
        geometry: Arc::clone(&surface.geometry),
        pose,
        colour,
        opacity: if translucent { EPICARDIUM_OPACITY } else { 1.0 },
        shading: settings.shading,
        wireframe: edges.then_some(Wireframe {
            colour: settings.theme.wireframe,
            width: 1.0,
        }),
        silhouette: if translucent {
            TRANSLUCENT_SILHOUETTE
        } else {
            SILHOUETTE
        },
        // A click on a heart means the wall under the pointer, not the glass around it.
        pickable: !translucent && surface.role != SurfaceRole::Rim,
    }
}

fn tissue(role: SurfaceRole) -> [f32; 3] {
    match role {
        SurfaceRole::Inner => ENDOCARDIUM,
        SurfaceRole::Outer => EPICARDIUM,
        SurfaceRole::Rim => WALL_CUT,
        SurfaceRole::Alone(SurfaceKind::Other) => OTHER_SURFACE,
        SurfaceRole::Alone(SurfaceKind::Epicardium) => EPICARDIUM,
        SurfaceRole::Alone(_) => ENDOCARDIUM,
    }
}

fn vertex_discs(surface: &PreparedSurface, settings: &SceneSettings, pose: GeometryPose) -> Points {
    let positions = &surface.geometry.positions;
    let [red, green, blue] = settings.theme.text;
    Points {
        positions: Arc::new(blended(&positions[pose.from], &positions[pose.to], pose)),
        colours: Arc::new(vec![[red, green, blue, 1.0]]),
        diameter: 3.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{MeshSequence, Subject, SurfaceSequence};
    use crate::units::LengthUnit;

    fn heart() -> PreparedSubject {
        let side = |kind, radii: [f64; 2]| {
            let frames = radii.map(|radius| phantom::bowl(radius, 4, 12)).to_vec();
            SurfaceSequence::new(kind, frames).unwrap()
        };
        let sequence = MeshSequence::new(vec![
            side(SurfaceKind::Endocardium, [20.0, 15.0]),
            side(SurfaceKind::Epicardium, [30.0, 30.0]),
        ])
        .unwrap();
        PreparedSubject::new(&Subject::new("P", sequence, LengthUnit::Millimetre), 0)
    }

    #[test]
    fn the_inner_side_is_seen_through_the_outer_one_and_the_wall_is_cut_between() {
        let scene = subject_scene(&heart(), &SceneSettings::default(), GeometryPose::default());
        let opacities: Vec<f32> = scene.scene.surfaces.iter().map(|s| s.opacity).collect();
        assert_eq!(opacities, [1.0, EPICARDIUM_OPACITY, 1.0]);
        assert!(scene.legend.is_none());
        let whole = SceneSettings {
            inner: false,
            ..SceneSettings::default()
        };
        let scene = subject_scene(&heart(), &whole, GeometryPose::default());
        assert_eq!(scene.scene.surfaces.len(), 1);
        assert_eq!(scene.scene.surfaces[0].opacity, 1.0);
    }

    #[test]
    fn playing_changes_nothing_but_the_pose() {
        let prepared = heart();
        let at = |from, blend| {
            let pose = GeometryPose { from, to: 1, blend };
            subject_scene(&prepared, &SceneSettings::default(), pose).scene
        };
        let (a, b) = (at(0, 0.0), at(0, 0.7));
        for (a, b) in a.surfaces.iter().zip(&b.surfaces) {
            assert!(Arc::ptr_eq(&a.geometry, &b.geometry));
            assert_ne!(a.pose, b.pose);
        }
    }

    #[test]
    fn displacement_and_area_are_those_of_a_shrinking_bowl() {
        let prepared = heart();
        let inner = prepared.surface(SurfaceRole::Inner).unwrap();
        let moved = &inner.scalars(Quantity::Displacement).unwrap().values;
        assert!(moved[0].iter().all(|&d| d == 0.0));
        assert!(moved[1].iter().all(|&d| (d - 5.0).abs() < 1e-4));
        let ratio = &inner.scalars(Quantity::AreaRatio).unwrap().values;
        assert!(ratio[1].iter().all(|&r| (r - 0.5625).abs() < 1e-5));
        let rim = prepared.surface(SurfaceRole::Rim).unwrap();
        let moved = &rim.scalars(Quantity::Displacement).unwrap().values[1];
        assert_eq!(moved.iter().filter(|&&d| d > 4.9).count(), 12);
    }

    #[test]
    fn typed_limits_are_used_and_said() {
        let settings = SceneSettings {
            quantity: Quantity::Displacement,
            typed_limits: Some([0.0, 2.5]),
            ..SceneSettings::default()
        };
        let pose = GeometryPose {
            from: 1,
            to: 1,
            blend: 0.0,
        };
        let legend = subject_scene(&heart(), &settings, pose).legend.unwrap();
        assert_eq!(legend.limits.high, 2.5);
        assert_eq!(legend.note, USER_LIMITS);
        assert!(legend.above && !legend.below);
    }
}
