//! The list of metrics.

/// Makes the enum and the list of all its variants, so that none can be left out of the list.
macro_rules! metric_kinds {
    ($($(#[$attribute:meta])* $kind:ident,)*) => {
        /// What a metric penalises.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        pub enum MetricKind {
            $($(#[$attribute])* $kind,)*
        }

        /// All metrics in the order in which they are offered.
        pub const METRICS: [MetricKind; [$(MetricKind::$kind,)*].len()] = [$(MetricKind::$kind,)*];
    };
}

// A new metric has a line here and a file in `kinds`, which the compiler then asks for.
metric_kinds! {
    /// Displacement that no rigid motion explains (2.3.7).
    #[default]
    Displacement,
    /// Change of angles and of Gaussian curvature (eq. 3.5).
    QuasiConformal,
    /// Change of angles (eq. 3.3, 3.4).
    AnglePreserving,
    /// Change of edge lengths (2.3.6).
    Isometric,
}
