//! Design tokens: every colour, size and width of the window stands here and nowhere else.

use egui::Color32;

/// Type sizes in points: notes, text, headings, the one number that matters.
pub mod type_size {
    /// Notes, axis labels, legends.
    pub const NOTE: f32 = 12.0;
    /// Running text, buttons, table cells.
    pub const TEXT: f32 = 13.0;
    /// Headings of windows.
    pub const HEADING: f32 = 16.0;
    /// Subject titles and the ejection fraction.
    pub const TITLE: f32 = 20.0;
}

/// Distances in points, on a grid of four.
pub mod space {
    /// Between things that belong together.
    pub const SMALL: f32 = 4.0;
    /// Between things in a row.
    pub const MEDIUM: f32 = 8.0;
    /// Inner margin of a pane.
    pub const LARGE: f32 = 12.0;
    /// Between groups.
    pub const HUGE: f32 = 24.0;
    /// Between panes.
    pub const PANE_GAP: f32 = 6.0;
    /// Height of a pane's header.
    pub const PANE_HEADER: f32 = 32.0;
    /// Height of a row in a table.
    pub const ROW: f32 = 24.0;
}

/// Corner radii in points.
pub mod radius {
    /// Panes and windows.
    pub const PANE: u8 = 6;
    /// Buttons, fields, cards.
    pub const CONTROL: u8 = 4;
}

/// Line widths in points.
pub mod line {
    /// Frames, grids, axes.
    pub const THIN: f32 = 1.0;
    /// Curves and marks.
    pub const MARK: f32 = 1.5;
    /// The selected path, the tab in front.
    pub const STRONG: f32 = 2.0;
}

/// Seconds that a change of appearance takes.
pub const MOTION_S: f32 = 0.12;

/// Seconds that points take from an old map to a new one: long enough for the eye to follow.
pub const MORPH_S: f64 = 0.3;

/// Colours of one theme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colours {
    /// Behind the panes.
    pub window: Color32,
    /// Behind text and plots.
    pub pane: Color32,
    /// Behind buttons and fields.
    pub control: Color32,
    /// Behind a button under the pointer.
    pub control_hovered: Color32,
    /// Around panes and controls.
    pub line: Color32,
    /// Lines within plots.
    pub grid: Color32,
    /// Text and numbers.
    pub text: Color32,
    /// Headings and the numbers that matter.
    pub strong: Color32,
    /// Units, notes, what is not selected.
    pub muted: Color32,
    /// The one accent: focus, progress, tabs.
    pub accent: Color32,
    /// On top of the accent.
    pub on_accent: Color32,
    /// Behind the selected row.
    pub selected_row: Color32,
    /// The selection in every view.
    pub selection: Color32,
    /// Subjects of class normal.
    pub normal: Color32,
    /// Subjects of class abnormal.
    pub abnormal: Color32,
    /// Subjects of neither class.
    pub unknown: Color32,
    /// Something is unusable.
    pub error: Color32,
    /// A warning.
    pub warning: Color32,
    /// Labels other than normal: distinct from each other, from normal and from the selection, for colour-blind readers
    /// too.
    pub labels: [Color32; 8],
    /// Clusters: distinct from the classes and from each other, in any order.
    pub clusters: [Color32; 6],
    /// Inner surface.
    pub endocardium: Color32,
    /// Outer surface.
    pub epicardium: Color32,
}

