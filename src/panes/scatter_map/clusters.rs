//! Clusters as tinted ground below the points, each with a letter: colour is never alone.

use egui::{Align2, Pos2, Shape, Stroke, Ui, pos2, vec2};

use crate::ui::style::medium_note_font;
use crate::ui::theme::{colours, line};

use super::ground::Ground;
use super::point::ScatterPoint;

/// How far the ground of a cluster reaches beyond its points, in points of the screen.
const REACH: f32 = 13.0;

/// "A", "B", …; past "Z" numbers go on.
pub fn cluster_name(cluster: usize) -> String {
    u8::try_from(cluster)
        .ok()
        .filter(|cluster| *cluster < 26)
        .map_or_else(
            || format!("{}", cluster + 1),
            |cluster| char::from(b'A' + cluster).to_string(),
        )
}

/// The clusters that occur with how many points each has.
pub fn cluster_counts(points: &[ScatterPoint]) -> Vec<(usize, usize)> {
    let mut counts: Vec<(usize, usize)> = Vec::new();
    for cluster in points.iter().filter_map(|point| point.cluster) {
        match counts.iter_mut().find(|(known, _)| *known == cluster) {
            Some((_, count)) => *count += 1,
            None => counts.push((cluster, 1)),
        }
    }
    counts.sort_unstable();
    counts
}

/// Draws the ground of each cluster, with its letter above the highest edge.
pub fn draw_clusters(ui: &Ui, points: &[ScatterPoint], ground: &Ground) {
    let painter = ui.painter_at(ground.rect);
    for (cluster, _) in cluster_counts(points) {
        let members = points.iter().filter(|point| point.cluster == Some(cluster));
        let around = members.flat_map(|point| ring(ground.on_screen(point.at)));
        let outline = convex_hull(around.collect());
        let colour = colours(ui).cluster(cluster);
        let corners = outline.iter().copied();
        let top = corners.min_by(|a, b| a.y.total_cmp(&b.y));
        let top = top.unwrap_or_default();
        painter.add(Shape::convex_polygon(
            outline,
            colour.gamma_multiply(0.10),
            Stroke::new(line::THIN, colour.gamma_multiply(0.55)),
        ));
        let at = pos2(top.x, (top.y - 2.0).max(ground.rect.top() + 16.0));
        let name = cluster_name(cluster);
        painter.text(at, Align2::CENTER_BOTTOM, name, medium_note_font(), colour);
    }
}

fn ring(centre: Pos2) -> impl Iterator<Item = Pos2> {
    (0..24).map(move |step| {
        let angle = std::f32::consts::TAU * step as f32 / 24.0;
        centre + REACH * vec2(angle.cos(), angle.sin())
    })
}

/// The corners of the smallest convex shape around all places, one after the other.
///
/// Source: Andrew (1979), Information Processing Letters 9(5): the monotone chain.
fn convex_hull(mut places: Vec<Pos2>) -> Vec<Pos2> {
    places.retain(|place| place.is_finite());
    places.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    places.dedup();
    if places.len() < 3 {
        return places;
    }
    let turns_left = |a: Pos2, b: Pos2, c: Pos2| (b - a).rot90().dot(c - b) < 0.0;
    let mut hull: Vec<Pos2> = Vec::new();
    for half in 0..2 {
        let start = hull.len();
        let mut add = |place: Pos2| {
            while hull.len() >= start + 2
                && !turns_left(hull[hull.len() - 2], hull[hull.len() - 1], place)
            {
                hull.pop();
            }
            hull.push(place);
        };
        if half == 0 {
            places.iter().for_each(|place| add(*place));
        } else {
            places.iter().rev().for_each(|place| add(*place));
        }
        // Each half ends where the other begins.
        hull.pop();
    }
    hull
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_a_square_with_points_inside_is_the_square() {
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
        let inside = [(1.0, 1.0), (2.0, 3.0), (2.0, 0.0), (3.5, 3.0)];
        let places = corners.iter().chain(&inside).map(|(x, y)| pos2(*x, *y));
        let hull = convex_hull(places.collect());
        assert_eq!(hull.len(), 4);
        for (x, y) in corners {
            assert!(hull.contains(&pos2(x, y)));
        }
    }

    #[test]
    fn clusters_have_letters_and_counts() {
        let point = |cluster| ScatterPoint {
            cluster,
            ..ScatterPoint::default()
        };
        let points = [point(Some(1)), point(None), point(Some(0)), point(Some(1))];
        assert_eq!(cluster_counts(&points), [(0, 1), (1, 2)]);
        assert_eq!(cluster_name(1), "B");
        assert_eq!(cluster_name(30), "31");
    }
}
