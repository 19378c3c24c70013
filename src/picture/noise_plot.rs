//! The noise study as a figure: cluster agreement τ over the level of noise, a panel per family, a line per method.

use crate::analysis::experiments::{
    NoiseCell, NoiseDeformationResult, NoiseFamily, NoiseReference,
};
use crate::picture::figure::Pen;
use crate::picture::page::{Anchor, FigureFonts, Page};
use crate::picture::patch_words::sentence;
use crate::picture::tokens::{PictureTheme, srgb};

/// Width of a panel with its margin.
pub(super) const PANEL: f32 = 300.0;
/// Width and height of its plot.
pub(super) const PLOT: [f32; 2] = [220.0, 220.0];
/// Left of the first plot.
pub(super) const LEFT: f32 = 60.0;
/// Above the plots.
pub(super) const TOP: f32 = 40.0;
/// Distance of lines of the legend.
const LEGEND_LINE: f32 = 20.0;

/// Okabe and Ito's colours, which all eyes distinguish.
const COLOURS: [u32; 5] = [0x00_72b2, 0xd5_5e00, 0x66_6666, 0x00_9e73, 0xcc_79a7];
const BLACK: [f32; 3] = [0.0; 3];
const GRID: u32 = 0xdd_dddd;
const THEME: PictureTheme = PictureTheme::LIGHT;

/// Panels for the noise in percent of the shape's variance; crosses are the values of table 3.1.
pub fn noise_page(result: &NoiseDeformationResult, fonts: &FigureFonts) -> Page {
    let families = &result.params.families;
    let methods: Vec<&str> = result.params.methods.iter().map(|m| m.name).collect();
    let width = LEFT + PANEL * families.len().max(1) as f32;
    let height = TOP + PLOT[1] + 60.0 + LEGEND_LINE * methods.len() as f32;
    let mut page = Page::new([width, height], Some([1.0; 3]));
    let mut plot = Plot::new(&mut page, fonts, &result.params.percents);
    for (column, &family) in families.iter().enumerate() {
        plot.left = LEFT + PANEL * column as f32;
        plot.noise_axes(family);
        for (index, method) in methods.iter().enumerate() {
            let cells = result.cells.iter().filter(|cell| {
                cell.method == *method
                    && cell.reference == NoiseReference::Shape
                    && cell.family.is_none_or(|of| of == family)
            });
            plot.line(index, cells.map(Value::from));
        }
        for cell in &result.cells {
            let first = cell.method == methods[0] && cell.reference == NoiseReference::Shape;
            if let Some(published) = cell
                .published
                .filter(|_| first && cell.family == Some(family))
            {
                plot.cross(cell.percent, published);
            }
        }
    }
    plot.legend(
        &methods,
        "Crosses: table 3.1 of the text. τ: cluster agreement; bars: standard error",
    );
    page
}

/// One mean of a line, with its standard error.
pub(super) struct Value {
    /// Level of noise, or size of a patch, in percent.
    pub percent: f64,
    /// From 0 to 1.
    pub mean: f64,
    /// In the same unit.
    pub standard_error: f64,
}

impl From<&NoiseCell> for Value {
    fn from(cell: &NoiseCell) -> Self {
        Self {
            percent: cell.percent,
            mean: cell.tau,
            standard_error: cell.standard_error,
        }
    }
}

/// One panel at a time of a page of panels.
pub(super) struct Plot<'a> {
    pen: Pen<'a>,
    /// Left edge of the current plot.
    pub left: f32,
    /// Upper edge of the current row of panels.
    pub above: f32,
    /// Levels at even distances; clean data stand before them.
    pub levels: Vec<f64>,
}

impl<'a> Plot<'a> {
    pub fn new(page: &'a mut Page, fonts: &'a FigureFonts, levels: &[f64]) -> Self {
        Self {
            pen: Pen {
                page,
                fonts,
                theme: &THEME,
                text: 12.0,
            },
            left: LEFT,
            above: 0.0,
            levels: levels.to_vec(),
        }
    }

    /// Clean data stand at the left edge, levels at even distances.
    fn across(&self, percent: f64) -> f32 {
        let place = self.levels.iter().position(|level| *level == percent);
        let step = PLOT[0] / self.levels.len().max(1) as f32;
        self.left + place.map_or(0.0, |index| step * (index + 1) as f32)
    }

