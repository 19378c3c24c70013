//! Names beside the points of a map, where there is room.

/// A rectangle, upper left and lower right corner.
type Box2 = [[f32; 2]; 2];

/// A name to be placed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Name {
    /// The point that it names.
    pub(super) at: [f32; 2],
    /// Its width and height.
    pub(super) size: [f32; 2],
}

/// For each name the start of its base line, right of its point or on another side; `None` where every side is taken by an
/// earlier name, lies on one of the `marks` or outside `frame`.
///
/// A map on which some points stay without a name is read wrongly less often than one on which names cover each other.
pub(super) fn placed(
    names: &[Name],
    marks: &[[f32; 2]],
    gap: f32,
    frame: Box2,
) -> Vec<Option<[f32; 2]>> {
    let mut taken: Vec<Box2> = marks
        .iter()
        .map(|[x, y]| {
            [
                [x - 0.5 * gap, y - 0.5 * gap],
                [x + 0.5 * gap, y + 0.5 * gap],
            ]
        })
        .collect();
    names
        .iter()
        .map(|name| {
            let [x, y] = name.at;
            let [width, height] = name.size;
            let corners = [
                [x + gap, y - 0.5 * height],
                [x - gap - width, y - 0.5 * height],
                [x - 0.5 * width, y - gap - height],
                [x - 0.5 * width, y + gap],
            ];
            let mut boxes = corners
                .map(|[left, top]| [[left, top], [left + width, top + height]])
                .into_iter();
            let free = boxes.find(|room| {
                inside(room, &frame) && !taken.iter().any(|other| overlap(room, other))
            })?;
            taken.push(free);
            Some([free[0][0], free[1][1] - 0.25 * height])
        })
        .collect()
}

fn inside(room: &Box2, frame: &Box2) -> bool {
    (0..2).all(|axis| room[0][axis] >= frame[0][axis] && room[1][axis] <= frame[1][axis])
}

fn overlap(a: &Box2, b: &Box2) -> bool {
    (0..2).all(|axis| a[0][axis] < b[1][axis] && b[0][axis] < a[1][axis])
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Box2 = [[0.0, 0.0], [100.0, 100.0]];

    fn name(x: f32, y: f32) -> Name {
        Name {
            at: [x, y],
            size: [20.0, 8.0],
        }
    }

    #[test]
    fn names_stand_beside_their_points_and_not_on_each_other() {
        let names = [name(50.0, 50.0), name(52.0, 50.0), name(95.0, 5.0)];
        let marks = names.map(|name| name.at);
        let places = placed(&names, &marks, 5.0, FRAME);
        assert_eq!(places[0], Some([55.0, 52.0]));
        let second = places[1].unwrap();
        assert!(
            second[0] < 50.0 || second[1] < 50.0 || second[1] > 57.0,
            "{second:?}"
        );
        assert!(
            places[2].unwrap()[0] < 75.0,
            "left of the point at the edge"
        );
    }

    #[test]
    fn a_name_without_room_is_left_out() {
        let names = [name(50.0, 50.0); 6];
        let places = placed(&names, &[], 5.0, FRAME);
        assert_eq!(places.iter().flatten().count(), 4);
    }
}
