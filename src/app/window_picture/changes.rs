//! Where two pictures made of shapes differ.

use egui::epaint::{ClippedShape, TextShape};
use egui::{Pos2, Rect, Shape, pos2};

/// How far the other picture is searched for a shape: more than one pane's row or one map's point.
const SEARCHED: usize = 48;

/// Areas that are drawn apart at most: each repeats what lies across its edges.
const MAX_AREAS: usize = 12;

/// Two areas are drawn as one if that adds at most so many square points to both: a scene of half the window is not
/// made larger for a cursor beside it, while the letters of a text are one area.
const MAX_ADDED: f32 = 3000.0;

/// Width in pixels that smoothing of edges adds around a shape, rounded up.
const FEATHER_PIXELS: f32 = 2.0;

/// Rectangles of whole pixels outside of which both lists of shapes draw the same.
///
/// Shapes keep their order in the alignment of the two lists, so what is left of both outside the areas is drawn in
/// the same order too. A callback is taken as unchanged where its rectangle is: whoever draws it says otherwise.
pub fn changed_areas(
    before: &[ClippedShape],
    now: &[ClippedShape],
    screen: Rect,
    pixels_per_point: f32,
) -> Areas {
    let mut areas = Areas::new(screen, pixels_per_point);
    let (mut i, mut j) = (0, 0);
    while i < before.len() && j < now.len() {
        if same(&before[i], &now[j]) {
            (i, j) = (i + 1, j + 1);
            continue;
        }
        let gone = (i + 1..before.len().min(i + SEARCHED)).find(|&at| same(&before[at], &now[j]));
        let new = (j + 1..now.len().min(j + SEARCHED)).find(|&at| same(&before[i], &now[at]));
        // The nearer of the two, so that few shapes count as changed.
        let (skip_before, skip_now) = match (gone, new) {
            (Some(gone), Some(new)) if gone - i <= new - j => (gone - i, 0),
            (Some(gone), None) => (gone - i, 0),
            (_, Some(new)) => (0, new - j),
            (None, None) => (1, 1),
        };
        for shape in before[i..i + skip_before]
            .iter()
            .chain(&now[j..j + skip_now])
        {
            areas.add_shape(shape);
        }
        (i, j) = (i + skip_before, j + skip_now);
    }
    for shape in before[i..].iter().chain(&now[j..]) {
        areas.add_shape(shape);
    }
    areas
}

/// Few rectangles of whole pixels.
pub struct Areas {
    list: Vec<Rect>,
    screen: Rect,
    pixels_per_point: f32,
}

impl Areas {
    /// No area yet.
    pub fn new(screen: Rect, pixels_per_point: f32) -> Self {
        Self {
            list: Vec::new(),
            screen,
            pixels_per_point,
        }
    }

    /// In points; every edge is that of a pixel.
    pub fn rects(&self) -> &[Rect] {
        &self.list
    }

    /// Adds all pixels that a rectangle in points touches.
    pub fn add(&mut self, rect: Rect) {
        let scale = self.pixels_per_point;
        let within = rect.intersect(self.screen);
        let (min, max) = (
            at_pixels(within.min, scale, f32::floor),
            at_pixels(within.max, scale, f32::ceil),
        );
        self.add_whole(Rect::from_min_max(min, max));
    }

    /// Adds the pixels that egui gives to a scene.
    pub fn add_scene(&mut self, rect: Rect) {
        let within = scene_pixels(rect, self.pixels_per_point).intersect(self.screen);
        self.add_whole(within);
    }

    fn add_whole(&mut self, mut area: Rect) {
        if !area.is_positive() {
            return;
        }
        // An area that grew may reach others that it did not reach before.
        while let Some(at) = (self.list.iter()).position(|other| joins(*other, area)) {
            area = area.union(self.list.swap_remove(at));
        }
        self.list.push(area);
        if self.list.len() > MAX_AREAS {
            self.join_cheapest();
        }
    }

    fn add_shape(&mut self, clipped: &ClippedShape) {
        let feather = FEATHER_PIXELS / self.pixels_per_point;
        let bounds = clipped.transform_after_tessellation * clipped.shape.visual_bounding_rect();
        // A path without area, such as a level line, has a flat rectangle.
        self.add(bounds.expand(feather).intersect(clipped.clip_rect));
    }

    fn join_cheapest(&mut self) {
        let mut best = (f32::INFINITY, 0, 0);
        for (i, a) in self.list.iter().enumerate() {
            for (j, b) in self.list.iter().enumerate().skip(i + 1) {
                let more = a.union(*b).area() - a.area() - b.area();
                if more < best.0 {
                    best = (more, i, j);
                }
            }
        }
        let (_, i, j) = best;
        let other = self.list.swap_remove(j);
        let joined = self.list.swap_remove(i).union(other);
        self.add_whole(joined);
    }
}

fn joins(a: Rect, b: Rect) -> bool {
    a.union(b).area() - a.area() - b.area() <= MAX_ADDED
}

/// The pixels that egui gives to a callback, in points: its edges are rounded.
pub fn scene_pixels(rect: Rect, pixels_per_point: f32) -> Rect {
    let rounded = |at| at_pixels(at, pixels_per_point, f32::round);
    Rect::from_min_max(rounded(rect.min), rounded(rect.max))
}

fn at_pixels(at: Pos2, scale: f32, round: fn(f32) -> f32) -> Pos2 {
    pos2(round(at.x * scale) / scale, round(at.y * scale) / scale)
}

