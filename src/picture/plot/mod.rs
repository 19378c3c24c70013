//! Figures of plots: maps of points, the bull's-eye, curves over the cycle, each with its title, axes, legend and notes.

mod axes;
mod curves;
mod label_legend;
mod make;
mod map;
mod marks;
mod names;

pub use curves::{CurvePlot, CurveRole, PlotCurve};
pub use label_legend::LegendEntry;
pub use make::{Plot, PlotColours, PlotFigure, drawn_plot};
pub use map::{MapPath, MapPlot, MapPoint, PointLook};

pub(in crate::picture) use label_legend::{LegendPlace, draw_label_legend};
pub(in crate::picture) use map::{MapLook, draw_map};
