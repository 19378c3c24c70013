//! The nearest of many points, by boxes in space.

use std::collections::HashMap;

use crate::mesh::Point3;

/// Points sorted into boxes about as large as the distance between them.
pub(super) struct Nearest<'a> {
    points: &'a [Point3],
    boxes: HashMap<[i32; 3], Vec<u32>>,
    side: f64,
    /// Boxes across the whole, beyond which there is nothing to find.
    most: i32,
}

impl<'a> Nearest<'a> {
    /// Sorts points; those that are not finite are never found.
    pub(super) fn new(points: &'a [Point3]) -> Self {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        let finite = |point: &Point3| point.coords.iter().all(|x| x.is_finite());
        for point in points.iter().filter(|point| finite(point)) {
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let extent = (0..3)
            .map(|axis| high[axis] - low[axis])
            .fold(0.0, f64::max);
        // Points on a surface: as many boxes across as the root of their number.
        let across = (points.len() as f64).sqrt().max(1.0);
        let side = if extent > 0.0 { extent / across } else { 1.0 };
        let mut sorted = Self {
            points,
            boxes: HashMap::new(),
            side,
            most: 2 * across.ceil() as i32 + 2,
        };
        for (index, point) in points.iter().enumerate().filter(|(_, point)| finite(point)) {
            let place = sorted.place(*point);
            sorted.boxes.entry(place).or_default().push(index as u32);
        }
        sorted
    }

    fn place(&self, point: Point3) -> [i32; 3] {
        [0, 1, 2].map(|axis| (point[axis] / self.side).floor() as i32)
    }

    /// Index of the point nearest to a place near them; the lower one of two that are as near.
    pub(super) fn to(&self, place: Point3) -> Option<u32> {
        let centre = self.place(place);
        let mut best: Option<(f64, u32)> = None;
        for ring in 0..=self.most {
            // What lies in this ring is at least so far away.
            let least = f64::from(ring - 1).max(0.0) * self.side;
            if best.is_some_and(|(distance, _)| distance < least) {
                break;
            }
            self.ring(centre, ring, &mut |index| {
                let distance = (self.points[index as usize] - place).norm();
                if best.is_none_or(|found| (distance, index) < found) {
                    best = Some((distance, index));
                }
            });
        }
        best.map(|(_, index)| index)
    }

    /// Points in boxes exactly `ring` boxes away.
    fn ring(&self, centre: [i32; 3], ring: i32, found: &mut impl FnMut(u32)) {
        for x in -ring..=ring {
            for y in -ring..=ring {
                let inside = x.abs() < ring && y.abs() < ring;
                let step = if inside { (2 * ring).max(1) } else { 1 };
                for z in (-ring..=ring).step_by(step as usize) {
                    let place = [centre[0] + x, centre[1] + y, centre[2] + z];
                    if let Some(points) = self.boxes.get(&place) {
                        points.iter().copied().for_each(&mut *found);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    #[test]
    fn the_nearest_is_the_one_that_looking_at_all_finds() {
        let sphere = phantom::sphere(3, 20.0);
        let nearest = Nearest::new(sphere.vertices());
        let outer = phantom::sphere(2, 31.0);
        for &place in outer.vertices() {
            let all = (sphere.vertices().iter().enumerate())
                .map(|(index, point)| ((point - place).norm(), index as u32))
                .min_by(|a, b| a.partial_cmp(b).unwrap());
            let found = nearest.to(place).unwrap();
            let distance = (sphere.vertices()[found as usize] - place).norm();
            assert!((distance - all.unwrap().0).abs() < 1e-12);
        }
        assert_eq!(Nearest::new(&[]).to(Point3::origin()), None);
    }
}
