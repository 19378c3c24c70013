//! Rays across a wall: from a point near the apex in all directions below it, and from the long axis above it.
//!
//! As in Germano et al. (1995): spherical about the apex, cylindrical above.

use std::f64::consts::{FRAC_PI_2, TAU};

use rayon::prelude::*;

use crate::image::Sampler;
use crate::mesh::Vector3;
use crate::progress::{Progress, Stopped};

use super::axis::Conic;

/// Rows of rays below the middle of the sphere.
const ROUND_ROWS: usize = 12;
/// Rays around the axis in each row; even, so that each has one opposite.
pub(super) const ANGLES: usize = 40;
/// Rows above the middle of the sphere at most.
const STRAIGHT_ROWS: usize = 40;
/// Distance of samples along a ray.
pub(super) const STEP_MM: f64 = 1.0;
/// Length of the rays beyond the greatest radius of the wall.
const BEYOND_MM: f64 = 35.0;

/// Where rays begin and lead to. A place of the grid is (row, angle), row by row from the apex.
#[derive(Clone, Debug)]
pub(super) struct Rays {
    pub conic: Conic,
    /// Height of the middle of the sphere.
    sphere: f64,
    /// Greatest radius of the wall.
    radius: f64,
    pub rows: usize,
    pub samples: usize,
}

/// One number for each ray.
pub(super) type Sheet = Vec<f64>;

/// Counts along all rays of one volume.
pub(super) struct Profiles {
    samples: usize,
    counts: Vec<f32>,
}

impl Rays {
    /// Across a wall whose conic is known, up to a height.
    pub fn across(conic: &Conic, tip: f64, radius: f64, top: f64) -> Self {
        let step = FRAC_PI_2 * radius / ROUND_ROWS as f64;
        let sphere = tip + radius;
        let straight = ((top - sphere) / step).ceil().max(1.0) as usize;
        Self {
            conic: *conic,
            sphere,
            radius,
            rows: ROUND_ROWS + straight.min(STRAIGHT_ROWS),
            samples: ((radius + BEYOND_MM) / STEP_MM).ceil() as usize,
        }
    }

    /// Distance of rows along the wall, in millimetres.
    pub fn row_mm(&self) -> f64 {
        FRAC_PI_2 * self.radius / ROUND_ROWS as f64
    }

    pub fn count(&self) -> usize {
        self.rows * ANGLES
    }

    /// The height that a ray of a row begins at, and its directions across and along the axis.
    fn ray(&self, row: usize, angle: usize) -> (f64, Vector3) {
        let (sin, cos) = (TAU * angle as f64 / ANGLES as f64).sin_cos();
        if row < ROUND_ROWS {
            let polar = FRAC_PI_2 * (row as f64 + 0.5) / ROUND_ROWS as f64;
            let across = polar.sin();
            let direction = Vector3::new(across * cos, across * sin, -polar.cos());
            return (self.sphere, direction);
        }
        (self.height(row), Vector3::new(cos, sin, 0.0))
    }

    /// Height of a straight row; of a round one that where its rays begin.
    pub fn height(&self, row: usize) -> f64 {
        let above = (row as f64 + 0.5 - ROUND_ROWS as f64).max(0.0);
        self.sphere + above * self.row_mm()
    }

    /// Whether the rays of a row lead straight across the axis.
    pub fn is_straight(&self, row: usize) -> bool {
        row >= ROUND_ROWS
    }

    /// A point of a ray, across and along the axis.
    pub fn point(&self, ray: usize, distance: f64) -> Vector3 {
        let (height, direction) = self.ray(ray / ANGLES, ray % ANGLES);
        Vector3::new(0.0, 0.0, height) + direction * distance
    }

    /// The distance of a point from where its ray begins, and the value of a sheet on that ray.
    pub fn of_point(&self, local: Vector3, sheet: &[f64]) -> (f64, f64) {
        let across = local.x.hypot(local.y);
        let below = self.sphere - local.z;
        let (distance, row) = if below > 0.0 {
            let polar = across.atan2(below);
            (across.hypot(below), polar / FRAC_PI_2 * ROUND_ROWS as f64)
        } else {
            (across, ROUND_ROWS as f64 - below / self.row_mm())
        };
        let turn = local.y.atan2(local.x).rem_euclid(TAU) / TAU * ANGLES as f64;
        (distance, self.between(sheet, row - 0.5, turn))
    }

