//! Over the 3D view: subject, colour bar, patches, scale and orientation.

mod colour_bar;
mod cube;
mod patch_note;
mod scale_bar;

pub use colour_bar::ColourBarView;
pub use cube::CubeView;
pub use patch_note::PatchNote;
pub use scale_bar::ScaleBarView;

use std::borrow::Cow;

use egui::{Align2, Rect, RichText, Role, Ui, UiBuilder, WidgetInfo, vec2};

use crate::panes::buttons::command_button_ui;
use crate::panes::commands::Command;
use crate::ui::label_marks::{LabelMark, label_mark};
use crate::ui::style::{note, note_font, title_font};
use crate::ui::text::text_width;
use crate::ui::theme::{colours, space};

/// What is said over the 3D picture of a subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SubjectCaption {
    /// Pseudonym; empty when nothing is shown.
    pub title: String,
    /// "MINF · frame 1 of 2 · ES".
    pub subtitle: String,
    /// Shape beside the title.
    pub mark: LabelMark,
    /// Whether the picture is between two poses, or estimated, and how: `interpolated`.
    pub badge: Option<Cow<'static, str>>,
    /// More about the badge, for whoever points at it; may be empty.
    pub badge_note: String,
    /// What ends the special state that the title names: words of the button and its command.
    pub leave: Option<(&'static str, Command)>,
    /// The patches of this subject: number, size, segments.
    pub patch: Option<PatchNote>,
}

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
}

/// Height of title and subtitle, in points.
const BELOW_TITLE: f32 = 45.0;

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
    title_ui(ui, inner, caption, commands);
    let tall = inner.height() > 180.0;
    let mut free = inner.x_range();
    if let Some(bar) = &view.colour_bar {
        free.min = colour_bar::colour_bar_ui(ui, inner, bar, commands);
        if let Some(atoms) = &view.atom_bar
            && tall
        {
            let above = inner.translate(vec2(0.0, -colour_bar::BAR_HEIGHT));
            colour_bar::fixed_colour_bar_ui(ui, above, atoms);
        }
    }
    if let Some(patch) = &caption.patch
        && tall
    {
        let down = if caption.badge.is_some() { 32.0 } else { 6.0 };
        patch_note::patch_note_ui(ui, inner, down, patch);
    }
    if let Some(cube) = &view.cube
        && tall
        && inner.width() > 200.0
    {
        free.max = cube::cube_ui(ui, inner, cube, commands);
    }
    if let Some(scale) = &view.scale_bar {
        scale_bar::scale_bar_ui(ui, inner, free, scale);
    }
}

fn title_ui(ui: &mut Ui, inner: Rect, caption: &SubjectCaption, commands: &mut Vec<Command>) {
    if caption.title.is_empty() {
        return;
    }
    let strong = colours(ui).strong;
    let mut corner = ui.new_child(
        UiBuilder::new().max_rect(Rect::from_min_size(inner.min, vec2(inner.width(), 90.0))),
    );
    corner.spacing_mut().item_spacing = vec2(space::MEDIUM, 0.0);
    corner.horizontal(|ui| {
        let (mark, _) = ui.allocate_exact_size(vec2(10.0, 24.0), egui::Sense::hover());
        label_mark(ui, mark.center(), 5.0, caption.mark, true);
        let title = RichText::new(&caption.title)
            .font(title_font())
            .color(strong);
        ui.add(egui::Label::new(title).truncate());
    });
    corner.add(egui::Label::new(note(&caption.subtitle)).truncate());
    if let Some((words, command)) = &caption.leave {
        corner.add_space(space::SMALL);
        command_button_ui(&mut corner, note(*words), command.clone(), commands);
    }
    if let Some(badge) = &caption.badge {
        badge_ui(ui, inner, badge, caption);
    }
}

/// Beside the title where there is room, below it where there is none.
fn badge_ui(ui: &mut Ui, inner: Rect, badge: &str, caption: &SubjectCaption) {
    let colours = colours(ui);
    let title_width = text_width(ui, &caption.title, title_font()) + 10.0 + space::MEDIUM;
    // The badge reaches down to the words below the title.
    let title_width = title_width.max(text_width(ui, &caption.subtitle, note_font()));
    let galley = ui
        .painter()
        .layout_no_wrap(badge.to_owned(), note_font(), colours.muted);
    let size = galley.size() + vec2(14.0, 6.0);
    let beside = title_width + space::LARGE + size.x <= inner.width();
    let down = if beside { 6.0 } else { BELOW_TITLE };
    let rect = Align2::RIGHT_TOP.anchor_size(inner.right_top() + vec2(0.0, down), size);
    let taken = match &caption.leave {
        Some((words, _)) if !beside => text_width(ui, words, note_font()) + 2.0 * space::LARGE,
        _ => 0.0,
    };
    if rect.left() < inner.left() + taken {
        return;
    }
    ui.painter().rect_filled(rect, 4.0, colours.control);
    ui.painter()
        .galley(rect.min + vec2(7.0, 3.0), galley, colours.muted);
    let response = ui.interact(rect, ui.scope_id().with("badge"), egui::Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, badge));
    if !caption.badge_note.is_empty() {
        response.on_hover_text(&caption.badge_note);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::ViewCommand;
    use crate::picture::AnatomicalView;
    use egui_kittest::{Harness, kittest::Queryable as _};

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
                            title: "Displacement",
                            unit: "mm",
                            map: [[0, 0, 0], [255, 255, 255]].into(),
                            limits: [0.0, 12.0],
                            logarithmic: false,
                            ticks: &[],
                            below: [0, 0, 80],
                            above: [80, 0, 0],
                            note: "fixed for all subjects",
                            typed: false,
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
}
