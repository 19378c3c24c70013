//! The class of the nearest case, each case left out in turn.

use crate::analysis::pose_distances::DistanceMatrix;

/// Cases nearest to each of some cases: one, or all that are equally near.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct NearestCases(Vec<Vec<usize>>);

impl NearestCases {
    /// For each of `rows` the places in `rows` of those nearest to it, itself left out.
    pub(super) fn new(distances: &DistanceMatrix, rows: &[usize]) -> Self {
        let nearest = rows.iter().map(|&row| {
            let mut nearest = Vec::new();
            let mut least = f64::INFINITY;
            for (place, &other) in rows.iter().enumerate() {
                let distance = distances.get(row, other);
                // A case at distance 0 from itself would always be right.
                if other == row || distance > least {
                    continue;
                }
                if distance < least {
                    nearest.clear();
                    least = distance;
                }
                nearest.push(place);
            }
            nearest
        });
        Self(nearest.collect())
    }

    /// Cases whose class is that of the nearest others.
    ///
    /// Where several are equally near their classes are counted; a class that is not ahead of all others
    /// is no answer. So the order of cases does not matter.
    pub(super) fn correct(&self, classes: &[usize], votes: &mut Vec<usize>) -> usize {
        (self.0.iter().zip(classes))
            .filter(|(nearest, own)| match nearest.as_slice() {
                [] => false,
                [one] => classes[*one] == **own,
                several => {
                    votes.clear();
                    votes.resize(classes.iter().max().map_or(0, |most| most + 1), 0);
                    several.iter().for_each(|&place| votes[classes[place]] += 1);
                    let mut others = votes.iter().enumerate().filter(|(class, _)| class != *own);
                    // A tie is not an answer, so that equal distances cannot be right by the order of the study.
                    others.all(|(_, &vote)| vote < votes[**own])
                }
            })
            .count()
    }
}

/// Cases put into their class by the nearest other case with a label, and cases with a label.
///
/// Where several cases are equally near, their classes are counted and the one ahead of all others is
/// the answer; a draw is a wrong one.
pub fn leave_one_out_nearest(
    distances: &DistanceMatrix,
    labels: &[Option<usize>],
) -> (usize, usize) {
    let rows: Vec<usize> = (0..labels.len().min(distances.size()))
        .filter(|&row| labels[row].is_some())
        .collect();
    let classes: Vec<usize> = rows.iter().filter_map(|&row| labels[row]).collect();
    let nearest = NearestCases::new(distances, &rows);
    (nearest.correct(&classes, &mut Vec::new()), rows.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(places: &[f64]) -> DistanceMatrix {
        DistanceMatrix::of_points(places, places.len()).unwrap()
    }

    #[test]
    fn the_nearest_case_names_the_class() {
        let distances = line(&[0.0, 1.0, 2.5, 10.0, 11.0]);
        let labels = [Some(0), Some(0), Some(1), Some(1), Some(1)];
        assert_eq!(leave_one_out_nearest(&distances, &labels), (4, 5));
        // Without the second, the first and third see each other.
        let fewer = [Some(0), None, Some(1), Some(1), Some(1)];
        assert_eq!(leave_one_out_nearest(&distances, &fewer), (2, 4));
    }

    #[test]
    fn of_equally_near_cases_the_majority_counts_and_a_draw_is_wrong() {
        let draw = line(&[0.0, -1.0, 1.0]);
        let labels = [Some(0), Some(0), Some(1)];
        assert_eq!(leave_one_out_nearest(&draw, &labels), (1, 3));
        let same = DistanceMatrix::from_upper(4, vec![0.0; 6]).unwrap();
        let labels = [Some(0), Some(0), Some(0), Some(1)];
        assert_eq!(leave_one_out_nearest(&same, &labels), (3, 4));
    }

    #[test]
    fn one_case_alone_has_no_answer() {
        let one = line(&[3.0]);
        assert_eq!(leave_one_out_nearest(&one, &[Some(0)]), (0, 1));
        assert_eq!(leave_one_out_nearest(&DistanceMatrix::empty(), &[]), (0, 0));
    }
}
