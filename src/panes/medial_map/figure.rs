//! The medial map as a figure.

use crate::analysis::medial_map::MedialMap;
use crate::engine::Query;
use crate::panes::figure::{PaneFigure, check_measured, not_computed};
use crate::panes::metric::words::method_name;
use crate::panes::pane_context::PaneContext;
use crate::panes::scatter_map::from_state::{MapPoints, left_out};
use crate::panes::scatter_map::{MapFigureWords, map_figure};
use crate::picture::plot::PlotFigure;
use crate::picture::sentence;

use super::view::{medial_map_query, points};
use super::{MEDIAL_MAP, medial_map_note};

/// What the pane is exported as.
pub const FIGURE: PaneFigure = PaneFigure {
    action: "Figure: medial map…",
    save: "Save the medial map as a figure",
    none: "No figure of the medial map",
    content,
};

/// What the marks of steps mean.
const MARKS: &str = "A mark is a step of the beat of a patch or, without one, of the whole wall: large filled ones begin \
                     at end-diastole, large open ones at end-systole; dashed lines lead over steps that are not known \
                     and from the last step to the first";

fn content(cx: &PaneContext<'_>) -> Result<PlotFigure, String> {
    let state = cx.state();
    let query = medial_map_query(state);
    let map = cx.known(&query).ok_or_else(not_computed)?;
    check_measured(cx)?;
    let kept = cx.memo().get::<MapPoints<MedialMap>>();
    let turn = kept.borrow_mut().turn_of(&map);
    let points = turn.of_points(points(&map, state));
    let missing = map.left_out.iter().map(|(subject, why)| (*subject, why));
    let missing = left_out(state.document.study(), missing);
    let [fit, _] = medial_map_note(map.embedding.stress, map.frame.words());
    let words = MapFigureWords {
        stem: "medial_map",
        title: format!(
            "Medial map · distance of the medial shape space · {}",
            method_name(query.method)
        ),
        fit,
        parameters: format!(
            "{}; compared by {}",
            sentence(&query.parameters()),
            map.frame.words()
        ),
        marks: MARKS,
    };
    Ok(map_figure(cx, &MEDIAL_MAP, &points, &missing, words))
}
