//! The table of features: what each is called, what it is counted in, what it is, and whether the classifier reads it.

/// What a feature is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeatureUnit {
    /// A share from 0 to 1.
    Share,
    /// A ratio of two like quantities.
    Ratio,
    /// A distance in the medial shape space, which has no unit.
    PoseDistance,
    /// Sizes of the medial surface.
    Sizes,
    /// The logarithm of a thickness ratio PT.
    LnPt,
    /// Radians.
    Radians,
    /// Lengths, which mean something only where coordinates are millimetres.
    Millimetres,
    /// Millilitres a square metre of body surface.
    MillilitresPerSquareMetre,
    /// Grams a square metre of body surface.
    GramsPerSquareMetre,
    /// Grams a millilitre.
    GramsPerMillilitre,
}

impl FeatureUnit {
    /// As tables and files of classifiers write it; empty where there is none.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Share | Self::Ratio | Self::PoseDistance => "",
            Self::Sizes => "× size",
            Self::LnPt => "ln PT",
            Self::Radians => "rad",
            Self::Millimetres => "mm",
            Self::MillilitresPerSquareMetre => "ml/m²",
            Self::GramsPerSquareMetre => "g/m²",
            Self::GramsPerMillilitre => "g/ml",
        }
    }
}

/// Makes the enum, its lists and what is known of each feature from one table, so that none can be left out.
macro_rules! features {
    (
        model: { $($model:ident, $model_name:literal, $model_unit:ident, $model_what:literal;)* }
        others: { $($other:ident, $other_name:literal, $other_unit:ident, $other_what:literal;)* }
    ) => {
        /// One feature of a subject.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Feature {
            $(#[doc = concat!($model_what, ".")] $model,)*
            $(#[doc = concat!($other_what, ".")] $other,)*
        }

        impl Feature {
            /// All of them, those that the classifier reads first.
            pub const ALL: [Self; [$(Self::$model,)* $(Self::$other,)*].len()] =
                [$(Self::$model,)* $(Self::$other,)*];

            /// Those that the classifier reads. The ones of 4.4–4.7 (compactness, closeness, ANV, MP) tell less and are
            /// shown as evidence: see [`verdicts`](super::verdicts()) for what was measured.
            pub const MODEL_FEATURES: [Self; [$(Self::$model,)*].len()] = [$(Self::$model,)*];

            /// The model feature of a name, in any case.
            pub fn of_name(name: &str) -> Option<Self> {
                let mut all = Self::MODEL_FEATURES.into_iter();
                all.find(|feature| feature.name().eq_ignore_ascii_case(name.trim()))
            }

            /// What it is called in tables, on screen and in files of classifiers.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$model => $model_name,)*
                    $(Self::$other => $other_name,)*
                }
            }

            /// What it is counted in.
            pub const fn unit(self) -> FeatureUnit {
                match self {
                    $(Self::$model => FeatureUnit::$model_unit,)*
                    $(Self::$other => FeatureUnit::$other_unit,)*
                }
            }

            /// What it is, in a sentence without a full stop, for tables and for hovers.
            pub const fn explanation(self) -> &'static str {
                match self {
                    $(Self::$model => $model_what,)*
                    $(Self::$other => $other_what,)*
                }
            }
        }
    };
}

