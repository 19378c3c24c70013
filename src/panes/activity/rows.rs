//! Lines of the activity list.

use crate::engine::{Activity, ActivityState};

use super::{WorkItem, WorkState};

/// Lines of the activity list, newest first.
pub fn activity_rows(activities: &[Activity]) -> Vec<WorkItem> {
    activities
        .iter()
        .map(|activity| WorkItem {
            kind: activity.topic,
            title: activity.name.clone(),
            parameters: activity.parameters.clone(),
            duration_s: activity.duration.as_secs_f64(),
            state: match &activity.state {
                ActivityState::Running {
                    fraction,
                    time_left,
                    ..
                } => WorkState::Running {
                    fraction: *fraction,
                    seconds_left: time_left.map(|left| left.as_secs_f64()),
                },
                ActivityState::Done => WorkState::Done,
                ActivityState::Stopped => WorkState::Stopped,
                ActivityState::Failed(reason) => WorkState::Failed(reason.clone()),
            },
        })
        .collect()
}
