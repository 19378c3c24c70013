//! What the pane of thickness methods shows, as plain values.

use crate::panes::work_state::WorkState;

/// Thickness at one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct ThicknessStrip {
    /// "ED", "ES", "frame 3".
    pub moment: String,
    /// Whether it is the pose on screen.
    pub on_screen: bool,
    /// 5, 25, 50, 75 and 95 % of vertices are thinner than these, in the unit of the view.
    pub quantiles: [f64; 5],
}

/// Difference of a method from twice the medial radius at the pose on screen, in the unit of the view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Mean difference.
    pub bias: f64,
    /// Standard deviation of the differences.
    pub deviation: f64,
    /// Vertices compared.
    pub pairs: usize,
}

/// One method.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ThicknessRow {
    /// "Laplace field lines".
    pub name: String,
    /// What it measures.
    pub hint: &'static str,
    /// By pose; empty while nothing is known.
    pub strips: Vec<ThicknessStrip>,
    /// Against the medial radius; `None` for that itself, and while not known.
    pub difference: Option<Difference>,
    /// Whether the others are compared with it.
    pub reference: bool,
    /// Time for one pose.
    pub seconds: Option<f64>,
    /// Why it does not apply at a pose.
    pub reason: Option<String>,
}

/// What the pane shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ThicknessPanelView<'a> {
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// State of the measurement; its phase is the pose: "ED", "frame 3".
    pub state: WorkState,
    /// The pose that differences are of: "ES", "frame 3".
    pub moment: String,
    /// Unit of lengths.
    pub unit: &'a str,
    /// The methods, medial spheres first.
    pub rows: Vec<ThicknessRow>,
    /// Upper end of the axis; it begins at 0.
    pub max: f64,
}
