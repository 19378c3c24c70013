//! A cohort made up for pictures and layouts: ids, labels and numbers that look like a study's.

use std::f64::consts::{PI, TAU};

use cardiomorph::engine::PoseMapParams;
use cardiomorph::study::LabelRole;
use cardiomorph::ui::*;

/// What panels show.
pub struct Example {
    pub rows: Vec<CohortRow>,
    pub subjects: Vec<MapSubject>,
    pub points: Vec<MapPoint>,
    pub volumes: Vec<f64>,
    pub outer: Vec<f64>,
    pub shares: Vec<f64>,
    pub actions: ActionState,
}

impl Example {
    pub fn new() -> Self {
        let groups = [
            ("NOR", LabelRole::Normal, 9, 0.62),
            ("MINF", LabelRole::Abnormal, 8, 0.36),
            ("DCM", LabelRole::Abnormal, 4, 0.22),
            ("RV", LabelRole::Unknown, 2, 0.55),
        ];
        let (mut rows, mut subjects, mut points) = (Vec::new(), Vec::new(), Vec::new());
        for (label, role, count, ef) in groups {
            for _ in 0..count {
                let subject = rows.len();
                let wobble = (subject as f64 * 2.399).sin();
                let ejection_fraction = Some(ef + 0.06 * wobble);
                rows.push(CohortRow {
                    id: format!("P-{:03}", 41 + subject),
                    label: Some(label.to_owned()),
                    role,
                    ejection_fraction,
                    frame_count: 8,
                    warning_count: usize::from(subject == 5),
                    correspondence: 0,
                });
                subjects.push(MapSubject {
                    id: rows[subject].id.clone(),
                    label: Some(label.to_owned()),
                    role,
                    ejection_fraction,
                });
                for frame in 0..8 {
                    let turn = (1.0 - (TAU * frame as f64 / 8.0).cos()) / 2.0;
                    let aside = (TAU * frame as f64 / 8.0).sin() * 0.16;
                    let start = [wobble, 0.8 * (subject as f64 * 1.7).cos()];
                    points.push(MapPoint {
                        subject,
                        frame,
                        at: [
                            start[0] + ef * 4.0 * turn + aside * wobble,
                            start[1] + ef * 2.0 * turn * (0.4 + 0.5 * wobble) + aside,
                        ],
                        phase: match frame {
                            0 => PosePhase::EndDiastole,
                            4 => PosePhase::EndSystole,
                            _ => PosePhase::Between,
                        },
                    });
                }
            }
        }
        let shares: Vec<f64> = (0..8).map(|frame| frame as f64 / 8.0).collect();
        let volumes = shares
            .iter()
            .map(|s| 104.0 - 38.0 * (PI * s).sin().powi(2))
            .collect();
        let outer = shares
            .iter()
            .map(|s| 196.0 - 34.0 * (PI * s).sin().powi(2))
            .collect();
        let actions = ActionState {
            has_study: true,
            can_undo: true,
            shows_endocardium: true,
            shows_epicardium: true,
            looping: true,
            ..Default::default()
        };
        Self {
            rows,
            subjects,
            points,
            volumes,
            outer,
            shares,
            actions,
        }
    }

    pub fn axis(&self) -> BeatAxis<'_> {
        BeatAxis {
            frame_shares: &self.shares,
        }
    }

    pub fn map(&self, state: MapState) -> PoseMapView<'_> {
        let part = |axis: usize| {
            let (from, to) = (&self.points[9 * 8 + 2], &self.points[9 * 8 + 3]);
            from.at[axis] + 0.4 * (to.at[axis] - from.at[axis])
        };
        PoseMapView {
            state,
            subjects: &self.subjects,
            points: &self.points,
            selected: Some(9),
            selected_frame: 2,
            current: Some([part(0), part(1)]),
            compared: None,
            params: PoseMapParams::default(),
            stress: Some(0.083),
            left_out: "",
        }
    }
}
