//! Physical quantities that leave a room have their unit as a type.

/// Declares a unit as a newtype over `f64`, printed as a number with its symbol.
macro_rules! unit {
    ($(#[$doc:meta])* $name:ident, $symbol:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
        pub struct $name(pub f64);

        impl std::fmt::Display for $name {
            /// Honours the precision asked for: `{:.1}` prints one decimal place.
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match f.precision() {
                    Some(digits) => write!(f, "{:.*} {}", digits, self.0, $symbol),
                    None => write!(f, "{} {}", self.0, $symbol),
                }
            }
        }
    };
}

unit!(
    /// A length in millimetres.
    Millimetres, "mm"
);
unit!(
    /// A volume in millilitres (1 ml = 1000 mm³).
    Millilitres, "ml"
);
unit!(
    /// A duration in seconds.
    Seconds, "s"
);
unit!(
    /// A mass in grams.
    Grams, "g"
);

/// What one unit of a study's coordinates is.
///
/// Volumes are shown in millilitres only where coordinates are millimetres; otherwise in cubic
/// file units, because a guess would be read as a measurement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum LengthUnit {
    /// Coordinates are millimetres.
    Millimetre,
    /// The files do not say: voxels, or arbitrary units.
    #[default]
    FileUnit,
}

impl LengthUnit {
    /// Symbol of a length: `mm`, or `units`.
    pub fn length_symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::FileUnit => "units",
        }
    }

    /// Symbol of a volume as shown: `ml`, or `units³`.
    pub fn volume_symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "ml",
            Self::FileUnit => "units³",
        }
    }

    /// Symbol of an area as shown: `cm²`, or `units²`.
    pub fn area_symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "cm²",
            Self::FileUnit => "units²",
        }
    }

    /// Factor from cubic coordinates to the shown volume: 1 mm³ is 0.001 ml.
    pub fn volume_from_cubic(self) -> f64 {
        match self {
            Self::Millimetre => 1e-3,
            Self::FileUnit => 1.0,
        }
    }

    /// Factor from square coordinates to the shown area: 1 mm² is 0.01 cm².
    pub fn area_from_square(self) -> f64 {
        match self {
            Self::Millimetre => 1e-2,
            Self::FileUnit => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantity_prints_with_its_unit_and_the_digits_asked_for() {
        assert_eq!(format!("{:.1}", Millilitres(127.96)), "128.0 ml");
        assert_eq!(format!("{}", Grams(90.5)), "90.5 g");
    }
}
