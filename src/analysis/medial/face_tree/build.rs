//! Puts cylinders and cones around the faces of a pose, from the leaves up.

use rayon::prelude::*;

use super::bounds::{Bounds, Summary};
use super::faces::FacesOfPose;
use super::node::Node;
use super::plan::{TreePlan, WORTH_HANDING};
use super::scaled_coordinates::ScaledCoordinates;
use super::search::FaceTree;
use crate::mesh::Point3;

impl TreePlan {
    /// Puts cylinders and cones around the faces of a pose.
    pub fn around<'a>(&'a self, faces: FacesOfPose<'a>) -> FaceTree<'a> {
        // In units of the surface, so that 32 bits are enough.
        let coordinates = ScaledCoordinates::new(faces.points);
        let points: Vec<Point3> = faces
            .points
            .iter()
            .map(|&point| coordinates.of(point))
            .collect();
        let scaled = FacesOfPose {
            points: &points,
            ..faces
        };
        // From the leaves up, since what lies around a node is joined from what lies around its parts.
        let mut levels: Vec<Vec<Node>> = Vec::with_capacity(self.levels);
        let mut summaries: Vec<Summary> = Vec::new();
        for level in (1..=self.levels).rev() {
            let nodes = 1 << (2 * level);
            // So many nodes at least to a thread that they hold as many faces as are worth it.
            let least = WORTH_HANDING * nodes / (self.order.len() + 1);
            let made: Vec<(Summary, Bounds)> = (0..nodes)
                .into_par_iter()
                .with_min_len(least.max(1))
                .map(|place| {
                    let members = self.members(level, place);
                    let summary = match summaries.as_chunks::<4>().0.get(place) {
                        Some(parts) => Summary::joined(parts),
                        None => Summary::new(scaled, members),
                    };
                    (summary, Bounds::new(scaled, members, &summary))
                })
                .collect();
            let (fours, _) = made.as_chunks::<4>();
            let node = |four: &[(Summary, Bounds); 4]| Node::new(&four.map(|(_, bounds)| bounds));
            levels.push(fours.iter().map(node).collect());
            summaries = made.into_iter().map(|(summary, _)| summary).collect();
        }
        FaceTree {
            plan: self,
            faces,
            coordinates,
            nodes: levels.into_iter().rev().flatten().collect(),
        }
    }
}
