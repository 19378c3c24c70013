//! Noise on medial surfaces as a figure: accuracy over the level of noise, a panel per family, and Dice over the size of
//! the patch.

use crate::analysis::experiments::{LocalisationRow, MedialNoiseCell, MedialNoiseResult};
use crate::picture::noise_plot::{LEFT, PANEL, PLOT, Plot, TOP, Value};
use crate::picture::page::{FigureFonts, Page};

/// Panels of accuracy, crosses for the values of table 4.2; below, Dice of single patches by their size: clean and
/// at every level of the last family.
pub fn medial_noise_page(
    result: &MedialNoiseResult,
    rows: &[LocalisationRow],
    fonts: &FigureFonts,
) -> Page {
    let params = &result.params;
    let families = &params.families;
    let methods: Vec<&str> = params.methods.iter().map(|m| m.name()).collect();
    let columns = families.len().max(2) as f32;
    let upper = TOP + PLOT[1] + 70.0 + 20.0 * methods.len() as f32;
    let size = [LEFT + PANEL * columns, upper + TOP + PLOT[1] + 80.0];
    let mut page = Page::new(size, Some([1.0; 3]));
    let mut plot = Plot::new(&mut page, fonts, &params.percents);
    for (column, &family) in families.iter().enumerate() {
        plot.left = LEFT + PANEL * column as f32;
        plot.noise_axes(family);
        for (index, &method) in params.methods.iter().enumerate() {
            let of = |cell: &&MedialNoiseCell| {
                cell.method == method && cell.family.is_none_or(|of| of == family)
            };
            let values = result.cells.iter().filter(of).map(|cell| Value {
                percent: cell.percent,
                mean: cell.tau,
                standard_error: cell.standard_error,
            });
            plot.line(index, values);
        }
        for cell in &result.cells {
            let first = Some(&cell.method) == params.methods.first() && cell.family == Some(family);
            if let Some(published) = cell.published.filter(|_| first) {
                plot.cross(cell.percent, published);
            }
        }
    }
    plot.legend(
        &methods,
        "Crosses: table 4.2 of the text. Accuracy; bars: standard error",
    );
    (plot.left, plot.above) = (LEFT, upper);
    sizes(&mut plot, rows);
    page
}

/// Dice of single patches over their size, a line per level.
fn sizes(plot: &mut Plot<'_>, rows: &[LocalisationRow]) {
    let single: Vec<&LocalisationRow> = rows.iter().filter(|row| row.patches == 1).collect();
    plot.levels = single.iter().map(|row| 100.0 * row.share).collect();
    plot.levels.dedup();
    let last = single.iter().filter_map(|row| row.family).next_back();
    let mut levels: Vec<f64> = (single.iter())
        .filter(|row| row.family.is_none() || row.family == last)
        .map(|row| row.percent)
        .collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    let family = last.map_or("", |family| family.name());
    let title = format!("Dice of one patch, {family} noise");
    plot.frame(
        &title,
        |dice| dice.to_string(),
        "size of the patch, % of the surface",
    );
    for share in plot.levels.clone() {
        plot.level(share, &format!("{share:.0}"));
    }
    for (index, level) in levels.iter().enumerate() {
        let values = (single.iter())
            .filter(|row| row.percent == *level && (row.family.is_none() || row.family == last))
            .filter_map(|row| row.dice.map(|dice| (row, dice)))
            .map(|(row, (mean, standard_error))| Value {
                percent: 100.0 * row.share,
                mean,
                standard_error,
            });
        plot.line(index, values);
        let name = if *level == 0.0 {
            "clean".to_owned()
        } else {
            format!("{level} %")
        };
        let at = [LEFT + PANEL, plot.above + TOP + 20.0 * index as f32];
        plot.name(index, &name, at);
    }
}
