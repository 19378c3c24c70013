//! How good walls of images are, in the words of a line and of a row.

use crate::engine::MadeWalls;
use crate::study::Severity;

/// A mean distance of the surfaces from what they were made of that needs a look, in millimetres: a pixel of cine MR.
const MEAN_MM: f64 = 1.5;
/// The same of the 95th percentile.
const P95_MM: f64 = 4.0;

/// The worst fit of all frames and surfaces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fit {
    /// Mean distance in millimetres.
    pub mean_mm: f64,
    /// 95th percentile in millimetres.
    pub p95_mm: f64,
    /// Faces that are folded over.
    pub foldovers: usize,
}

/// How the surfaces lie on what they were made of.
pub fn fit(made: &MadeWalls) -> Fit {
    let fits = made.prepared.walls.fits.iter();
    fits.fold(Fit::default(), |worst, fit| Fit {
        mean_mm: worst.mean_mm.max(fit.mean_mm),
        p95_mm: worst.p95_mm.max(fit.p95_mm),
        foldovers: worst.foldovers + fit.foldovers,
    })
}

/// What about the walls needs a look; `None` where nothing does.
pub fn needs_a_look(made: &MadeWalls) -> Option<String> {
    let fit = fit(made);
    if fit.foldovers > 0 {
        return Some(format!("{} faces folded over", fit.foldovers));
    }
    if fit.mean_mm > MEAN_MM || fit.p95_mm > P95_MM {
        return Some(format!(
            "fit {:.1} mm, 95 % {:.1} mm",
            fit.mean_mm, fit.p95_mm
        ));
    }
    let notices = made.subject.notices.iter();
    let mut warnings = notices.filter(|notice| notice.severity == Severity::Warning);
    warnings.next().map(|notice| notice.text.clone())
}
