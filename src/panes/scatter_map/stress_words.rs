//! What is said of how well a map keeps the distances.

use crate::analysis::embedding::{FAIR_STRESS, GOOD_STRESS, POOR_STRESS};

/// What the stress of a map means, with what Kruskal calls good and poor.
pub fn stress_words() -> String {
    format!(
        "Kruskal's stress 1: relative error of the distances on the map; {GOOD_STRESS} is good, \
         {FAIR_STRESS} fair, {POOR_STRESS} poor."
    )
}
