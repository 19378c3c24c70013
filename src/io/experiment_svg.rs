//! The noise study as a figure: τ over the level, a panel per family, a line per method.

use std::fmt::Write;

use crate::analysis::experiments::{
    NoiseCell, NoiseDeformationResult, NoiseFamily, NoiseReference,
};

/// Width of a panel with its margin, height of the plot, and what stands around it.
pub(super) const PANEL: f64 = 300.0;
pub(super) const PLOT: [f64; 2] = [220.0, 220.0];
pub(super) const LEFT: f64 = 60.0;
pub(super) const TOP: f64 = 40.0;

/// Okabe and Ito's colours, told apart by all eyes, with a shape for each.
pub(super) const COLOURS: [&str; 5] = ["#0072b2", "#d55e00", "#666666", "#009e73", "#cc79a7"];

/// Panels for the noise in percent of the shape's variance; crosses are the figures of table 3.1.
pub fn noise_svg(result: &NoiseDeformationResult) -> String {
    let families = &result.params.families;
    let methods: Vec<&str> = result.params.methods.iter().map(|m| m.name).collect();
    let width = LEFT + PANEL * families.len().max(1) as f64;
    let height = TOP + PLOT[1] + 60.0 + 20.0 * methods.len() as f64;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"Inter, sans-serif\" font-size=\"12\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n"
    );
    let levels = &result.params.percents;
    for (column, &family) in families.iter().enumerate() {
        let x0 = LEFT + PANEL * column as f64;
        axes(&mut svg, x0, family, levels);
        for (index, method) in methods.iter().enumerate() {
            let cells = result.cells.iter().filter(|cell| {
                cell.method == *method
                    && cell.reference == NoiseReference::Shape
                    && cell.family.is_none_or(|of| of == family)
            });
            let colour = COLOURS[index % COLOURS.len()];
            line(&mut svg, x0, cells.map(Mark::from), levels, colour);
        }
        for cell in &result.cells {
            let first = cell.method == methods[0] && cell.reference == NoiseReference::Shape;
            if let Some(published) = cell
                .published
                .filter(|_| first && cell.family == Some(family))
            {
                cross(&mut svg, x0 + across(cell.percent, levels), down(published));
            }
        }
    }
    legend(&mut svg, &methods, "3.1");
    svg + "</svg>\n"
}

/// Levels stand at even distances, clean data first.
pub(super) fn across(percent: f64, levels: &[f64]) -> f64 {
    let place = levels.iter().position(|level| *level == percent);
    let step = PLOT[0] / levels.len().max(1) as f64;
    place.map_or(0.0, |index| step * (index + 1) as f64)
}

/// τ of 1 at the top, 0 at the bottom.
pub(super) fn down(share: f64) -> f64 {
    TOP + PLOT[1] * (1.0 - share.clamp(0.0, 1.0))
}

pub(super) fn axes(svg: &mut String, x0: f64, family: NoiseFamily, levels: &[f64]) {
    let (right, bottom) = (x0 + PLOT[0], down(0.0));
    writeln!(
        svg,
        "<text x=\"{x0}\" y=\"24\" font-weight=\"600\">{} noise</text>",
        capitalised(family.name())
    )
    .ok();
    for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let y = down(share);
        writeln!(svg, "<path d=\"M{x0} {y}H{right}\" stroke=\"#dddddd\"/><text x=\"{}\" y=\"{}\" text-anchor=\"end\">{:.0} %</text>", x0 - 6.0, y + 4.0, 100.0 * share).ok();
    }
    for percent in std::iter::once(&0.0).chain(levels) {
        let x = x0 + across(*percent, levels);
        writeln!(
            svg,
            "<text x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{percent}</text>",
            bottom + 16.0
        )
        .ok();
    }
    writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">noise, % of variance</text>",
        x0 + PLOT[0] / 2.0,
        bottom + 34.0
    )
    .ok();
}

/// One mean of a line, with its standard error.
pub(super) struct Mark {
    pub percent: f64,
    pub tau: f64,
    pub standard_error: f64,
}

impl From<&NoiseCell> for Mark {
    fn from(cell: &NoiseCell) -> Self {
        Self {
            percent: cell.percent,
            tau: cell.tau,
            standard_error: cell.standard_error,
        }
    }
}

/// Means joined by a line, with bars of one standard error.
pub(super) fn line(
    svg: &mut String,
    x0: f64,
    marks: impl Iterator<Item = Mark>,
    levels: &[f64],
    colour: &str,
) {
    let mut points = Vec::new();
    for mark in marks {
        let x = x0 + across(mark.percent, levels);
        let (low, high) = (
            down(mark.tau - mark.standard_error),
            down(mark.tau + mark.standard_error),
        );
        let y = down(mark.tau);
        writeln!(svg, "<path d=\"M{x:.1} {low:.1}V{high:.1}\" stroke=\"{colour}\"/><circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{colour}\"/>").ok();
        points.push(format!("{x:.1},{y:.1}"));
    }
    writeln!(
        svg,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>",
        points.join(" ")
    )
    .ok();
}

/// A published figure.
pub(super) fn cross(svg: &mut String, x: f64, y: f64) {
    writeln!(
        svg,
        "<path d=\"M{:.1} {:.1}l8 8m0 -8l-8 8\" stroke=\"black\" fill=\"none\"/>",
        x - 4.0,
        y - 4.0
    )
    .ok();
}

/// Names of the lines, and which table the crosses are from.
pub(super) fn legend(svg: &mut String, methods: &[&str], table: &str) {
    let top = down(0.0) + 60.0;
    for (index, method) in methods.iter().enumerate() {
        let y = top + 20.0 * index as f64;
        writeln!(svg, "<circle cx=\"{LEFT}\" cy=\"{}\" r=\"4\" fill=\"{}\"/><text x=\"{}\" y=\"{y}\">{method}</text>", y - 4.0, COLOURS[index % COLOURS.len()], LEFT + 12.0).ok();
    }
    writeln!(svg, "<text x=\"{}\" y=\"{top}\">× table {table} of the text; τ, accuracy of clusters; bars: standard error</text>", LEFT + PANEL).ok();
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}