    /// 1 at the top, 0 at the bottom.
    fn down(&self, share: f64) -> f32 {
        self.above + TOP + PLOT[1] * (1.0 - share.clamp(0.0, 1.0) as f32)
    }

    pub fn write(&mut self, words: &str, anchor: Anchor, at: [f32; 2]) {
        let set = self.pen.regular(BLACK);
        self.pen.write(words, set, anchor, at);
    }

    /// Title, horizontal grid with its words, and words of the horizontal axis.
    pub fn frame(&mut self, title: &str, words: impl Fn(f64) -> String, axis: &str) {
        let strong = self.pen.strong(BLACK, self.pen.text);
        let at = [self.left, self.above + 24.0];
        self.pen.write(title, strong, Anchor::Start, at);
        let right = self.left + PLOT[0];
        for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let y = self.down(share);
            let ends = [[self.left, y], [right, y]];
            self.pen.page.line(&ends, false, 1.0, srgb(GRID));
            self.write(&words(share), Anchor::End, [self.left - 6.0, y + 4.0]);
        }
        let middle = self.left + 0.5 * PLOT[0];
        self.write(axis, Anchor::Middle, [middle, self.down(0.0) + 34.0]);
    }

    /// Words below one level.
    pub fn level(&mut self, percent: f64, words: &str) {
        let at = [self.across(percent), self.down(0.0) + 16.0];
        self.write(words, Anchor::Middle, at);
    }

    /// The axes of a panel of one family of noise.
    pub fn noise_axes(&mut self, family: NoiseFamily) {
        let title = format!("{} noise", sentence(family.name()));
        let percent = |share: f64| format!("{:.0} %", 100.0 * share);
        self.frame(&title, percent, "noise, % of variance");
        for level in std::iter::once(0.0).chain(self.levels.clone()) {
            self.level(level, &level.to_string());
        }
    }

    /// Means joined by a line, with bars of one standard error.
    pub fn line(&mut self, index: usize, values: impl Iterator<Item = Value>) {
        let colour = colour(index);
        let mut points = Vec::new();
        for value in values {
            let x = self.across(value.percent);
            let [low, high] = [-1.0, 1.0]
                .map(|sign: f64| [x, self.down(value.mean + sign * value.standard_error)]);
            let at = [x, self.down(value.mean)];
            self.pen.page.line(&[low, high], false, 1.0, colour);
            self.disc(at, 3.0, colour);
            points.push(at);
        }
        if !points.is_empty() {
            self.pen.page.line(&points, false, 1.5, colour);
        }
    }

    /// A published value.
    pub fn cross(&mut self, percent: f64, share: f64) {
        let [x, y] = [self.across(percent), self.down(share)];
        for turn in [1.0, -1.0] {
            let ends = [[x - 4.0, y - 4.0 * turn], [x + 4.0, y + 4.0 * turn]];
            self.pen.page.line(&ends, false, 1.0, BLACK);
        }
    }

    /// A dot and the name of a line.
    pub fn name(&mut self, index: usize, words: &str, [x, y]: [f32; 2]) {
        self.disc([x, y - 4.0], 4.0, colour(index));
        self.write(words, Anchor::Start, [x + 12.0, y]);
    }

    /// Names of the lines below the panels, and what else is drawn.
    pub fn legend(&mut self, methods: &[&str], note: &str) {
        let top = self.down(0.0) + 60.0;
        for (index, method) in methods.iter().enumerate() {
            self.name(index, method, [LEFT, top + LEGEND_LINE * index as f32]);
        }
        self.write(note, Anchor::Start, [LEFT + PANEL, top]);
    }

    /// A line of no length has round ends: a disc.
    fn disc(&mut self, [x, y]: [f32; 2], radius: f32, colour: [f32; 3]) {
        let ends = [[x, y], [x + 0.01, y]];
        self.pen.page.line(&ends, false, 2.0 * radius, colour);
    }
}

fn colour(index: usize) -> [f32; 3] {
    srgb(COLOURS[index % COLOURS.len()])
}
