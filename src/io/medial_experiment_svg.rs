//! Noise on medial surfaces as a figure: τ over the level, a panel per family, and Dice over the size of the patch.

use std::fmt::Write;

use crate::analysis::experiments::{LocalisationRow, MedialNoiseCell, MedialNoiseResult};

use super::experiment_svg::{
    COLOURS, LEFT, Mark, PANEL, PLOT, TOP, across, axes, cross, down, legend, line,
};

/// Panels of τ, crosses for the figures of table 4.2; below, Dice of single patches by their size: clean and
/// at every level of the last family.
pub fn noise_medial_svg(result: &MedialNoiseResult, rows: &[LocalisationRow]) -> String {
    let params = &result.params;
    let (families, levels) = (&params.families, &params.percents);
    let methods: Vec<&str> = params.methods.iter().map(|m| m.name()).collect();
    let columns = families.len().max(2) as f64;
    let upper = TOP + PLOT[1] + 70.0 + 20.0 * methods.len() as f64;
    let (width, height) = (LEFT + PANEL * columns, upper + TOP + PLOT[1] + 80.0);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"Inter, sans-serif\" font-size=\"12\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n"
    );
    for (column, &family) in families.iter().enumerate() {
        let x0 = LEFT + PANEL * column as f64;
        axes(&mut svg, x0, family, levels);
        for (index, &method) in params.methods.iter().enumerate() {
            let of = |cell: &&MedialNoiseCell| {
                cell.method == method && cell.family.is_none_or(|of| of == family)
            };
            let marks = result.cells.iter().filter(of).map(|cell| Mark {
                percent: cell.percent,
                tau: cell.tau,
                standard_error: cell.standard_error,
            });
            line(&mut svg, x0, marks, levels, COLOURS[index % COLOURS.len()]);
        }
        for cell in &result.cells {
            let first = Some(&cell.method) == params.methods.first() && cell.family == Some(family);
            if let Some(published) = cell.published.filter(|_| first) {
                cross(&mut svg, x0 + across(cell.percent, levels), down(published));
            }
        }
    }
    legend(&mut svg, &methods, "4.2");
    writeln!(svg, "<g transform=\"translate(0 {upper})\">").ok();
    sizes(&mut svg, rows);
    svg + "</g>\n</svg>\n"
}

/// Dice of single patches over their size, a line per level.
fn sizes(svg: &mut String, rows: &[LocalisationRow]) {
    let single: Vec<&LocalisationRow> = rows.iter().filter(|row| row.patches == 1).collect();
    let mut shares: Vec<f64> = single.iter().map(|row| 100.0 * row.share).collect();
    shares.dedup();
    let last = single.iter().filter_map(|row| row.family).next_back();
    let mut levels: Vec<f64> = (single.iter())
        .filter(|row| row.family.is_none() || row.family == last)
        .map(|row| row.percent)
        .collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    let family = last.map_or("", |family| family.name());
    writeln!(
        svg,
        "<text x=\"{LEFT}\" y=\"24\" font-weight=\"600\">Dice of one patch, {family} noise</text>"
    )
    .ok();
    for dice in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let (y, right) = (down(dice), LEFT + PLOT[0]);
        writeln!(svg, "<path d=\"M{LEFT} {y}H{right}\" stroke=\"#dddddd\"/><text x=\"{}\" y=\"{}\" text-anchor=\"end\">{dice}</text>", LEFT - 6.0, y + 4.0).ok();
    }
    for share in &shares {
        let x = LEFT + across(*share, &shares);
        writeln!(
            svg,
            "<text x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{share:.0}</text>",
            down(0.0) + 16.0
        )
        .ok();
    }
    writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">size of the patch, % of the sheet</text>",
        LEFT + PLOT[0] / 2.0,
        down(0.0) + 34.0
    )
    .ok();
    for (index, level) in levels.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let marks = (single.iter())
            .filter(|row| row.percent == *level && (row.family.is_none() || row.family == last))
            .filter_map(|row| row.dice.map(|dice| (row, dice)))
            .map(|(row, (tau, standard_error))| Mark {
                percent: 100.0 * row.share,
                tau,
                standard_error,
            });
        line(svg, LEFT, marks, &shares, colour);
        let (x, y) = (LEFT + PANEL, TOP + 20.0 * index as f64);
        let name = if *level == 0.0 {
            "clean".to_owned()
        } else {
            format!("{level} %")
        };
        writeln!(svg, "<circle cx=\"{x}\" cy=\"{}\" r=\"4\" fill=\"{colour}\"/><text x=\"{}\" y=\"{y}\">{name}</text>", y - 4.0, x + 12.0).ok();
    }
}