// A new feature has a line here; the compiler then asks for it in `features` and in `whole_heart`.
features! {
    model: {
        AkineticShare, "Akinetic region", Share,
            "Share of the wall with thickening below 10 % from end-diastole to end-systole, whatever the akinetic \
             threshold of patches is";
        Median, "Median thickening", LnPt,
            "Area-weighted median over the wall of thickening from end-diastole to end-systole";
        RelativeSpread, "Thickening heterogeneity", Ratio,
            "Standard deviation of thickening over the wall relative to the thickening of remote myocardium, which \
             counts as at least 10 %; 0 for uniform thickening";
        EjectionFraction, "Ejection fraction", Share,
            "Stroke volume relative to end-diastolic volume";
        EdvIndex, "EDV index", MillilitresPerSquareMetre,
            "End-diastolic volume relative to body surface (Mosteller); no value without height and weight";
        EsvIndex, "ESV index", MillilitresPerSquareMetre,
            "End-systolic volume relative to body surface (Mosteller); no value without height and weight";
        MassIndex, "Mass index", GramsPerSquareMetre,
            "Mass of the myocardium relative to body surface (Mosteller); no value without height and weight";
        MassToVolume, "Mass / EDV", GramsPerMillilitre,
            "Mass of the myocardium relative to end-diastolic volume: large where the wall is thick for its cavity";
        WallEd, "Wall thickness at ED", Millimetres,
            "Area-weighted median over the wall of its thickness (diameter of medial spheres) at end-diastole";
        ThickestEd, "Greatest wall thickness at ED", Millimetres,
            "Area-weighted 95th percentile over the wall of its thickness at end-diastole";
        ThicknessRatio, "Greatest / median wall thickness", Ratio,
            "95th percentile of wall thickness at end-diastole relative to its median: 1 for a wall of one thickness";
        WallEs, "Wall thickness at ES", Millimetres,
            "Area-weighted median over the wall of its thickness at end-systole";
        ThickestEs, "Greatest wall thickness at ES", Millimetres,
            "Area-weighted 95th percentile over the wall of its thickness at end-systole";
        SphericityEd, "Sphericity at ED", Ratio,
            "Volume of the cavity at end-diastole relative to a sphere whose diameter is the long axis";
        SphericityEs, "Sphericity at ES", Ratio,
            "Volume of the cavity at end-systole relative to a sphere whose diameter is the long axis";
        InwardSpread, "Heterogeneity of inward motion", Share,
            "Area-weighted standard deviation over the inner surface of its motion towards the centroid from \
             end-diastole to end-systole, relative to the distance there";
        InwardTenth, "Least inward motion", Share,
            "Area-weighted 10th percentile over the inner surface of its motion towards the centroid from \
             end-diastole to end-systole, relative to the distance there";
    }
    others: {
        Spread, "SD of thickening", LnPt,
            "Area-weighted standard deviation over the wall of thickening from end-diastole to end-systole";
        TenthPercentile, "10th percentile of thickening", LnPt,
            "Area-weighted 10th percentile over the wall of thickening from end-diastole to end-systole";
        Remote, "Remote thickening", LnPt,
            "Thickening of remote myocardium from end-diastole to end-systole";
        UpperRange, "Upper range of thickening", LnPt,
            "Thickening of remote myocardium plus twice its standard deviation over the wall: small where the whole \
             wall is hypokinetic";
        PatchShare, "Wall in patches", Share,
            "Share of the wall in patches, each weighted by its detection stability";
        Confidence, "Detection stability", Share,
            "Share of noise redraws in which the largest patch is detected again; 0 without a patch";
        PatchThickening, "Ratio of patch to remote thickening", Ratio,
            "Thickening of the largest patch relative to that of remote myocardium, as logarithms of PT: 0 without \
             thickening, 1 without a patch";
        Compactness, "Compactness", Ratio,
            "4π × area / perimeter² of the largest patch, at most 1: 1 for a disc, small for an irregular outline, 0 \
             without a patch";
        MeanPoseDistance, "Mean pose distance", PoseDistance,
            "Mean distance between poses in the medial shape space (4.5.1) of the largest patch or, without one, of \
             the akinetic region: small for a region that changes little over the cycle";
        NormalSpread, "Angular SD of ANV", Radians,
            "Angular standard deviation over the cycle of the average normal vector (ANV, 4.4.1) of the largest patch \
             or, without one, of the akinetic region";
        MeanPositionDistance, "Distance of MP", Sizes,
            "Mean distance to the medial surface of the mean position (MP, 4.4.2) of the largest patch or, without \
             one, of the akinetic region, relative to the size of the medial surface: small for one compact patch";
    }
}
