//! What a click into a slice does while a tool is in hand.

use super::current::Current;
use crate::document::ImageTool;
use crate::image::{MarkedPoints, VolumeEdit, VolumeFrame};
use crate::mesh::Point3;
use crate::panes::commands::Command;

/// Spheres of one stroke of the eraser are at least this share of their radius apart: nearer ones would take nothing more away.
const STROKE: f64 = 0.4;

/// The change of settings that a click at a position asks for; `drag` while the pointer is held.
pub fn clicked(
    current: &Current,
    tool: ImageTool,
    eraser_mm: f64,
    at: Point3,
    drag: bool,
) -> Option<Command> {
    current.changed(drag, |settings| {
        let points = &mut settings.points;
        match tool {
            ImageTool::Apex => points.apex = Some(at),
            ImageTool::Base => points.base = Some(at),
            ImageTool::Septum => points.septum = Some(at),
            ImageTool::Blood => points.blood = Some(at),
            ImageTool::Eraser => erase(&mut settings.edits, at, eraser_mm),
            ImageTool::Cut => {
                let middle = heart(points, current.series.image.frame());
                settings.edits.extend(cut(middle, at));
            }
            ImageTool::Keep => settings.edits.push(VolumeEdit::ComponentAt(at)),
        }
    })
}

/// Whether a tool is drawn with: then a drag is many places, else one click is one.
pub fn strokes(tool: ImageTool) -> bool {
    tool == ImageTool::Eraser
}

/// What a tool is called on its button and in hints.
pub fn tool_words(tool: ImageTool) -> [&'static str; 2] {
    match tool {
        ImageTool::Apex => ["Apex", "Click the tip of the left ventricle"],
        ImageTool::Base => ["Base", "Click the middle of the mitral ring"],
        ImageTool::Septum => [
            "Septum",
            "Click the septum, or the right ventricle beyond it",
        ],
        ImageTool::Blood => ["Blood", "Click the blood in the left ventricle"],
        ImageTool::Eraser => [
            "Eraser",
            "Drag over what is no heart: spheres are taken away",
        ],
        ImageTool::Cut => [
            "Cut plane",
            "Click between heart and liver: what lies beyond the plane is taken away",
        ],
        ImageTool::Keep => [
            "Keep this part",
            "Click the heart: what is not connected to it is taken away",
        ],
    }
}

fn erase(edits: &mut Vec<VolumeEdit>, centre: Point3, radius_mm: f64) {
    let near = |edit: &VolumeEdit| match *edit {
        VolumeEdit::SphereEraser {
            centre: last,
            radius_mm: before,
        } => before >= radius_mm && (last - centre).norm() < STROKE * radius_mm,
        _ => false,
    };
    if !edits.last().is_some_and(near) {
        edits.push(VolumeEdit::SphereEraser { centre, radius_mm });
    }
}

/// Where the heart is: its blood, the middle of its axis, or the middle of the image.
fn heart(points: &MarkedPoints, frame: &VolumeFrame) -> Point3 {
    let axis = points.apex.zip(points.base);
    let middle = frame.size().map(|count| 0.5 * (count as f64 - 1.0));
    let axis = axis.map(|(apex, base)| nalgebra::center(&apex, &base));
    points
        .blood
        .or(axis)
        .unwrap_or_else(|| frame.position(Point3::from(middle)))
}

/// The plane through a position that faces the heart; none where the position is the heart itself.
fn cut(heart: Point3, point: Point3) -> Option<VolumeEdit> {
    let normal = (point - heart).try_normalize(1e-6)?;
    Some(VolumeEdit::CutPlane { point, normal })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stroke_of_the_eraser_takes_as_few_spheres_as_cover_it() {
        let mut edits = Vec::new();
        for step in 0..=100 {
            erase(
                &mut edits,
                Point3::new(0.2 * f64::from(step), 0.0, 0.0),
                10.0,
            );
        }
        assert_eq!(edits.len(), 6);
        let lies_within = (0..=200).all(|step| {
            let at = Point3::new(0.1 * f64::from(step), 0.0, 0.0);
            edits.iter().any(|edit| edit.erases(at))
        });
        assert!(lies_within);
    }

    #[test]
    fn a_cut_takes_away_what_lies_beyond_the_click_as_seen_from_the_heart() {
        let heart = Point3::new(10.0, 0.0, 0.0);
        let edit = cut(heart, Point3::new(10.0, 30.0, 0.0)).unwrap();
        assert!(!edit.erases(heart));
        assert!(edit.erases(Point3::new(0.0, 31.0, 5.0)));
        assert!(!edit.erases(Point3::new(0.0, 29.0, 5.0)));
        assert_eq!(cut(heart, heart), None);
    }
}
