//! The volume curves as a figure.

use crate::engine::file_name;
use crate::panes::figure::{PaneFigure, check_measured};
use crate::panes::pane_context::PaneContext;
use crate::picture::figure::{FigureContent, FigureSubject};
use crate::picture::plot::{CurvePlot, CurveRole, Plot, PlotCurve, PlotFigure};
use crate::picture::{sentence, share_unit};

use super::view::curves_view;
use super::{Curve, CurveKind, CurvesView, range};

/// What the pane is exported as.
pub const FIGURE: PaneFigure = PaneFigure {
    action: "Figure: volume curve…",
    save: "Save the volume curve as a figure",
    none: "No figure of the volume curve",
    content,
};

fn content(cx: &PaneContext<'_>) -> Result<PlotFigure, String> {
    let state = cx.state();
    let document = &state.document;
    let subject = document.selected().ok_or("no subject is selected")?;
    check_measured(cx)?;
    let view = curves_view(state, false);
    let id = &subject.id;
    let plot = curve_plot(&view)
        .ok_or_else(|| format!("{id} has no closed or capped surface, and so no volume"))?;
    let shown = FigureSubject {
        subject,
        measures: state.measures_of(document.subject),
        frame: document.frame(),
    };
    let facts = FigureContent::of(shown, document.position, Vec::new(), Vec::new());
    let lines = subject.label.iter().chain([
        &document.study().name,
        &facts.ejection_fraction,
        &facts.volumes,
    ]);
    let lines: Vec<&str> = lines
        .map(String::as_str)
        .filter(|words| !words.is_empty())
        .collect();
    Ok(PlotFigure {
        stem: format!("{}_volume", file_name(id)),
        title: format!("Volume over the cardiac cycle · {id}"),
        lines: vec![lines.join(" · ")],
        notes: vec!["ED: end-diastole; ES: end-systole".to_owned()],
        plot: Plot::Curves(plot),
    })
}

/// The curves with their axes; `None` where no volume is known.
fn curve_plot(view: &CurvesView<'_>) -> Option<CurvePlot> {
    let (low, high) = range(&view.curves)?;
    let (time, cycle) = match view.cycle_ms {
        Some(cycle) => ("Time, ms".to_owned(), cycle),
        None => (sentence(share_unit(false)), 100.0),
    };
    let at = |frame: usize| cycle * view.axis.share_at(frame as f64);
    let curve = |curve: &Curve| {
        let count = curve.values.len();
        let point = |frame| [at(frame), curve.values[frame % count.max(1)]];
        PlotCurve {
            role: match curve.kind {
                CurveKind::Endocardium => CurveRole::Endocardium,
                CurveKind::Epicardium => CurveRole::Epicardium,
            },
            // The end of the cycle is its start.
            points: (0..=count).filter(|_| count > 0).map(point).collect(),
        }
    };
    let phases = [(view.end_diastole, "ED"), (view.end_systole, "ES")];
    let phases = phases.into_iter();
    Some(CurvePlot {
        curves: view.curves.iter().map(curve).collect(),
        value: format!("Volume, {}", view.unit),
        range: [low, high],
        time,
        cycle,
        phases: phases
            .filter_map(|(frame, name)| Some((at(frame?), name)))
            .collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::cycle_axis::CycleAxis;

    #[test]
    fn a_curve_runs_from_its_first_frame_to_the_end_of_the_cycle() {
        let mut view = CurvesView {
            curves: vec![Curve {
                kind: CurveKind::Endocardium,
                values: vec![100.0, 60.0],
            }],
            unit: "ml",
            axis: CycleAxis {
                frame_shares: vec![0.0, 0.4],
            },
            cycle_ms: Some(800.0),
            end_systole: Some(1),
            ..CurvesView::default()
        };
        let plot = curve_plot(&view).unwrap();
        let points = [[0.0, 100.0], [320.0, 60.0], [800.0, 100.0]];
        assert_eq!(plot.curves[0].points, points);
        assert_eq!(plot.phases, [(320.0, "ES")]);
        assert_eq!((&*plot.value, &*plot.time), ("Volume, ml", "Time, ms"));
        view.curves.clear();
        assert_eq!(curve_plot(&view), None);
    }
}