    /// The value of a sheet between rays; beyond the last row that of the last row.
    fn between(&self, sheet: &[f64], row: f64, turn: f64) -> f64 {
        let (low_row, low_turn) = (row.floor(), turn.floor());
        let (part_row, part_turn) = (row - low_row, turn - low_turn);
        let at = |row: f64, turn: f64| {
            let turn = turn as usize;
            // Across the apex lies the ray opposite.
            let (row, turn) = match row < 0.0 {
                true => (0, turn + ANGLES / 2),
                false => ((row as usize).min(self.rows - 1), turn),
            };
            sheet
                .get(row * ANGLES + turn % ANGLES)
                .copied()
                .unwrap_or(0.0)
        };
        let along =
            |row: f64| at(row, low_turn) * (1.0 - part_turn) + at(row, low_turn + 1.0) * part_turn;
        along(low_row) * (1.0 - part_row) + along(low_row + 1.0) * part_row
    }

    /// The four rays beside one; at the base fewer.
    pub fn neighbours(&self, ray: usize) -> impl Iterator<Item = usize> {
        let (row, angle) = (ray / ANGLES, ray % ANGLES);
        let below = match row {
            0 => (angle + ANGLES / 2) % ANGLES,
            _ => ray - ANGLES,
        };
        let above = (row + 1 < self.rows).then_some(ray + ANGLES);
        let around = [(angle + 1) % ANGLES, (angle + ANGLES - 1) % ANGLES];
        let around = around.map(|angle| row * ANGLES + angle);
        [below].into_iter().chain(above).chain(around)
    }

    /// Where the conic lies on each ray.
    pub fn conic_sheet(&self) -> Sheet {
        let on_ray = |ray: usize| {
            let row = ray / ANGLES;
            if self.is_straight(row) {
                // Towards the valve a conic closes, and the wall does not.
                return self.conic.radius(self.height(row)).max(0.75 * self.radius);
            }
            let beyond = |sample: &usize| {
                let local = self.point(ray, *sample as f64 * STEP_MM);
                local.x.hypot(local.y) >= self.conic.radius(local.z)
            };
            let first = (1..self.samples).find(beyond).unwrap_or(self.samples);
            first as f64 * STEP_MM
        };
        (0..self.count()).map(on_ray).collect()
    }

    /// Counts of a volume along all rays.
    ///
    /// # Errors
    /// If it was asked to stop.
    pub fn profiles(
        &self,
        sampler: &Sampler<'_>,
        progress: &Progress,
    ) -> Result<Profiles, Stopped> {
        let rows = (0..self.rows).into_par_iter().map(|row| {
            progress.check()?;
            let mut counts = Vec::with_capacity(ANGLES * self.samples);
            for ray in row * ANGLES..(row + 1) * ANGLES {
                for sample in 0..self.samples {
                    let local = self.point(ray, sample as f64 * STEP_MM);
                    let found = sampler.at(self.conic.axis.position(local));
                    counts.push(found.unwrap_or(f64::NAN) as f32);
                }
            }
            Ok(counts)
        });
        let rows = rows.collect::<Result<Vec<Vec<f32>>, Stopped>>()?;
        Ok(Profiles {
            samples: self.samples,
            counts: rows.concat(),
        })
    }
}

impl Profiles {
    /// Counts along a ray, from its beginning.
    pub fn of(&self, ray: usize) -> &[f32] {
        let from = ray * self.samples;
        self.counts.get(from..from + self.samples).unwrap_or(&[])
    }

    /// Counts at a distance along a ray; NaN beyond the image.
    pub fn at(&self, ray: usize, distance: f64) -> f64 {
        let place = (distance / STEP_MM).max(0.0);
        let (low, part) = (place.floor() as usize, place - place.floor());
        let counts = self.of(ray);
        let at = |n: usize| counts.get(n).map_or(f64::NAN, |&c| f64::from(c));
        match part > 0.0 {
            true => at(low) * (1.0 - part) + at(low + 1) * part,
            false => at(low),
        }
    }
}

/// The greatest counts, if there are any above 0 and others below them.
pub(super) fn greatest(values: &[f32]) -> Option<f64> {
    let finite = values.iter().copied().filter(|value| value.is_finite());
    let most = finite.clone().fold(f32::MIN, f32::max);
    let least = finite.fold(f32::MAX, f32::min);
    (most > 0.0 && most > least).then_some(f64::from(most))
}
