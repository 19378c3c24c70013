//! Voxels of a grid that belong together: those of a label, of a chamber, above a threshold.

use crate::mesh::Point3;

use super::VolumeFrame;

/// How far a value may lie from a whole number and still be that label, relative to the label beyond 1: rounding of a
/// slope and intercept in single precision, and far less than a half, where interpolated labels lie.
const LABEL_TOLERANCE: f64 = 1e-3;

/// Which voxels of a grid belong to something, i fastest, then j, then k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mask {
    size: [usize; 3],
    inside: Vec<bool>,
}

/// Values and a grid do not belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{values} values for {voxels} voxels")]
pub struct MaskError {
    /// How many values there are.
    pub values: usize,
    /// How many there should be.
    pub voxels: usize,
}

impl Mask {
    /// Joins a grid of `size` voxels and one answer per voxel.
    ///
    /// # Errors
    /// If counts differ.
    pub fn new(size: [usize; 3], inside: Vec<bool>) -> Result<Self, MaskError> {
        check(size, inside.len())?;
        Ok(Self { size, inside })
    }

    /// The voxels whose value is one of the labels. Values that are no whole number, such as those between two labels
    /// after an interpolation, and NaN belong to no label.
    ///
    /// # Errors
    /// If counts differ.
    pub fn of_labels(size: [usize; 3], values: &[f32], labels: &[i32]) -> Result<Self, MaskError> {
        check(size, values.len())?;
        let is_one = |&value: &f32| {
            let value = f64::from(value);
            labels.iter().any(|&label| {
                let label = f64::from(label);
                (value - label).abs() <= LABEL_TOLERANCE * label.abs().max(1.0)
            })
        };
        Ok(Self {
            size,
            inside: values.iter().map(is_one).collect(),
        })
    }

    /// The voxels whose value lies above the threshold, as for an isosurface; NaN does not.
    ///
    /// # Errors
    /// If counts differ.
    pub fn above(size: [usize; 3], values: &[f32], threshold: f64) -> Result<Self, MaskError> {
        check(size, values.len())?;
        Ok(Self {
            size,
            inside: values.iter().map(|&v| f64::from(v) > threshold).collect(),
        })
    }

    /// Voxels along i, j and k.
    pub fn size(&self) -> [usize; 3] {
        self.size
    }

    /// Whether each voxel belongs to it, i fastest.
    pub fn inside(&self) -> &[bool] {
        &self.inside
    }

    /// How many voxels belong to it.
    pub fn count(&self) -> usize {
        self.inside.iter().filter(|&&inside| inside).count()
    }

    /// The volume of its voxels in millilitres, on a grid in millimetres.
    pub fn volume_ml(&self, frame: &VolumeFrame) -> f64 {
        self.count() as f64 * frame.voxel_mm3() / 1000.0
    }

    /// The centres of its voxels, in millimetres.
    pub fn positions(&self, frame: &VolumeFrame) -> Vec<Point3> {
        let numbered = self.inside.iter().enumerate();
        numbered
            .filter(|&(_, &inside)| inside)
            .map(|(voxel, _)| frame.position(self.place(voxel).map(|n| n as f64).into()))
            .collect()
    }

    /// 1 where it is and 0 elsewhere: a volume whose isosurface at ½ lies half way between voxels.
    pub fn values(&self) -> Vec<f32> {
        self.inside
            .iter()
            .map(|&inside| f32::from(inside))
            .collect()
    }

    /// How many voxels each connected component has, in the order of their first voxels. Voxels that share a face are
    /// connected.
    pub fn component_sizes(&self) -> Vec<usize> {
        self.components().1
    }

    /// Its connected component with the most voxels; of equal ones that of the first voxel. Voxels that share a face are
    /// connected. Empty if it is.
    #[must_use]
    pub fn largest_component(&self) -> Self {
        let (numbers, sizes) = self.components();
        // The last of equals would be the greatest: so numbers count down.
        let largest =
            (sizes.iter().enumerate()).max_by_key(|&(number, size)| (size, usize::MAX - number));
        self.component(&numbers, largest.map(|(number, _)| number))
    }

    /// The connected component that holds a voxel; empty if the voxel is outside the mask or beyond the grid.
    #[must_use]
    pub fn component_at(&self, [i, j, k]: [usize; 3]) -> Self {
        let [nx, ny, nz] = self.size;
        let (numbers, _) = self.components();
        let number = (i < nx && j < ny && k < nz)
            .then(|| numbers[i + nx * (j + ny * k)])
            .filter(|&number| number != NONE);
        self.component(&numbers, number.map(|number| number as usize))
    }

    /// With every hole filled: voxels outside that no way over shared faces leads from to the border of the grid.
    #[must_use]
    pub fn holes_filled(&self) -> Self {
        self.filled(&[0, 1, 2])
    }

