//! How strongly surfaces are smoothed, and which spheres count.

use serde::{Deserialize, Serialize};

/// Settings of the medial surface; [`MedialParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MedialParams {
    /// Least length ℓ over which the surfaces are smoothed before spheres are fitted into the wall, as a share of the wall's median
    /// thickness; noise that the surfaces tell of themselves makes it longer, up to 1.5. Waves of length 2πℓ keep three quarters of their height.
    /// 0: surfaces as they are, however rough.
    pub smoothing: f64,
    /// Least angle at the centre of a sphere between the two points at which it touches. What touches it
    /// nearer to its own vertex is roughness of the same side and does not shrink it.
    pub separation_rad: f64,
    /// Angle between the spokes below which the sheet counts as ended.
    pub end_rad: f64,
}

impl Default for MedialParams {
    /// Smoothing by what noise does to the atoms between spheres of radius 20 and 28, root mean square over all vertices:
    /// error of the radius and angle of the normal to the true one, and how many of the atoms were lost to false ends.
    /// Noise is uniform on each coordinate of every vertex, its standard deviation given in percent of the thickness; on the
    /// 2,562 vertices an edge is a third of the thickness.
    ///
    /// | vertices, noise | none | 0.125 | 0.25 | **0.3** | 0.375 | 0.5 |
    /// |---|---|---|---|---|---|---|
    /// | 2,562, 0 % | 0.05 %, 0.3° | 0.05 %, 0.3° | 0.01 %, 0.3° | 0.07 %, 0.3° | 0.23 %, 0.3° | 0.78 %, 0.3° |
    /// | 642, 2.5 % | 3.3 %, 2.1° | 3.1 %, 1.7° | 2.4 %, 1.3° | 2.1 %, 1.2° | 1.8 %, 1.1° | 1.4 %, 0.9° |
    /// | 2,562, 1 % | 1.3 %, 1.6° | 0.9 %, 0.9° | 0.6 %, 0.6° | 0.5 %, 0.5° | 0.4 %, 0.4° | 0.8 %, 0.4° |
    /// | 2,562, 2.5 % | 3.1 %, 3.6° | 2.3 %, 2.2° | 1.4 %, 1.2° | 1.2 %, 1.0° | 1.0 %, 0.9° | 0.9 %, 0.7° |
    /// | 2,562, 5 % | 6.2 %, 7.4°, 1,363 lost | 4.7 %, 4.4°, 143 | 2.9 %, 2.5° | 2.5 %, 2.1° | 2.0 %, 1.6° | 1.6 %, 1.3° |
    /// | 10,242, 5 % | 49 %, 46°, 10,093 lost | 3.8 %, 5.3°, 3,429 | 1.8 %, 2.2°, 6 | 1.4 %, 1.8° | 1.1 %, 1.4° | 0.9 %, 1.1° |
    ///
    /// That is with this length for all noise. Where the surfaces themselves tell of noise, ℓ is as long as the expected square of the error
    /// falls with it, which leaves clean surfaces as they are. Means over three draws of Gaussian noise, with 0.3 for all noise and with 0.3 as
    /// the least; bias is the mean error of the radius:
    ///
    /// | vertices, noise | 0.3 | at least 0.3 |
    /// |---|---|---|
    /// | 2,562, 0 % | 0.07 %, 0.3° | 0.07 %, 0.3° |
    /// | 642, 5 % | 4.3 %, bias −1.5 %, 2.2° | 3.4 %, bias −1.0 %, 1.8° |
    /// | 642, 10 % | 9.0 %, bias −3.6 %, 4.9°, 102 lost | 5.0 %, bias −0.8 %, 2.6°, 0 |
    /// | 2,562, 5 % | 2.5 %, bias −0.7 %, 2.0°, 3 lost | 1.8 %, bias −0.2 %, 1.5°, 0 |
    /// | 2,562, 10 % | 6.6 %, bias −2.8 %, 6.0°, 1,982 | 3.4 %, bias −0.8 %, 2.5°, 0 |
    /// | 2,562, 20 % | 68 %, bias −55 %, 49°, 7,598 | 5.7 %, bias −0.9 %, 3.8°, 0 |
    /// | 10,242, 5 % | 1.5 %, bias −0.4 %, 1.9°, 71 | 1.2 %, bias −0.3 %, 1.4°, 0 |
    ///
    /// Spheres come out too small under noise, since they stop at the first of what rises to them: what is left of noise after smoothing
    /// makes the bias.
    ///
    /// `cargo test --test it medial_noise -- --nocapture` prints what these lengths do as the least, for uniform noise;
    /// the first table was printed before noise made them longer. More smoothing would be better against noise,
    /// but an ellipsoidal ventricle has an apex of a radius near its thickness: the centres there move by 2.0 % of the
    /// thickness at 0.3, by 2.8 % at 0.375 and by 4.9 % at 0.5.
    ///
    /// Separation: facets of a sphere of 162 vertices stand at some 20° to each other and noise that is left adds as much; the faces of a
    /// rim stand at 90°. End: spokes at 120° say that the radius changes by half of the way along the sheet.
    fn default() -> Self {
        Self {
            smoothing: 0.3,
            separation_rad: 60_f64.to_radians(),
            end_rad: 120_f64.to_radians(),
        }
    }
}

/// Settings that have been checked; read them like the fields of [`MedialParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedMedialParams(MedialParams);

impl std::ops::Deref for CheckedMedialParams {
    type Target = MedialParams;

    fn deref(&self) -> &MedialParams {
        &self.0
    }
}

/// Smoothing over more would turn a ventricle into a sphere.
const MAX_SMOOTHING: f64 = 2.0;

/// Why settings cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MedialParamError {
    /// Out of range.
    #[error("smoothing must be between 0 and {most} thicknesses, not {value}")]
    Smoothing {
        /// What it was.
        value: f64,
        /// The limit.
        most: f64,
    },
    /// Angles out of order.
    #[error(
        "angles must fulfil 0° < separation ≤ end < 180°, not {separation_deg}° and {end_deg}°"
    )]
    Angles {
        /// Least angle of separation.
        separation_deg: f64,
        /// Angle at which the sheet ends.
        end_deg: f64,
    },
}

impl MedialParams {
    /// Makes settings usable.
    ///
    /// # Errors
    /// If smoothing is negative, not a number or above 2, or angles do not fulfil 0 < separation ≤ end < π.
    pub fn check(self) -> Result<CheckedMedialParams, MedialParamError> {
        if !(0.0..=MAX_SMOOTHING).contains(&self.smoothing) {
            return Err(MedialParamError::Smoothing {
                value: self.smoothing,
                most: MAX_SMOOTHING,
            });
        }
        let ordered = self.separation_rad > 0.0
            && self.separation_rad <= self.end_rad
            && self.end_rad < std::f64::consts::PI;
        if ordered {
            Ok(CheckedMedialParams(self))
        } else {
            Err(MedialParamError::Angles {
                separation_deg: self.separation_rad.to_degrees(),
                end_deg: self.end_rad.to_degrees(),
            })
        }
    }
}
