//! How whole deformations become points: neighbours, regularisation, time.

use egui::Ui;

use crate::analysis::deformations::DeformationMapParams;
use crate::panes::metric::MetricPanelView;
use crate::ui::number_field::{NumberField, number_field_ui, number_text, whole};

/// Draws the numbers of locally linear embedding; the settings after a change.
pub fn deformation_map_ui(ui: &mut Ui, view: &MetricPanelView) -> Option<DeformationMapParams> {
    let params = view.deformations;
    let checked = |params: DeformationMapParams| match params.check() {
        Ok(_) => Ok(params),
        Err(error) => Err(error.to_string()),
    };
    let mut changed = None;
    let automatic_text = |value: Option<String>| match value {
        Some(value) => format!("auto: {value}"),
        None => "automatic".to_owned(),
    };
    let automatic = automatic_text(view.neighbours.map(|count| count.to_string()));
    let neighbours = NumberField {
        name: "Neighbours",
        unit: "subjects",
        what: "Neighbours from which LLE reconstructs each subject; empty: a fifth of the cohort, at least 4",
        value: params.neighbours.map(f64::from),
        automatic: Some(&automatic),
        enabled: true,
    };
    let accept = |value: Option<f64>| {
        let neighbours = match value {
            None => None,
            Some(value) => Some(whole(value, u32::from(u16::MAX))? as u16),
        };
        checked(DeformationMapParams {
            neighbours,
            ..params
        })
    };
    changed = number_field_ui(ui, &neighbours, accept).or(changed);
    let regularisation = NumberField {
        name: "Regularisation",
        unit: "",
        what: "Limits the reconstruction weights of LLE; relative to the trace of the neighbours' Gram matrix, no unit",
        value: Some(params.regularisation),
        automatic: None,
        enabled: true,
    };
    let accept = |value: Option<f64>| {
        checked(DeformationMapParams {
            regularisation: value.unwrap_or_default(),
            ..params
        })
    };
    changed = number_field_ui(ui, &regularisation, accept).or(changed);
    let two_figures = view.time_weight.map(|weight| {
        let scale = 10_f64.powf(1.0 - weight.abs().max(1e-12).log10().floor());
        number_text((weight * scale).round() / scale)
    });
    let automatic = automatic_text(two_figures.filter(|_| params.time_weight.is_none()));
    let time = NumberField {
        name: "Time weight",
        unit: "/ cycle",
        what: "Distance between start and end of the cycle, in units of the pose map; empty: the spread \
               of the poses; 0: time is ignored",
        value: params.time_weight,
        automatic: Some(&automatic),
        enabled: true,
    };
    let accept = |time_weight: Option<f64>| {
        checked(DeformationMapParams {
            time_weight,
            ..params
        })
    };
    changed = number_field_ui(ui, &time, accept).or(changed);
    let samples = NumberField {
        name: "Points per curve",
        unit: "",
        what: "Number of points at which motions are compared, evenly spaced along each curve",
        value: Some(f64::from(params.samples)),
        automatic: None,
        enabled: true,
    };
    let accept = |value: Option<f64>| {
        checked(DeformationMapParams {
            samples: whole(value.unwrap_or_default(), u32::from(u16::MAX))? as u16,
            ..params
        })
    };
    number_field_ui(ui, &samples, accept).or(changed)
}
