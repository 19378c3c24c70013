//! Options for the detection of patches; defaults are those of the window.

use clap::Args;

use crate::analysis::medial::MedialParams;
use crate::analysis::medial_space::RatioForm;
use crate::analysis::thickening::{ThickeningParams, ThickeningSettings};
use crate::cli::outcome::CliError;
use crate::cli::words::RatioWord;

/// How medial spheres are fitted, and which regions are patches.
#[derive(Clone, Debug, Args)]
pub struct PatchOptions {
    /// Smoothing length of surfaces before medial spheres are fitted, in wall thicknesses; 0: no smoothing
    #[arg(long, value_name = "L", default_value_t = MedialParams::default().smoothing, allow_negative_numbers = true)]
    pub medial_smoothing: f64,
    /// Minimum angle between the two points at which a medial sphere touches the wall, in degrees
    #[arg(
        long,
        value_name = "DEGREES",
        default_value_t = 60.0,
        allow_negative_numbers = true
    )]
    pub medial_separation: f64,
    /// Angle between spokes below which the medial surface has ended, in degrees
    #[arg(
        long,
        value_name = "DEGREES",
        default_value_t = 120.0,
        allow_negative_numbers = true
    )]
    pub medial_end: f64,
    /// |ln PT| from pose to pose up to which an atom is akinetic [default: estimated from noise]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub patch_tolerance: Option<f64>,
    /// Core threshold of a patch: thickening of its core relative to remote myocardium
    #[arg(long, value_name = "S", default_value_t = ThickeningParams::default().core_threshold, allow_negative_numbers = true)]
    pub patch_core: f64,
    /// Core threshold of a patch in ln PT from end-diastole to end-systole, in addition [default: ln 1.1]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub patch_still: Option<f64>,
    /// Extent threshold of a patch: thickening relative to remote myocardium
    #[arg(long, value_name = "S", default_value_t = ThickeningParams::default().extent_threshold, allow_negative_numbers = true)]
    pub patch_border: f64,
    /// Minimum area of a patch, as a share of the wall
    #[arg(long, value_name = "S", default_value_t = ThickeningParams::default().min_share, allow_negative_numbers = true)]
    pub patch_least_share: f64,
    /// Minimum thickening of remote myocardium for the detection of patches, in ln PT from end-diastole to end-systole [default: ln 1.1]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub patch_least_thickening: Option<f64>,
    /// Minimum area over which thickening is averaged, as a share of the wall
    #[arg(long, value_name = "S", default_value_t = ThickeningParams::default().smoothing, allow_negative_numbers = true)]
    pub patch_averaging: f64,
    /// How the thickness ratio of a patch is averaged
    #[arg(long, value_enum, default_value_t = RatioWord::GeometricMean)]
    pub patch_ratio: RatioWord,
    /// Redraws of noise for the detection stability of a patch; 0: none
    #[arg(long, value_name = "N", default_value_t = ThickeningParams::default().redraws)]
    pub patch_redraws: u32,
    /// Random seed of that noise
    #[arg(long, default_value_t = ThickeningParams::default().seed)]
    pub seed: u64,
}

impl PatchOptions {
    /// The settings that they name.
    ///
    /// # Errors
    /// Wrong usage, if a setting is out of range.
    pub fn settings(&self) -> Result<ThickeningSettings, CliError> {
        let default = ThickeningParams::default();
        let settings = ThickeningSettings {
            medial: MedialParams {
                smoothing: self.medial_smoothing,
                separation_rad: self.medial_separation.to_radians(),
                end_rad: self.medial_end.to_radians(),
            },
            patches: ThickeningParams {
                tolerance: self.patch_tolerance,
                ratio: RatioForm::from(self.patch_ratio),
                core_threshold: self.patch_core,
                akinetic_threshold: self.patch_still.unwrap_or(default.akinetic_threshold),
                extent_threshold: self.patch_border,
                min_share: self.patch_least_share,
                min_thickening: (self.patch_least_thickening).unwrap_or(default.min_thickening),
                smoothing: self.patch_averaging,
                redraws: self.patch_redraws,
                seed: self.seed,
            },
        };
        let usage = |error: &dyn std::fmt::Display| CliError::Usage(error.to_string());
        settings.medial.check().map_err(|error| usage(&error))?;
        settings.patches.check().map_err(|error| usage(&error))?;
        Ok(settings)
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        options: PatchOptions,
    }

    fn settings(words: &[&str]) -> Result<ThickeningSettings, CliError> {
        let line = [&["line"], words].concat();
        Line::try_parse_from(line).unwrap().options.settings()
    }

    #[test]
    fn no_option_means_what_the_window_begins_with() {
        assert_eq!(settings(&[]).unwrap(), ThickeningSettings::default());
    }

    #[test]
    fn each_option_sets_its_own_and_is_checked() {
        let all = settings(&[
            "--medial-smoothing",
            "0.5",
            "--medial-separation",
            "45",
            "--medial-end",
            "90",
            "--patch-tolerance",
            "0.07",
            "--patch-core",
            "0.1",
            "--patch-still",
            "0.15",
            "--patch-border",
            "0.2",
            "--patch-least-share",
            "0.03",
            "--patch-least-thickening",
            "0.04",
            "--patch-averaging",
            "0.05",
            "--patch-ratio",
            "product",
            "--patch-redraws",
            "6",
            "--seed",
            "7",
        ]);
        let expected = ThickeningSettings {
            medial: MedialParams {
                smoothing: 0.5,
                separation_rad: 45_f64.to_radians(),
                end_rad: 90_f64.to_radians(),
            },
            patches: ThickeningParams {
                tolerance: Some(0.07),
                ratio: RatioForm::Product,
                core_threshold: 0.1,
                akinetic_threshold: 0.15,
                extent_threshold: 0.2,
                min_share: 0.03,
                min_thickening: 0.04,
                smoothing: 0.05,
                redraws: 6,
                seed: 7,
            },
        };
        assert_eq!(all.unwrap(), expected);
        for wrong in [
            ["--medial-smoothing", "-1"],
            ["--medial-end", "20"],
            ["--patch-tolerance", "-0.1"],
            ["--patch-border", "0.1"],
        ] {
            assert!(
                matches!(settings(&wrong), Err(CliError::Usage(_))),
                "{wrong:?}"
            );
        }
    }
}