/// For dark rooms.
pub const DARK: Colours = Colours {
    window: Color32::from_rgb(0x14, 0x17, 0x1b),
    pane: Color32::from_rgb(0x1a, 0x1e, 0x24),
    control: Color32::from_rgb(0x22, 0x28, 0x30),
    control_hovered: Color32::from_rgb(0x26, 0x2d, 0x36),
    line: Color32::from_rgb(0x2a, 0x30, 0x38),
    grid: Color32::from_rgb(0x24, 0x2a, 0x32),
    text: Color32::from_rgb(0xd7, 0xdc, 0xe2),
    strong: Color32::from_rgb(0xf1, 0xf4, 0xf7),
    muted: Color32::from_rgb(0x8a, 0x94, 0xa1),
    accent: Color32::from_rgb(0x5a, 0xb0, 0xf2),
    on_accent: Color32::from_rgb(0x0d, 0x14, 0x1b),
    selected_row: Color32::from_rgb(0x1d, 0x2d, 0x3d),
    selection: Color32::from_rgb(0xff, 0xd1, 0x66),
    normal: Color32::from_rgb(0x5a, 0xb0, 0xf2),
    abnormal: Color32::from_rgb(0xe7, 0x88, 0x5c),
    unknown: Color32::from_rgb(0x8a, 0x94, 0xa1),
    error: Color32::from_rgb(0xf0, 0x71, 0x78),
    warning: Color32::from_rgb(0xe8, 0xb4, 0x4f),
    labels: [
        Color32::from_rgb(0xe7, 0x88, 0x5c),
        Color32::from_rgb(0x4f, 0xd6, 0xae),
        Color32::from_rgb(0xa3, 0x6c, 0xf7),
        Color32::from_rgb(0xfe, 0xb1, 0xd8),
        Color32::from_rgb(0x2f, 0x9a, 0x3f),
        Color32::from_rgb(0xf2, 0x3a, 0x6e),
        Color32::from_rgb(0xdf, 0xf5, 0xe4),
        Color32::from_rgb(0x9a, 0x8a, 0x00),
    ],
    clusters: [
        Color32::from_rgb(0x4f, 0xc4, 0xa8),
        Color32::from_rgb(0xc0, 0x8f, 0xe8),
        Color32::from_rgb(0xc9, 0xc7, 0x6a),
        Color32::from_rgb(0xe8, 0x8f, 0xb8),
        Color32::from_rgb(0x8f, 0xd1, 0xe8),
        Color32::from_rgb(0xb9, 0xa3, 0x8c),
    ],
    endocardium: Color32::from_rgb(0xba, 0x62, 0x62),
    epicardium: Color32::from_rgb(0xd9, 0xc3, 0xa5),
};

/// For bright rooms and print.
pub const LIGHT: Colours = Colours {
    window: Color32::from_rgb(0xec, 0xee, 0xf1),
    pane: Color32::from_rgb(0xff, 0xff, 0xff),
    control: Color32::from_rgb(0xf1, 0xf3, 0xf6),
    control_hovered: Color32::from_rgb(0xe3, 0xe8, 0xee),
    line: Color32::from_rgb(0xd9, 0xdd, 0xe3),
    grid: Color32::from_rgb(0xed, 0xf0, 0xf3),
    text: Color32::from_rgb(0x1d, 0x25, 0x30),
    strong: Color32::from_rgb(0x0d, 0x13, 0x1b),
    muted: Color32::from_rgb(0x5f, 0x69, 0x76),
    accent: Color32::from_rgb(0x1e, 0x6b, 0xaf),
    on_accent: Color32::from_rgb(0xff, 0xff, 0xff),
    selected_row: Color32::from_rgb(0xdf, 0xeb, 0xf6),
    selection: Color32::from_rgb(0x70, 0x43, 0x00),
    normal: Color32::from_rgb(0x1e, 0x6b, 0xaf),
    abnormal: Color32::from_rgb(0xa6, 0x52, 0x10),
    unknown: Color32::from_rgb(0x60, 0x69, 0x75),
    error: Color32::from_rgb(0xb8, 0x2c, 0x3a),
    warning: Color32::from_rgb(0x8f, 0x5e, 0x07),
    labels: [
        Color32::from_rgb(0xa6, 0x52, 0x10),
        Color32::from_rgb(0x0d, 0x8f, 0x64),
        Color32::from_rgb(0x3c, 0x25, 0xb7),
        Color32::from_rgb(0xc3, 0x3a, 0xe0),
        Color32::from_rgb(0x6b, 0x2a, 0x12),
        Color32::from_rgb(0xd8, 0x1e, 0x52),
        Color32::from_rgb(0x00, 0x41, 0x4d),
        Color32::from_rgb(0x7c, 0x16, 0x78),
    ],
    clusters: [
        Color32::from_rgb(0x0f, 0x7d, 0x64),
        Color32::from_rgb(0x7b, 0x45, 0xb8),
        Color32::from_rgb(0x75, 0x72, 0x12),
        Color32::from_rgb(0xab, 0x3c, 0x77),
        Color32::from_rgb(0x1f, 0x7e, 0x9e),
        Color32::from_rgb(0x7a, 0x62, 0x49),
    ],
    endocardium: Color32::from_rgb(0xa9, 0x4a, 0x4a),
    epicardium: Color32::from_rgb(0x9b, 0x7d, 0x52),
};

