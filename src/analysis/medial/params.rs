//! How strongly surfaces are smoothed, and which balls count.

/// Settings of the medial surface; [`MedialParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MedialParams {
    /// Length ℓ over which the surfaces are smoothed before balls are laid into the wall, as a share of the wall's median
    /// thickness. Waves of length 2πℓ keep three quarters of their height. 0: surfaces as they are.
    pub smoothing: f64,
    /// Least angle at the centre of a ball between the two points at which it touches. What touches it
    /// nearer to its own vertex is roughness of the same side and does not shrink it.
    pub separation_rad: f64,
    /// Angle between the spokes below which the sheet counts as ended.
    pub end_rad: f64,
}

impl Default for MedialParams {
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

/// Smoothing over more would turn a ventricle into a ball.
const MOST_SMOOTHING: f64 = 2.0;

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
        if !(0.0..=MOST_SMOOTHING).contains(&self.smoothing) {
            return Err(MedialParamError::Smoothing {
                value: self.smoothing,
                most: MOST_SMOOTHING,
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
