//! The deformation map as a figure.

use crate::analysis::classification::Classes;
use crate::analysis::deformations::DeformationMap;
use crate::engine::{DeformationMapQuery, Query};
use crate::panes::figure::{PaneFigure, check_measured, not_computed};
use crate::panes::pane_context::PaneContext;
use crate::panes::same::Same;
use crate::panes::scatter_map::from_state::{MapPoints, left_out};
use crate::panes::scatter_map::{MapFigureWords, map_figure};
use crate::picture::plot::PlotFigure;
use crate::picture::sentence;

use super::DEFORMATION_MAP;
use super::view::points;
use super::words::{DeformationFit, fit_parts};

/// What the pane is exported as.
pub const FIGURE: PaneFigure = PaneFigure {
    action: "Figure: deformation map…",
    save: "Save the deformation map as a figure",
    none: "No figure of the deformation map",
    content,
};

fn content(cx: &PaneContext<'_>) -> Result<PlotFigure, String> {
    let state = cx.state();
    let (document, study) = (&state.document, state.document.study());
    let query = DeformationMapQuery {
        poses: document.map,
        map: document.deformation_map,
    };
    let map = cx.known(&query).ok_or_else(not_computed)?;
    check_measured(cx)?;
    let kept = (cx.memo()).get::<MapPoints<DeformationMap, Option<Same<Classes>>>>();
    let turn = kept.borrow_mut().turn_of(&map);
    let first = |subject| state.phases_of(subject).0.unwrap_or_default();
    let points = turn.of_points(points(&map, study, None, first));
    let missing = map.parts.iter().flat_map(|mapped| &mapped.parts.left_out);
    let missing = left_out(study, missing.map(|left| (left.subject, &left.reason)));
    let fit = DeformationFit::of(&map);
    let metric = document.map.distances.metric.kind.words().name;
    let method = if fit.stress.is_some() {
        "SMACOF"
    } else {
        "LLE"
    };
    // What the map is called says what is compared, unless that is more.
    let compared = match query.map.comparison.name() {
        "deformation" => String::new(),
        other => format!(" · {}", sentence(other)),
    };
    let words = MapFigureWords {
        stem: "deformation_map",
        title: format!("Deformation map{compared} · {metric} metric · {method}"),
        fit: fit_parts(&fit, ["neighbours", "reconstruction error"]).join(" · "),
        parameters: sentence(&query.parameters()),
        marks: "A mark is the whole motion of a subject",
    };
    Ok(map_figure(cx, &DEFORMATION_MAP, &points, &missing, words))
}