    /// With the holes of every slice across an axis (0, 1, 2: i, j, k) filled, each slice for itself; as it is for
    /// another axis.
    #[must_use]
    pub fn holes_filled_in_slices(&self, axis: usize) -> Self {
        let within: Vec<usize> = (0..3).filter(|&other| other != axis).collect();
        if within.len() == 2 {
            self.filled(&within)
        } else {
            self.clone()
        }
    }

    /// The lowest and the highest place of its voxels along i, j and k; `None` if it is empty.
    pub fn bounds(&self) -> Option<[[usize; 3]; 2]> {
        let [nx, ny, _] = self.size;
        let mut found: Option<[[usize; 3]; 2]> = None;
        for (number, row) in self.inside.chunks(nx.max(1)).enumerate() {
            let Some(first) = row.iter().position(|&inside| inside) else {
                continue;
            };
            let last = row.iter().rposition(|&inside| inside).unwrap_or(first);
            let (j, k) = (number % ny, number / ny);
            let [low, high] = found.get_or_insert([[first, j, k], [last, j, k]]);
            *low = [low[0].min(first), low[1].min(j), low[2]];
            *high = [high[0].max(last), high[1].max(j), k];
        }
        found
    }

    /// Floods what is outside from the ends along `axes`, over steps along these; what stays dry is inside.
    fn filled(&self, axes: &[usize]) -> Self {
        let mut filled = self.clone();
        // Beyond the bounds everything is outside: only what lies within may be a hole.
        let Some(bounds) = self.bounds() else {
            return filled;
        };
        let mut open: Vec<usize> = Vec::new();
        let voxels = within(self.size, bounds);
        for &voxel in &voxels {
            let place = self.place(voxel);
            let at_end = (axes.iter())
                .any(|&axis| place[axis] == bounds[0][axis] || place[axis] == bounds[1][axis]);
            filled.inside[voxel] = self.inside[voxel] || !at_end;
            if at_end && !self.inside[voxel] {
                open.push(voxel);
            }
        }
        while let Some(voxel) = open.pop() {
            for next in self.neighbours(voxel, axes, bounds) {
                if filled.inside[next] && !self.inside[next] {
                    filled.inside[next] = false;
                    open.push(next);
                }
            }
        }
        filled
    }

    /// The number of each voxel's component and the size of each component.
    fn components(&self) -> (Vec<u32>, Vec<usize>) {
        let mut numbers = vec![NONE; self.inside.len()];
        let mut sizes = Vec::new();
        let mut open = Vec::new();
        let whole = [[0; 3], self.size.map(|n| n.saturating_sub(1))];
        for start in 0..self.inside.len() {
            if !self.inside[start] || numbers[start] != NONE {
                continue;
            }
            let number = sizes.len() as u32;
            let mut size = 0;
            numbers[start] = number;
            open.push(start);
            while let Some(voxel) = open.pop() {
                size += 1;
                for next in self.neighbours(voxel, &[0, 1, 2], whole) {
                    if self.inside[next] && numbers[next] == NONE {
                        numbers[next] = number;
                        open.push(next);
                    }
                }
            }
            sizes.push(size);
        }
        (numbers, sizes)
    }

    fn component(&self, numbers: &[u32], number: Option<usize>) -> Self {
        let is_it = |&found: &u32| found != NONE && Some(found as usize) == number;
        Self {
            size: self.size,
            inside: numbers.iter().map(is_it).collect(),
        }
    }

    fn place(&self, voxel: usize) -> [usize; 3] {
        let [nx, ny, _] = self.size;
        [voxel % nx, voxel / nx % ny, voxel / nx / ny]
    }

    /// Voxels within bounds that share a face with one, along some axes.
    fn neighbours(
        &self,
        voxel: usize,
        axes: &[usize],
        [low, high]: [[usize; 3]; 2],
    ) -> impl Iterator<Item = usize> {
        let (place, strides) = (
            self.place(voxel),
            [1, self.size[0], self.size[0] * self.size[1]],
        );
        axes.iter().flat_map(move |&axis| {
            let below = (place[axis] > low[axis]).then(|| voxel - strides[axis]);
            let above = (place[axis] < high[axis]).then(|| voxel + strides[axis]);
            below.into_iter().chain(above)
        })
    }
}

/// The numbers of the voxels of a grid that lie within bounds, ascending.
fn within([nx, ny, _]: [usize; 3], [low, high]: [[usize; 3]; 2]) -> Vec<usize> {
    let rows = (low[2]..=high[2]).flat_map(|k| (low[1]..=high[1]).map(move |j| nx * (j + ny * k)));
    rows.flat_map(|row| row + low[0]..=row + high[0]).collect()
}

/// In no component.
const NONE: u32 = u32::MAX;

/// Whether a grid of `size` voxels has so many values.
fn check(size: [usize; 3], values: usize) -> Result<(), MaskError> {
    let voxels = size
        .iter()
        .try_fold(1_usize, |count, &n| count.checked_mul(n));
    match voxels {
        Some(voxels) if voxels == values => Ok(()),
        _ => Err(MaskError {
            values,
            voxels: voxels.unwrap_or(usize::MAX),
        }),
    }
}

#[cfg(test)]
mod tests;
