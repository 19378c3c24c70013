//! How whole deformations become points: neighbours, regularisation, time.

use egui::Ui;

use crate::analysis::deformations::{Comparison, DeformationMapParams};
use crate::panes::metric::{MetricPanelView, choice_row_ui};
use crate::ui::controls::choices_ui;
use crate::ui::number_field::{Setting, number_text, whole};

const NEIGHBOURS: Setting<DeformationMapParams> = Setting {
    name: "Neighbours",
    unit: "subjects",
    what: "Neighbours from which LLE reconstructs each subject; empty: a tenth of the cohort, 8 to 12 (half of it where curves of poses are compared)",
    get: |map| map.neighbours.map(f64::from),
    set: |map, neighbours| {
        let count = neighbours.map(|count| whole(count, u32::from(u16::MAX)));
        map.neighbours = count.transpose()?.map(|count| count as u16);
        Ok(())
    },
};

const SMOOTHING: Setting<DeformationMapParams> = Setting {
    name: "Smoothing",
    unit: "√area",
    what: "Poses are smoothed below this radius before deformations are compared; 0: no smoothing",
    get: |map| Some(map.smoothing),
    set: |map, smoothing| {
        map.smoothing = smoothing.unwrap_or_default();
        Ok(())
    },
};

const SHAPE_WEIGHT: Setting<DeformationMapParams> = Setting {
    name: "Weight of shape",
    unit: "",
    what: "How much the squared distance of end-diastolic shapes counts beside that of deformations, each over its \
           median; 0: deformations alone",
    get: |map| match map.comparison {
        Comparison::Parts(weights) => Some(weights.shape),
        Comparison::Poses => None,
    },
    set: |map, weight| {
        if let Comparison::Parts(weights) = &mut map.comparison {
            weights.shape = weight.unwrap_or_default();
        }
        Ok(())
    },
};

const REGULARISATION: Setting<DeformationMapParams> = Setting {
    name: "Regularisation",
    unit: "",
    what: "Limits the reconstruction weights of LLE; relative to the trace of the neighbours' Gram matrix, no unit",
    get: |map| Some(map.regularisation),
    set: |map, regularisation| {
        map.regularisation = regularisation.unwrap_or_default();
        Ok(())
    },
};

const TIME_WEIGHT: Setting<DeformationMapParams> = Setting {
    name: "Time weight",
    unit: "/ cycle",
    what: "Distance between start and end of the cycle, in units of the pose map; empty: the spread \
           of the poses; 0: time is ignored",
    get: |map| map.time_weight,
    set: |map, time_weight| {
        map.time_weight = time_weight;
        Ok(())
    },
};

const SAMPLES: Setting<DeformationMapParams> = Setting {
    name: "Points per curve",
    unit: "",
    what: "Number of points at which motions are compared, evenly spaced along each curve",
    get: |map| Some(f64::from(map.samples)),
    set: |map, samples| {
        map.samples = whole(samples.unwrap_or_default(), u32::from(u16::MAX))? as u16;
        Ok(())
    },
};

/// Draws the numbers of locally linear embedding; a change goes into `wanted`.
pub fn deformation_map_ui(ui: &mut Ui, view: &MetricPanelView, wanted: &mut DeformationMapParams) {
    let automatic = |value: Option<String>| match value {
        Some(value) => format!("auto: {value}"),
        None => "automatic".to_owned(),
    };
    let two_figures = view.time_weight.map(|weight| {
        let scale = 10_f64.powf(1.0 - weight.abs().max(1e-12).log10().floor());
        number_text((weight * scale).round() / scale)
    });
    let neighbours = automatic(view.neighbours.map(|count| count.to_string()));
    let time = automatic(two_figures.filter(|_| wanted.time_weight.is_none()));
    let what = "What of two beats is compared: motion relative to the own end-diastole, the end-diastolic shape, or both";
    let shown = wanted.comparison.name();
    choice_row_ui(ui, "Compare", what, shown, true, |ui| {
        let choices = Comparison::NAMED.map(|comparison| (comparison.name(), comparison.name()));
        if let Some(name) = choices_ui(ui, choices, shown) {
            let chosen = Comparison::NAMED
                .into_iter()
                .find(|comparison| comparison.name() == name);
            wanted.comparison = chosen.unwrap_or(wanted.comparison);
        }
    });
    let curves = wanted.comparison == Comparison::Poses;
    for (setting, automatic, enabled) in [
        (SHAPE_WEIGHT, None, !curves),
        (SMOOTHING, None, !curves),
        (NEIGHBOURS, Some(&*neighbours), true),
        (REGULARISATION, None, true),
        (TIME_WEIGHT, Some(&*time), curves),
        (SAMPLES, None, curves),
    ] {
        setting.ui(ui, wanted, automatic, enabled, |map| match map.check() {
            Ok(_) => Ok(()),
            Err(error) => Err(error.to_string()),
        });
    }
}
