//! What the pointer reads on the map.

use egui::{Response, Ui};

use crate::ui::map_ground::{subject_ui, tooltip_ui};
use crate::ui::medial_map::{MedialMapView, MedialPoint};
use crate::ui::style::note;

/// Shows the tooltip of the point under the pointer.
pub fn hover_ui(response: Response, view: &MedialMapView, nearest: Option<usize>) {
    let Some(point) = nearest.and_then(|index| view.points.get(index)) else {
        return;
    };
    tooltip_ui(response, |ui| point_ui(ui, view, point));
}

fn point_ui(ui: &mut Ui, view: &MedialMapView, point: &MedialPoint) {
    let Some(subject) = view.subjects.get(point.subject) else {
        return;
    };
    let (from, to) = (point.from, point.to);
    let phase = point.phase.after_name();
    let title = format!("{} · frame {from} to {to}{phase}", subject.id);
    subject_ui(ui, &title, subject);
    ui.label(part_text(point));
    if let Some(spread) = point.spread {
        ui.label(format!(
            "Poses of this path lie {spread:.2} apart on average"
        ));
    }
    ui.label(note("Click to play this heart from this pose"));
}

/// "Patch 1: PT 1.02 × on average over the step".
fn part_text(point: &MedialPoint) -> String {
    let part = match point.patch {
        Some(patch) => format!("Patch {}", patch + 1),
        None => "All that stands still".to_owned(),
    };
    format!("{part}: PT {:.2} × on average over the step", point.ratio)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_are_counted_as_people_do() {
        let mut point = MedialPoint {
            patch: Some(0),
            ratio: 1.018,
            ..MedialPoint::default()
        };
        assert_eq!(
            part_text(&point),
            "Patch 1: PT 1.02 × on average over the step"
        );
        point.patch = None;
        assert!(part_text(&point).starts_with("All that stands still: PT 1.02 ×"));
    }
}