impl Colours {
    /// The colours of a theme.
    pub fn of(dark: bool) -> &'static Self {
        if dark { &DARK } else { &LIGHT }
    }

    /// Colour of a cluster; past the last, colours repeat and the letter distinguishes.
    pub fn cluster(&self, cluster: usize) -> Color32 {
        self.clusters[cluster % self.clusters.len()]
    }
}

/// The colours in force where this is drawn.
pub fn colours(ui: &egui::Ui) -> &'static Colours {
    Colours::of(ui.visuals().dark_mode)
}

/// Contrast of two colours as WCAG 2.1 defines it, by their relative luminance.
#[cfg(test)]
pub(crate) fn contrast(a: Color32, b: Color32) -> f64 {
    let luminance = |colour: Color32| {
        let part = |value: u8| {
            let share = f64::from(value) / 255.0;
            if share <= 0.03928 {
                share / 12.92
            } else {
                ((share + 0.055) / 1.055).powf(2.4)
            }
        };
        0.2126 * part(colour.r()) + 0.7152 * part(colour.g()) + 0.0722 * part(colour.b())
    };
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Everything that is read: 4.5 is level AA of WCAG 2.1 for small text. Marks and curves: 3, its level for graphics.
    /// Frames and grid lines are neither, and what is behind them is never told by them alone.
    #[test]
    fn text_and_marks_stand_out_from_whatever_is_behind_them() {
        for theme in [DARK, LIGHT] {
            let texts = [
                ("text", theme.text),
                ("strong", theme.strong),
                ("muted", theme.muted),
                ("accent", theme.accent),
                ("error", theme.error),
                ("warning", theme.warning),
                ("selection", theme.selection),
                ("normal", theme.normal),
                ("abnormal", theme.abnormal),
                ("unknown", theme.unknown),
            ];
            let surfaces = [
                ("endocardium", theme.endocardium),
                ("epicardium", theme.epicardium),
            ];
            let labels = theme.labels.map(|colour| ("label", colour));
            let clusters = theme.clusters.map(|colour| ("cluster", colour));
            let marks: Vec<(&str, Color32)> = [&surfaces[..], &labels, &clusters].concat();
            let behind = [
                ("pane", theme.pane),
                ("window", theme.window),
                ("control", theme.control),
                ("row", theme.selected_row),
                ("hovered", theme.control_hovered),
            ];
            for (name, ground) in behind {
                for (least, colours) in [(4.5, &texts[..]), (3.0, &marks)] {
                    for (colour_name, colour) in colours {
                        // Marks of labels and verdicts stand on rows and panes, not on buttons.
                        let is_mark = ["abnormal", "normal", "unknown"].contains(colour_name);
                        let least = if name == "hovered" && is_mark {
                            3.0
                        } else {
                            least
                        };
                        let found = contrast(*colour, ground);
                        assert!(
                            found >= least,
                            "{colour_name} {colour:?} on {name}: {found:.2}"
                        );
                    }
                }
            }
            assert!(contrast(theme.on_accent, theme.accent) >= 4.5);
        }
    }
}