fn same(a: &ClippedShape, b: &ClippedShape) -> bool {
    a.clip_rect == b.clip_rect
        && a.transform_after_tessellation == b.transform_after_tessellation
        && match (&a.shape, &b.shape) {
            (Shape::Callback(a), Shape::Callback(b)) => a.rect == b.rect,
            (Shape::Text(a), Shape::Text(b)) => same_text(a, b),
            (a, b) => a == b,
        }
}

/// Texts that egui laid out once are one galley, whose glyphs need no comparison.
fn same_text(a: &TextShape, b: &TextShape) -> bool {
    if !std::sync::Arc::ptr_eq(&a.galley, &b.galley) {
        return a == b;
    }
    a.pos == b.pos
        && a.underline == b.underline
        && a.fallback_color == b.fallback_color
        && a.override_text_color == b.override_text_color
        && a.opacity_factor == b.opacity_factor
        && a.angle == b.angle
}

#[cfg(test)]
mod tests {
    use egui::{Color32, CornerRadius, vec2};
    use proptest::prelude::*;

    use super::*;

    const SCREEN: Rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(400.0, 300.0));

    fn square(x: f32, y: f32, colour: u8) -> ClippedShape {
        let rect = Rect::from_min_size(pos2(x, y), vec2(10.0, 10.0));
        let fill = Color32::from_gray(colour);
        ClippedShape {
            clip_rect: SCREEN,
            shape: Shape::rect_filled(rect, CornerRadius::ZERO, fill),
            transform_after_tessellation: egui::emath::TSTransform::IDENTITY,
        }
    }

    fn areas(before: &[ClippedShape], now: &[ClippedShape]) -> Vec<Rect> {
        changed_areas(before, now, SCREEN, 1.0).rects().to_vec()
    }

    #[test]
    fn equal_pictures_differ_nowhere() {
        let shapes = [square(1.0, 1.0, 3), square(50.0, 60.0, 9)];
        assert!(areas(&shapes, &shapes).is_empty());
    }

    #[test]
    fn a_changed_shape_is_an_area_with_its_feather() {
        let before = [
            square(1.0, 1.0, 3),
            square(50.0, 60.0, 9),
            square(80.0, 9.0, 2),
        ];
        let now = [
            square(1.0, 1.0, 3),
            square(50.0, 60.0, 8),
            square(80.0, 9.0, 2),
        ];
        let expected = Rect::from_min_max(pos2(48.0, 58.0), pos2(62.0, 72.0));
        assert_eq!(areas(&before, &now), [expected]);
    }

    #[test]
    fn a_new_shape_changes_nothing_of_those_behind_it_in_the_list() {
        let before: Vec<_> = (0..30).map(|n| square(n as f32 * 12.0, 5.0, n)).collect();
        let mut now = before.clone();
        now.insert(3, square(100.0, 200.0, 1));
        let expected = Rect::from_min_max(pos2(98.0, 198.0), pos2(112.0, 212.0));
        assert_eq!(areas(&before, &now), [expected]);
        assert_eq!(areas(&now, &before), [expected], "and when it goes");
    }

    #[test]
    fn what_lies_outside_its_clip_or_the_screen_is_no_area() {
        let mut hidden = square(50.0, 60.0, 9);
        hidden.clip_rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(20.0, 20.0));
        let off_screen = square(900.0, 60.0, 9);
        assert!(areas(&[], &[hidden, off_screen]).is_empty());
    }

    #[test]
    fn areas_end_at_whole_pixels_of_a_dense_screen() {
        let mut areas = Areas::new(SCREEN, 1.5);
        areas.add(Rect::from_min_max(pos2(10.3, 10.3), pos2(20.4, 20.4)));
        let rect = areas.rects()[0];
        for edge in [rect.min.x, rect.min.y, rect.max.x, rect.max.y] {
            let pixels = edge * 1.5;
            assert!((pixels - pixels.round()).abs() < 1e-4, "{rect:?}");
        }
        assert!(rect.contains_rect(Rect::from_min_max(pos2(10.3, 10.3), pos2(20.4, 20.4))));
    }

    /// What a list of opaque squares draws at a place.
    fn drawn(shapes: &[ClippedShape], at: Pos2) -> Option<Color32> {
        shapes
            .iter()
            .rev()
            .find_map(|clipped| match &clipped.shape {
                Shape::Rect(rect) if rect.rect.contains(at) => Some(rect.fill),
                _ => None,
            })
    }

    proptest! {
        #[test]
        fn outside_the_areas_both_pictures_are_the_same(
            before in prop::collection::vec((0_u8..30, 0_u8..20, 0_u8..4), 0..60),
            now in prop::collection::vec((0_u8..30, 0_u8..20, 0_u8..4), 0..60),
            kept in 0_usize..60,
        ) {
            let list = |squares: &[(u8, u8, u8)]| -> Vec<ClippedShape> {
                let made = squares.iter();
                made.map(|&(x, y, c)| square(f32::from(x) * 10.0, f32::from(y) * 10.0, c)).collect()
            };
            let before = list(&before);
            let mut now = list(&now);
            // Most of a real picture stays.
            now.splice(0..0, before.iter().take(kept).cloned());
            let areas = areas(&before, &now);
            prop_assert!(areas.len() <= MAX_AREAS);
            for x in 0..80 {
                for y in 0..60 {
                    let at = pos2(x as f32 * 5.0 + 2.5, y as f32 * 5.0 + 2.5);
                    if !areas.iter().any(|area| area.contains(at)) {
                        prop_assert_eq!(drawn(&before, at), drawn(&now, at));
                    }
                }
            }
        }
    }
}
