//! How whole deformations become points: neighbours, regularisation, time.

use egui::Ui;

use crate::analysis::deformations::{Comparison, DeformationMapParams};
use crate::panes::metric::{MetricPanelView, choice_row_ui};
use crate::ui::controls::choices_ui;
use crate::ui::number_field::{ABOVE_ZERO, Setting, number_text, whole};

const NEIGHBOURS: Setting<DeformationMapParams> = Setting {
    name: "Neighbours",
    unit: "subjects",
    what: "Neighbours from which LLE reconstructs each subject; empty: a tenth of the cohort, 8 to 12 (half of it where curves of poses are compared)",
    range: [1.0, u16::MAX as f64],
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
    range: [0.0, 1.0],
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
    range: [0.0, f64::INFINITY],
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
    what: "Limits the reconstruction weights of LLE; relative to the trace of the neighbours' Gram matrix",
    range: [ABOVE_ZERO, 1.0],
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
    range: [0.0, f64::INFINITY],
    get: |map| map.time_weight,
    set: |map, time_weight| {
        map.time_weight = time_weight;
        Ok(())
    },
};

const SAMPLES: Setting<DeformationMapParams> = Setting {
    name: "Points per curve",
    unit: "points",
    what: "Number of points at which motions are compared, evenly spaced along each curve",
    range: [2.0, 1024.0],
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::number_field::assert_takes_its_range;

    #[test]
    fn each_number_takes_what_its_range_says_and_no_more() {
        let takes = |params: &DeformationMapParams| params.check().is_ok();
        for setting in [
            SHAPE_WEIGHT,
            SMOOTHING,
            NEIGHBOURS,
            REGULARISATION,
            TIME_WEIGHT,
            SAMPLES,
        ] {
            assert_takes_its_range(&setting, takes);
        }
    }
}
