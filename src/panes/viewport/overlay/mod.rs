//! Over the 3D view: subject, colour bar, patches, scale and orientation.

mod caption;
mod colour_bar;
mod cube;
mod free_place;
mod patch_note;
mod scale_bar;
mod title;

pub use caption::SubjectCaption;
pub use colour_bar::ColourBarView;
pub use cube::CubeView;
pub use patch_note::PatchNote;
pub use scale_bar::ScaleBarView;

use egui::{Pos2, Ui, Vec2, vec2};

use crate::panes::commands::Command;
use crate::ui::theme::space;

/// What is drawn over one 3D picture beside its caption.
#[derive(Clone, Debug, Default)]
pub struct ViewportOverlayView<'a> {
    /// The quantity shown in colour; `None` for plain tissue.
    pub colour_bar: Option<ColourBarView<'a>>,
    /// The quantity shown by the colours of atoms, where the surfaces have other colours.
    pub atom_bar: Option<ColourBarView<'a>>,
    /// How long lengths are on screen.
    pub scale_bar: Option<ScaleBarView<'a>>,
    /// Orientation of the heart.
    pub cube: Option<CubeView>,
    /// Where points of the subject are at one time or another, from the middle of the picture.
    pub subject: Vec<Vec2>,
}

/// Draws over `ui.max_rect()`, which the 3D picture fills. Two pictures side by side need a `ui`
/// each, with its own `id_salt`.
pub fn viewport_overlay_ui(
    ui: &mut Ui,
    caption: &SubjectCaption,
    view: &ViewportOverlayView,
    commands: &mut Vec<Command>,
) {
    let whole = ui.max_rect();
    let inner = whole.shrink(space::LARGE + space::SMALL);
    if !inner.is_positive() || inner.width() < 60.0 {
        return;
    }
    let taken = title::title_ui(ui, inner, caption, commands);
    let tall = inner.height() > 180.0;
    let cube = (view.cube.as_ref()).filter(|_| tall && inner.width() > 200.0);
    let mut free: egui::Rangef = inner.x_range();
    if cube.is_some() {
        free.max -= cube::SIDE;
    }
    if let Some(bar) = &view.colour_bar {
        // Titles take what the bar of lengths does not need.
        let scale = view.scale_bar.as_ref().and_then(scale_bar::length);
        let end = free.max - scale.map_or(0.0, |length| length + space::HUGE);
        let atoms = view.atom_bar.as_ref().filter(|_| tall);
        if let Some(atoms) = atoms {
            let above = inner.translate(vec2(0.0, -colour_bar::BAR_HEIGHT));
            colour_bar::fixed_colour_bar_ui(ui, above, end, atoms);
        }
        free.min = colour_bar::colour_bar_ui(ui, inner, end, bar, commands);
    }
    if let Some(patch) = caption.patch.as_ref().filter(|_| tall) {
        let subject = view.subject.iter().map(|offset| whole.center() + *offset);
        let subject: Vec<Pos2> = subject.collect();
        patch_note::patch_note_ui(ui, inner, &taken, &subject, patch);
    }
    if let Some(cube) = cube {
        cube::cube_ui(ui, inner, cube, commands);
    }
    if let Some(scale) = &view.scale_bar {
        scale_bar::scale_bar_ui(ui, inner, free, scale);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::ViewCommand;
    use crate::picture::AnatomicalView;
    use egui_kittest::{Harness, kittest::Queryable as _};

    fn bar(title: &'static str) -> ColourBarView<'static> {
        ColourBarView {
            title,
            unit: "mm",
            map: [[0, 0, 0], [255, 255, 255]].into(),
            limits: [0.0, 12.0],
            logarithmic: false,
            ticks: &[],
            below: [0, 0, 80],
            above: [80, 0, 0],
            note: "",
            typed: false,
        }
    }

    fn harness() -> Harness<'static, Vec<Command>> {
        Harness::builder()
            .with_size([700.0, 500.0])
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| {
                    let caption = SubjectCaption {
                        title: "P-041".to_owned(),
                        ..Default::default()
                    };
                    let view = ViewportOverlayView {
                        colour_bar: Some(ColourBarView {
                            note: "fixed for all subjects",
                            ..bar("Displacement")
                        }),
                        cube: Some(CubeView {
                            world_from_camera: glam::Quat::IDENTITY,
                            base: glam::Vec3::Y,
                            septal: glam::Vec3::NEG_X,
                            anterior: glam::Vec3::Z,
                            known: true,
                        }),
                        ..Default::default()
                    };
                    viewport_overlay_ui(ui, &caption, &view, commands);
                },
                Vec::new(),
            )
    }

    #[test]
    fn a_click_on_a_face_of_the_cube_looks_from_there() {
        let mut harness = harness();
        harness.run();
        harness.get_by_label("Orientation cube").click();
        harness.run();
        let wanted = Command::View(ViewCommand::ViewFrom(AnatomicalView::Anterior));
        assert_eq!(harness.into_state(), [wanted]);
    }

    #[test]
    fn limits_are_typed_where_they_are_read() {
        let mut harness = harness();
        harness.run();
        harness.get_by_label("Upper limit: 12").click();
        harness.run();
        harness.get_by_label("To value").focus();
        harness.run();
        harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
        harness.get_by_label("To value").type_text("8,5");
        harness.run();
        harness.get_by_label("Apply").click();
        harness.run();
        assert_eq!(
            harness.into_state(),
            [Command::View(ViewCommand::SetColourLimits(Some([
                0.0, 8.5
            ])))]
        );
    }

    /// What lies over a picture of this size, with points of its subject there.
    fn over(
        size: [f32; 2],
        caption: SubjectCaption,
        title: Option<&'static str>,
        subject: Vec<Vec2>,
    ) -> Harness<'static, Vec<Command>> {
        let mut harness = Harness::builder()
            .with_size(size)
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                move |ui, commands: &mut Vec<Command>| {
                    let view = ViewportOverlayView {
                        colour_bar: title.map(bar),
                        subject: subject.clone(),
                        ..Default::default()
                    };
                    viewport_overlay_ui(ui, &caption, &view, commands);
                },
                Vec::new(),
            );
        harness.run();
        harness
    }

    fn between_frames() -> SubjectCaption {
        SubjectCaption {
            title: "P03".to_owned(),
            subtitle: "abnormal · between frames 2 and 3".to_owned(),
            badge: Some("interpolated · isometric metric".into()),
            patch: Some(PatchNote {
                heading: "1 abnormal patch · 9 % of the LV".to_owned(),
                short: "patch 9 %".to_owned(),
                lines: vec!["mid inferior".to_owned(), "4.1 cm²".to_owned()],
                found: true,
            }),
            ..SubjectCaption::default()
        }
    }

    #[test]
    fn in_a_narrow_picture_the_patch_is_told_in_short_and_nothing_lies_over_anything() {
        for width in [200.0, 258.0, 320.0, 420.0, 514.0, 700.0] {
            let harness = over([width, 450.0], between_frames(), None, Vec::new());
            let rect = |label: &str| harness.get_by_label_contains(label).rect();
            let note = rect("1 abnormal patch");
            let all = [
                rect("P03"),
                rect("between frames"),
                rect("interpolated · isometric metric"),
                note,
            ];
            for (place, one) in all.iter().enumerate() {
                assert!(one.left() >= 0.0 && one.right() <= width, "{width}: {one}");
                for other in &all[place + 1..] {
                    assert!(
                        !one.shrink(0.1).intersects(*other),
                        "{width}: {one} {other}"
                    );
                }
            }
            assert!(width > 300.0 || note.width() < 100.0, "{width}: {note}");
        }
    }

    #[test]
    fn the_lines_of_the_patch_end_where_the_subject_begins() {
        let note = |subject: Vec<Vec2>| {
            let harness = over([700.0, 440.0], between_frames(), None, subject);
            harness.get_by_label_contains("1 abnormal patch").rect()
        };
        let whole = note(Vec::new());
        // At the place of the last line, and far below.
        let second = whole.right_bottom() - egui::pos2(350.0 + 10.0, 220.0 + 4.0);
        let cut = note(vec![second, vec2(0.0, 0.0)]);
        assert!(
            cut.bottom() < whole.bottom() - 10.0 && cut.height() > 20.0,
            "{cut}"
        );
        assert_eq!(note(vec![vec2(0.0, 0.0)]), whole);
    }

    #[test]
    fn the_title_of_a_colour_bar_takes_the_room_that_is_there() {
        let title = "Difference from own motion";
        let harness = over(
            [258.0, 450.0],
            SubjectCaption::default(),
            Some(title),
            Vec::new(),
        );
        // It is said whole either way, and has more than its former share only where it is shown whole.
        let shown = harness
            .get_by_label("Difference from own motion, mm")
            .rect();
        assert!(shown.width() > 130.0, "{shown}");
    }
}
