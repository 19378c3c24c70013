//! Curves over the cardiac cycle on a page, with the frames of end-diastole and end-systole.

use crate::picture::figure::Pen;
use crate::picture::page::Anchor;
use crate::picture::tokens::srgb;

use super::axes::{PlotAxis, draw_axes, plot_area, widest_number};
use super::marks::dashed;

/// The epicardium on light and on dark ground, as in the window.
const EPICARDIUM: [[f32; 3]; 2] = [srgb(0x9b_7d52), srgb(0xd9_c3a5)];

/// What a curve is about; sets its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveRole {
    /// The blood pool.
    Endocardium,
    /// Cavity and myocardium.
    Epicardium,
}

impl CurveRole {
    fn name(self) -> &'static str {
        match self {
            Self::Endocardium => "endocardium",
            Self::Epicardium => "epicardium",
        }
    }

    fn colour(self, pen: &Pen<'_>) -> [f32; 3] {
        match self {
            Self::Endocardium => pen.theme.text,
            Self::Epicardium => EPICARDIUM[usize::from(pen.theme.is_dark())],
        }
    }
}

/// One curve.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotCurve {
    /// What it is about.
    pub role: CurveRole,
    /// Time and value of each frame, and of the end of the cycle, which is its start; a value that is not a number is
    /// left out.
    pub points: Vec<[f64; 2]>,
}

/// Curves over one cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePlot {
    /// The curves.
    pub curves: Vec<PlotCurve>,
    /// What is counted upwards, with its unit.
    pub value: String,
    /// Lowest and highest value.
    pub range: [f64; 2],
    /// What is counted to the right, with its unit.
    pub time: String,
    /// Length of the cycle in that unit.
    pub cycle: f64,
    /// Times of end-diastole and end-systole, with their names.
    pub phases: Vec<(f64, &'static str)>,
}

/// Draws the plot with its axes into a rectangle.
pub(super) fn draw_curves(pen: &mut Pen<'_>, plot: &CurvePlot, outer: [[f32; 2]; 2]) {
    let axis = |title: &str, [low, high]: [f64; 2]| PlotAxis {
        title: title.to_owned(),
        low,
        high,
    };
    let (across, up) = (
        axis(&plot.time, [0.0, plot.cycle]),
        axis(&plot.value, plot.range),
    );
    let widest = widest_number(pen, &up, outer[1][1] - outer[0][1]);
    let area = plot_area(pen, outer, widest);
    draw_axes(pen, area, [&across, &up]);
    let [low, high] = area;
    let place = |[time, value]: [f64; 2]| {
        let share = [
            time / plot.cycle,
            (plot.range[1] - value) / (plot.range[1] - plot.range[0]),
        ];
        [0, 1].map(|axis| low[axis] + share[axis] as f32 * (high[axis] - low[axis]))
    };
    let (text, width) = (pen.text, (pen.text / 7.0).max(1.0));
    for (time, name) in &plot.phases {
        let x = place([*time, plot.range[0]])[0];
        let colour = pen.theme.muted;
        dashed(
            pen.page,
            [[x, low[1]], [x, high[1]]],
            0.3 * text,
            0.5 * width,
            colour,
        );
        let at = [x + 0.3 * text, low[1] + text];
        pen.write(name, pen.regular(colour), Anchor::Start, at);
    }
    let mut right = high[0];
    for curve in plot.curves.iter().rev() {
        let colour = curve.role.colour(pen);
        let known = |point: &&[f64; 2]| point[1].is_finite();
        for run in curve.points.chunk_by(|_, next| next[1].is_finite()) {
            let run: Vec<[f32; 2]> = run
                .iter()
                .filter(known)
                .map(|&point| place(point))
                .collect();
            if run.len() > 1 {
                pen.page.line(&run, false, width, colour);
            }
            for at in run {
                let dot = [at, [at[0] + 0.01, at[1]]];
                pen.page.line(&dot, false, 2.5 * width, colour);
            }
        }
        // The names stand above the plot, right to left.
        let (set, base) = (pen.regular(colour), low[1] - 0.4 * pen.line_height());
        let name = curve.role.name();
        right -= pen.write(name, set, Anchor::End, [right, base]) + text;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::page::{FigureFonts, Mark, Page};
    use crate::picture::tokens::PictureTheme;

    #[test]
    fn a_curve_begins_and_ends_at_the_ends_of_the_cycle_and_its_phases_are_named() {
        let fonts = FigureFonts::load().unwrap();
        let mut page = Page::new([600.0, 400.0], None);
        let mut pen = Pen {
            page: &mut page,
            fonts: &fonts,
            theme: &PictureTheme::LIGHT,
            text: 14.0,
        };
        let plot = CurvePlot {
            curves: vec![PlotCurve {
                role: CurveRole::Epicardium,
                points: vec![[0.0, 150.0], [400.0, 60.0], [800.0, 150.0]],
            }],
            value: "Volume, ml".to_owned(),
            range: [50.0, 160.0],
            time: "Time, ms".to_owned(),
            cycle: 800.0,
            phases: vec![(0.0, "ED"), (400.0, "ES")],
        };
        draw_curves(&mut pen, &plot, [[20.0, 20.0], [580.0, 380.0]]);
        let words: Vec<&str> = (page.marks.iter())
            .filter_map(|mark| match mark {
                Mark::Text { words, .. } => Some(words.as_str()),
                _ => None,
            })
            .collect();
        for wanted in [
            "Volume, ml",
            "Time, ms",
            "ED",
            "ES",
            "epicardium",
            "800",
            "60",
        ] {
            assert!(words.contains(&wanted), "{wanted}: {words:?}");
        }
        let curve = page.marks.iter().find_map(|mark| match mark {
            Mark::Line { points, colour, .. } if *colour == EPICARDIUM[0] => Some(points),
            _ => None,
        });
        let [first, lowest, last] = curve.unwrap()[..] else {
            panic!("{curve:?}");
        };
        assert_eq!(first[1], last[1]);
        assert!(lowest[1] > first[1] && (lowest[0] - 0.5 * (first[0] + last[0])).abs() < 1e-3);
    }
}
