//! The bull's-eye as a figure.

use crate::document::document::nearest_frame;
use crate::engine::{WallThickeningQuery, file_name};
use crate::panes::figure::{PaneFigure, check_measured};
use crate::panes::pane_context::PaneContext;
use crate::panes::viewport::viewport::Viewport;
use crate::picture::figure::BullsEyeContent;
use crate::picture::plot::{Plot, PlotFigure};
use crate::picture::{
    BullsEyeScale, PolarMap, patch_heading, sentence, smallest_words, wall_thickening_words,
};
use crate::report::thickening_words;

/// What the pane is exported as.
pub const FIGURE: PaneFigure = PaneFigure {
    action: "Figure: bull's-eye…",
    save: "Save the bull's-eye as a figure",
    none: "No figure of the bull's-eye",
    content,
};

fn content(cx: &PaneContext<'_>) -> Result<PlotFigure, String> {
    let state = cx.state();
    let document = &state.document;
    let subject = document.selected().ok_or("no subject is selected")?;
    let id = &subject.id;
    if let Some((Err(why), true)) = state.wall_of(document.subject) {
        return Err(format!("{id} is not assessed: {why}"));
    }
    let query = WallThickeningQuery {
        subject: document.subject,
        settings: document.thickening,
    };
    let not_yet = || format!("the wall of {id} is still being measured");
    let wall = cx.known(&query).ok_or_else(not_yet)?;
    check_measured(cx)?;
    let quantity = document.bulls_eye;
    let typed = document.limits_of(quantity.on_heart());
    let viewport = cx.memo().get::<Viewport>();
    let viewport = viewport.borrow_mut();
    let scale = BullsEyeScale::of(quantity, viewport.cohort_ranges(), typed, subject.unit);
    let frame = nearest_frame(document.position, wall.beat.frames.len());
    let standing = state.patch_standing(document.subject);
    let assessed = wall.not_assessed.is_none();
    let flat = PolarMap::of(&wall).map(|mut flat| {
        if !(assessed && document.visibility.patches) {
            flat.patches.clear();
        }
        let values = flat.values(&wall, subject, quantity, frame);
        (flat, values)
    });
    let Some(flat) = flat else {
        let why = wall.without_axis.as_deref().unwrap_or("no long axis");
        return Err(format!("{id}: {why}"));
    };
    let thickening = &wall.thickening;
    let found = match &wall.not_assessed {
        Some(why) => format!("not assessed: {why}"),
        None => format!(
            "{} · {}",
            patch_heading(thickening, standing),
            wall_thickening_words(thickening)
        ),
    };
    let label = subject.label.iter().map(String::as_str);
    let lines = label.chain([document.study().name.as_str(), &found]);
    Ok(PlotFigure {
        stem: format!("{}_bulls_eye", file_name(id)),
        title: format!("Bull's-eye · {id}"),
        lines: vec![lines.collect::<Vec<_>>().join(" · ")],
        notes: vec![
            format!("Medial surface {}", thickening_words(&document.thickening)),
            sentence(&smallest_words(thickening)),
        ],
        plot: Plot::BullsEye(Box::new(BullsEyeContent {
            flat: Some(flat),
            without_flat: String::new(),
            scale,
            moment: state.moment_name(document.subject, frame),
            standing,
            by_segment: document.bulls_eye_segments,
        })),
    })
}
