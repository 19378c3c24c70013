//! The page of a plot: title, how it was made, the plot, what its marks mean, what the figure is not for.

use crate::picture::figure::{BullsEyeContent, Figure, Pen, draw_bulls_eye, imprint};
use crate::picture::page::{Anchor, FigureFonts, Page, Weight};
use crate::picture::tokens::PictureTheme;

use super::axes::{draw_axes, plot_area, widest_number};
use super::curves::{CurvePlot, draw_curves};
use super::label_legend::{LegendPlace, draw_label_legend};
use super::map::{MapFrame, MapLook, MapPlot, draw_map};

/// The size that the design was drawn at; other sizes scale with it.
const DESIGN: [f32; 2] = [1200.0, 900.0];
/// Text below 10.5 pixels is not legible: sizes stop shrinking here.
const MIN_SCALE: f32 = 0.7;

/// What is plotted.
#[derive(Clone, Debug, PartialEq)]
pub enum Plot {
    /// A map of points.
    Map(MapPlot),
    /// The bull's-eye of one subject.
    BullsEye(Box<BullsEyeContent>),
    /// Curves over the cycle of one subject.
    Curves(CurvePlot),
}

/// A plot with all that is said of it, fixed when it is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotFigure {
    /// Beginning of its file's name, without an ending.
    pub stem: String,
    /// What it shows, by which metric and method, of whom.
    pub title: String,
    /// How it was made, below the title.
    pub lines: Vec<String>,
    /// What its marks mean, and what is not on it, below the plot.
    pub notes: Vec<String>,
    /// The plot.
    pub plot: Plot,
}

/// Size and colours of a plot's page.
#[derive(Clone, Copy, Debug)]
pub struct PlotColours<'a> {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Of words and lines.
    pub theme: &'a PictureTheme,
    /// Whether nothing stands behind it.
    pub transparent: bool,
}

/// Draws the page of a plot, with what it says as settings for its file.
pub fn drawn_plot(figure: &PlotFigure, colours: &PlotColours<'_>, fonts: &FigureFonts) -> Figure {
    let PlotColours { theme, .. } = *colours;
    let size = colours.size.map(|pixels| pixels as f32);
    let scale = (size[0] / DESIGN[0])
        .min(size[1] / DESIGN[1])
        .max(MIN_SCALE);
    let background = (!colours.transparent).then_some(theme.background);
    let mut page = Page::new(size, background);
    let mut pen = Pen {
        page: &mut page,
        fonts,
        theme,
        text: 15.0 * scale,
    };
    let margin = 22.0 * scale;
    let top = header(&mut pen, figure, margin, 26.0 * scale);
    let words = [
        figure.notes.join(". "),
        format!(
            "Cardiomorph {} · research use, not for diagnosis",
            env!("CARGO_PKG_VERSION")
        ),
    ];
    let room = size[0] - 2.0 * margin;
    let wrapped = |words: &String| fonts.wrapped(words, Weight::Regular, 0.87 * pen.text, room);
    let lines: Vec<String> = words.iter().flat_map(wrapped).collect();
    let above = imprint(&mut pen, &lines, [margin, size[1] - 0.8 * margin]);
    let bottom = above - 0.4 * pen.line_height();
    let outer = [[margin, top], [size[0] - margin, bottom.max(top + 1.0)]];
    let unnamed = match &figure.plot {
        Plot::Map(map) => draw_map_with_axes(&mut pen, map, outer),
        Plot::BullsEye(content) => {
            draw_bulls_eye(&mut pen, content, outer[0], outer[1]);
            None
        }
        Plot::Curves(curves) => {
            draw_curves(&mut pen, curves, outer);
            None
        }
    };
    let mut settings = vec![
        (
            "Software",
            concat!("Cardiomorph ", env!("CARGO_PKG_VERSION")).to_owned(),
        ),
        ("Comment", "research use, not for diagnosis".to_owned()),
        ("Title", figure.title.clone()),
    ];
    let said = figure.lines.iter().map(|line| ("Parameters", line.clone()));
    let notes = figure.notes.iter().chain(&unnamed);
    settings.extend(said.chain(notes.map(|note| ("Note", note.clone()))));
    Figure { page, settings }
}

/// Title and lines; returns where the plot begins.
fn header(pen: &mut Pen<'_>, figure: &PlotFigure, margin: f32, title: f32) -> f32 {
    let room = pen.page.size[0] - 2.0 * margin;
    let name = pen.strong(pen.theme.text, title);
    let mut base = margin + 0.75 * title;
    pen.write_within(&figure.title, name, Anchor::Start, [margin, base], room);
    let muted = pen.regular(pen.theme.muted);
    for line in &figure.lines {
        for words in pen.fonts.wrapped(line, Weight::Regular, pen.text, room) {
            base += pen.line_height();
            pen.write(&words, muted, Anchor::Start, [margin, base]);
        }
    }
    base + 0.6 * pen.line_height()
}

/// A map with axes, and its legend below; names that have no room are counted.
fn draw_map_with_axes(pen: &mut Pen<'_>, map: &MapPlot, outer: [[f32; 2]; 2]) -> Option<String> {
    let (text, line) = (pen.text, pen.line_height());
    let [low, high] = outer;
    let mark = 0.36 * text;
    let legend = |base: f32| LegendPlace {
        left: low[0],
        right: high[0],
        base,
        last: high[1],
        mark,
    };
    // Drawn once on a page that is thrown away, for its height.
    let mut aside = Page::new(pen.page.size, None);
    let mut trial = Pen {
        page: &mut aside,
        fonts: pen.fonts,
        theme: pen.theme,
        text,
    };
    let lines = ((0.3 * (high[1] - low[1]) / line) as usize).max(1);
    let first = high[1] - line * (lines - 1) as f32;
    let used = draw_label_legend(&mut trial, &map.legend, legend(first)) - first;
    let base = high[1] - used;
    let above = [low, [high[0], base - 1.6 * line]];
    let look = MapLook {
        mark,
        path: (text / 15.0).max(0.7),
        name: 0.8 * text,
        air: 2.0 * text,
    };
    let [_, up] = MapFrame::of(map, plot_area(pen, above, 3.0 * text), look.air).axes();
    let widest = widest_number(pen, &up, above[1][1] - above[0][1]);
    let area = plot_area(pen, above, widest);
    let [across, up] = MapFrame::of(map, area, look.air).axes();
    draw_axes(pen, area, [&across, &up]);
    let [without, count] = draw_map(pen, map, area, look);
    draw_label_legend(pen, &map.legend, legend(base));
    if without == 0 {
        return None;
    }
    let note = format!("{without} of {count} names are left out for lack of room");
    let mut muted = pen.regular(pen.theme.muted);
    muted.size *= 0.8;
    let at = [area[1][0], area[0][1] - 0.4 * line];
    pen.write(&note, muted, Anchor::End, at);
    Some(note)
}
