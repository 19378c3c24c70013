//! The map of poses of the medial shape space as a table, and what a summary says of it.

use serde_json::{Value, json};

use crate::analysis::medial_map::MedialMap;
use crate::study::Study;

use super::report_csv::Table;

/// Places of the steps of all paths, a row per step, numbered from 0 as frames and patches are. `patch` is empty where
/// the path is that of all that stands still; places have no unit. Without a map there are no rows.
pub fn medial_mds_csv(study: &Study, map: Option<&MedialMap>) -> String {
    let columns = ["subject", "step_from", "step_to", "patch", "x", "y"];
    let mut table = Table::new(&columns);
    let rows = map.map_or(&[][..], |map| &map.poses).iter().enumerate();
    for (row, pose) in rows {
        let subject = study.subjects.get(pose.subject);
        let place = map.map_or(&[][..], |map| map.embedding.point(row));
        let at = |axis: usize| place.get(axis).map_or_else(String::new, f64::to_string);
        let patch = pose.part.patch();
        table.row([
            subject.map_or_else(String::new, |subject| subject.id.clone()),
            pose.step_from.to_string(),
            pose.step_to.to_string(),
            patch.map_or_else(String::new, |patch| patch.to_string()),
            at(0),
            at(1),
        ]);
    }
    table.text
}

/// What a summary says of the map: how well it keeps distances, in which axes hearts were compared, and who is not
/// on it; without a map, why.
pub fn medial_map_json(study: &Study, map: Option<&MedialMap>, without: Option<&str>) -> Value {
    let Some(map) = map else {
        return json!({ "reason": without });
    };
    let id = |subject: usize| study.subjects.get(subject).map(|subject| &subject.id);
    let paths: Vec<Value> = (map.spreads.iter())
        .map(|spread| {
            json!({
                "subject": id(spread.subject),
                "patch": spread.part.patch(),
                "mean_distance": spread.mean_distance,
            })
        })
        .collect();
    let left_out: Vec<Value> = (map.left_out.iter())
        .map(|(subject, reason)| json!({ "subject": id(*subject), "reason": reason }))
        .collect();
    json!({
        "poses": map.poses.len(),
        "stress": map.embedding.stress,
        "frame": map.frame.words(),
        "paths": paths,
        "left_out": left_out,
    })
}
