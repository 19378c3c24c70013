//! Panels of the window with the numbers of the example.

use std::sync::Arc;

use cardiomorph::app::*;
use cardiomorph::document::{CohortColumn, CohortSort};
use cardiomorph::panes::*;
use cardiomorph::report::SubjectRow;
use cardiomorph::ui::LabelMark;
use cardiomorph::ui::theme::colours;
use cardiomorph::ui::*;
use cardiomorph::units::LengthUnit;
use egui::{Frame, Margin, Rect, Stroke, Ui, UiBuilder, pos2, vec2};

use super::example::Example;

/// A pane of the window: a rounded frame on the window's colour.
pub fn pane(ui: &mut Ui, rect: Rect, add: impl FnOnce(&mut Ui)) {
    let colours = colours(ui);
    let frame = Frame::new()
        .fill(colours.pane)
        .stroke(Stroke::new(1.0, colours.line))
        .corner_radius(6);
    let mut child = ui.new_child(UiBuilder::new().max_rect(rect).id_salt(format!("{rect:?}")));
    frame.inner_margin(Margin::ZERO).show(&mut child, |ui| {
        ui.set_min_size(rect.size() - vec2(2.0, 2.0));
        ui.set_max_size(rect.size() - vec2(2.0, 2.0));
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.scope(|ui| {
            ui.reset_style();
            add(ui);
        });
    });
}

pub fn cohort(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    let sort = Some(CohortSort {
        column: CohortColumn::Subject,
        descending: false,
    });
    let visible = visible_rows(&example.rows, "", sort);
    pane_header_ui(
        ui,
        |ui| {
            tab_ui(ui, "Cohort", true);
            tab_ui(ui, "Activity", false);
        },
        |ui| {
            ui.weak(example.rows.len().to_string());
        },
    );
    let view = CohortView {
        rows: &example.rows,
        visible: &visible,
        search: "",
        sort,
        selected: Some(9),
        compared: None,
        measuring: false,
        classifying: false,
        ..CohortView::default()
    };
    cohort_table_ui(ui, &view, commands);
}

pub fn viewport(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    viewport_header_ui(ui, &example.state, commands);
    let picture = ui.available_rect_before_wrap();
    // Where the renderer draws, something like a heart.
    let colours = colours(ui);
    let size = picture.height() * 0.32;
    ui.painter().circle_filled(
        picture.center(),
        size,
        colours.epicardium.gamma_multiply(0.25),
    );
    ui.painter()
        .circle_filled(picture.center(), size * 0.7, colours.endocardium);
    let map: Arc<[[u8; 3]]> = (0..256)
        .map(|i| [43 + (i as u8 / 2), 108, 176 - i as u8 / 2])
        .collect();
    let caption = SubjectCaption {
        title: example.rows[9].id.clone(),
        subtitle: "MINF · frame 3 of 8".to_owned(),
        mark: LabelMark::Label(0),
        badge: Some("interpolated · isometric metric".into()),
        badge_note: "3 poses between these frames".to_owned(),
        ..SubjectCaption::default()
    };
    let view = ViewportOverlayView {
        colour_bar: Some(ColourBarView {
            title: "Area relative to end-diastole",
            unit: "",
            map,
            limits: [0.5, 2.0],
            logarithmic: true,
            ticks: &[],
            below: [20, 40, 90],
            above: [110, 20, 20],
            note: "fixed for all subjects",
            typed: false,
        }),
        atom_bar: None,
        scale_bar: Some(ScaleBarView {
            points_per_unit: 4.3,
            unit: "mm",
        }),
        cube: Some(CubeView {
            world_from_camera: glam::Quat::from_euler(glam::EulerRot::YXZ, 0.7, -0.45, 0.0),
            base: glam::Vec3::Y,
            septal: glam::Vec3::NEG_X,
            anterior: glam::Vec3::Z,
            known: true,
        }),
        ..ViewportOverlayView::default()
    };
    let mut over = ui.new_child(UiBuilder::new().max_rect(picture));
    viewport_overlay_ui(&mut over, &caption, &view, commands);
}

pub fn measures(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    pane_header_ui(
        ui,
        |ui| {
            tab_ui(ui, "Volume", true);
            tab_ui(ui, "Measures", false);
        },
        |ui| {
            ui.weak("P-050");
        },
    );
    let whole = ui.available_rect_before_wrap();
    let split = whole.left() + 0.64 * whole.width();
    let mut plot = ui.new_child(
        UiBuilder::new().max_rect(Rect::from_min_max(whole.min, pos2(split, whole.bottom()))),
    );
    let view = CurvesView {
        curves: vec![
            Curve {
                kind: CurveKind::Endocardium,
                values: example.volumes.clone(),
            },
            Curve {
                kind: CurveKind::Epicardium,
                values: example.outer.clone(),
            },
        ],
        unit: "ml",
        axis: example.axis(),
        cycle_ms: Some(920.0),
        position: 2.4,
        end_diastole: Some(0),
        end_systole: Some(4),
        computing: false,
    };
    curves_ui(&mut plot, &view, commands);
    let mut card = ui.new_child(
        UiBuilder::new().max_rect(Rect::from_min_max(pos2(split, whole.top()), whole.max)),
    );
    let view = MeasuresView {
        subject: Some("P-050"),
        measures: SubjectRow {
            ef: Some(0.365),
            edv: Some(104.0),
            esv: Some(66.0),
            sv: Some(38.0),
            mass_g: Some(92.4),
            unit: LengthUnit::Millimetre,
            end_diastole: Some(0),
            end_systole: Some(4),
            ..SubjectRow::default()
        },
        current_frame: 2,
        ..Default::default()
    };
    measures_card_ui(&mut card, &view, commands);
}

pub fn time(ui: &mut Ui, example: &Example, commands: &mut Vec<Command>) {
    let view = TimeBarView {
        playing: false,
        speed: 1.0,
        looping: true,
        loop_frames: Some([1, 5]),
        escape_ends_range: true,
        position: 2.4,
        axis: example.axis(),
        end_diastole: Some(0),
        end_systole: Some(4),
        time_ms: Some(276.0),
        cycle_ms: Some(920.0),
        between: Some("interpolated"),
        interpolated_poses: vec![2.25, 2.5, 2.75, 3.25, 3.5, 3.75],
        note: String::new(),
    };
    time_bar_ui(ui, &view, commands);
}
