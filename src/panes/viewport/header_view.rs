//! The strip above the 3D view.

use crate::document::differences::hindrance;
use crate::document::state::State;
use crate::panes::ViewportHeaderView;
use crate::study::{Subject, SurfaceKind};

/// Why there is no distance of a transported motion.
const NO_TRANSPORT: &str = "Drag a subject of the cohort onto another one to transport its motion";

/// What the strip shows; switches of surfaces that the heart lacks are grey.
pub fn viewport_header_view(state: &State) -> ViewportHeaderView {
    let document = &state.document;
    let visible = document.visibility;
    let has = |kinds: &[SurfaceKind]| {
        document
            .selected()
            .is_some_and(|subject: &std::sync::Arc<Subject>| {
                kinds
                    .iter()
                    .any(|kind| subject.sequence.surface(*kind).is_some())
            })
    };
    let inner = has(&[
        SurfaceKind::Endocardium,
        SurfaceKind::Cavity,
        SurfaceKind::Other,
    ]);
    let outer = has(&[SurfaceKind::Epicardium, SurfaceKind::Wall]);
    ViewportHeaderView {
        mode: document.view_mode,
        quantity: document.quantity,
        shows_endocardium: inner.then_some(visible.endocardium),
        shows_epicardium: outer.then_some(visible.epicardium),
        shows_wireframe: visible.wireframe,
        shows_vertices: visible.vertices,
        shows_atoms: visible.atoms,
        shows_spokes: visible.spokes,
        shows_patches: visible.patches,
        shows_direction: visible.direction,
        free_camera: document.free_camera,
        shading: visible.shading,
        no_contribution: hindrance(document),
        no_motion_difference: document
            .visible_transport()
            .is_none()
            .then_some(NO_TRANSPORT),
    }
}
