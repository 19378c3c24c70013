//! The pose map as a figure.

use crate::analysis::embedding::PoseMap;
use crate::engine::Query;
use crate::panes::figure::{PaneFigure, check_measured, not_computed};
use crate::panes::metric::words::method_name;
use crate::panes::pane_context::PaneContext;
use crate::panes::scatter_map::from_state::{MapPoints, left_out};
use crate::panes::scatter_map::{MapFigureWords, map_figure};
use crate::picture::plot::PlotFigure;
use crate::picture::sentence;

use super::view::points;
use super::{POSE_MAP, pose_map_note};

/// What the pane is exported as.
pub const FIGURE: PaneFigure = PaneFigure {
    action: "Figure: pose map…",
    save: "Save the pose map as a figure",
    none: "No figure of the pose map",
    content,
};

/// What the marks of poses mean.
const MARKS: &str = "Large filled marks are end-diastole, large open ones end-systole, small ones other frames; a dashed \
                     line leads from the last frame to the first";

fn content(cx: &PaneContext<'_>) -> Result<PlotFigure, String> {
    let state = cx.state();
    let query = state.document.map;
    let map = cx.known(&query).ok_or_else(not_computed)?;
    check_measured(cx)?;
    let turn = cx
        .memo()
        .get::<MapPoints<PoseMap>>()
        .borrow_mut()
        .turn_of(&map);
    let points = turn.of_points(points(&map, state));
    let missing = map.distances.left_out.iter();
    let missing = missing.map(|left| (left.subject, &left.reason));
    let missing = left_out(state.document.study(), missing);
    let [fit, _] = pose_map_note(map.embedding.stress, map.embedding.neighbours);
    let metric = query.distances.metric.kind.words().name;
    let words = MapFigureWords {
        stem: "pose_map",
        title: format!("Pose map · {metric} metric · {}", method_name(query.method)),
        fit,
        parameters: sentence(&query.parameters()),
        marks: MARKS,
    };
    Ok(map_figure(cx, &POSE_MAP, &points, &missing, words))
}
