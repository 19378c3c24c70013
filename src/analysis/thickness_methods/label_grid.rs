//! Voxels that are wall, cavity or outside, and how each voxel of the wall touches what is around it.

use super::ThicknessError;

/// What a voxel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VoxelLabel {
    /// Beyond the outer side.
    Outside,
    /// Myocardium.
    Wall,
    /// Within the inner side.
    Cavity,
}

/// Labels on a grid, x fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelGrid {
    /// Voxels in x, y and z.
    pub dims: [usize; 3],
    /// Distance of neighbours in coordinates.
    pub spacing: [f64; 3],
    /// One per voxel.
    pub labels: Vec<VoxelLabel>,
}

/// What lies next to a voxel of the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Link {
    /// Another voxel of the wall, by its number among these.
    Wall(u32),
    /// The inner side.
    Inner(Border),
    /// The outer side.
    Outer(Border),
    /// Neither side: the end of the wall, through which no field line runs.
    End,
}

/// How far away a side is along a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Border {
    /// Share of the spacing at which the side is crossed, in (0, 1], as the potential has it.
    pub share: f64,
    /// Way from the side to the end of the link, in coordinates: negative if that lies beyond.
    pub beyond: f64,
}

/// The wall of a grid as a graph.
#[derive(Clone, Debug)]
pub(super) struct WallGraph {
    /// Voxel of each node.
    pub voxels: Vec<u32>,
    /// Node of each voxel.
    pub nodes: Vec<Option<u32>>,
    /// Per node: −x, +x, −y, +y, −z, +z.
    pub links: Vec<[Link; 6]>,
    /// Of the grid.
    pub spacing: [f64; 3],
}

impl LabelGrid {
    /// Checks that there are as many labels as voxels and that the spacing is positive.
    ///
    /// # Errors
    /// If not.
    pub fn new(
        dims: [usize; 3],
        spacing: [f64; 3],
        labels: Vec<VoxelLabel>,
    ) -> Result<Self, ThicknessError> {
        let expected: usize = dims.iter().product();
        if labels.len() != expected || expected > u32::MAX as usize {
            return Err(ThicknessError::LabelCount {
                labels: labels.len(),
                expected,
            });
        }
        for value in spacing {
            if !(value.is_finite() && value > 0.0) {
                return Err(ThicknessError::Setting {
                    name: "spacing of voxels",
                    value,
                    least: f64::MIN_POSITIVE,
                    most: f64::MAX,
                });
            }
        }
        Ok(Self {
            dims,
            spacing,
            labels,
        })
    }

    /// Number of voxels in the wall.
    pub fn wall_voxels(&self) -> usize {
        (self.labels.iter())
            .filter(|&&label| label == VoxelLabel::Wall)
            .count()
    }

    /// The voxel next to one in direction −x, +x, −y, +y, −z or +z; `None` past the grid.
    pub(super) fn neighbour(&self, voxel: usize, direction: usize) -> Option<usize> {
        let [nx, ny, nz] = self.dims;
        let (axis, stride) = (direction / 2, [1, nx, nx * ny][direction / 2]);
        let place = voxel / stride % [nx, ny, nz][axis];
        match direction % 2 {
            0 if place > 0 => Some(voxel - stride),
            1 if place + 1 < self.dims[axis] => Some(voxel + stride),
            _ => None,
        }
    }

    /// The graph of the wall; `link` says how a voxel of the wall touches one that is none, given
    /// its direction; there is none past the grid.
    pub(super) fn graph(&self, link: impl Fn(usize, Option<usize>, usize) -> Link) -> WallGraph {
        let mut nodes = vec![None; self.labels.len()];
        let mut voxels = Vec::new();
        for (voxel, &label) in self.labels.iter().enumerate() {
            if label == VoxelLabel::Wall {
                nodes[voxel] = Some(voxels.len() as u32);
                voxels.push(voxel as u32);
            }
        }
        let links = (voxels.iter())
            .map(|&voxel| {
                std::array::from_fn(|direction| {
                    let next = self.neighbour(voxel as usize, direction);
                    match next.and_then(|next| nodes[next]) {
                        Some(node) => Link::Wall(node),
                        None => link(voxel as usize, next, direction),
                    }
                })
            })
            .collect();
        WallGraph {
            voxels,
            nodes,
            links,
            spacing: self.spacing,
        }
    }

    /// The graph of a mask, of which only the labels are known: the potential is 0 or 1 in the middle of
    /// the first voxel beyond the wall, and the side itself lies half a voxel before that. Where the image
    /// ends, the wall does.
    pub(super) fn mask_graph(&self) -> WallGraph {
        self.graph(|_, next, direction| {
            let border = Border {
                share: 1.0,
                // A mask says no more than voxels: its side lies half a voxel before the centre outside.
                beyond: -0.5 * self.spacing[direction / 2],
            };
            match next.map(|next| self.labels[next]) {
                Some(VoxelLabel::Cavity) => Link::Inner(border),
                // What is neither wall nor cavity is outside.
                Some(_) => Link::Outer(border),
                None => Link::End,
            }
        })
    }
}
