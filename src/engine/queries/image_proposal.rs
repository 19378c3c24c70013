//! What is known of a series of images, and the settings that are proposed for it.

use crate::analysis::preparation::{ImageFacts, Proposal, facts, proposed};
use crate::engine::queries::image_series::SeriesRef;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query, Urgency};
use crate::io::ImageSeries;
use crate::study::Study;

/// What is known of a series, and which settings fit it.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageProposalQuery(pub SeriesRef);

/// What was found.
#[derive(Clone, Debug)]
pub struct ImageProposal {
    /// What is known of the image.
    pub facts: ImageFacts,
    /// Settings for it, and why these.
    pub proposal: Proposal,
}

/// What is known of a series: of its values, and of what its files say.
pub fn series_facts(series: &ImageSeries) -> ImageFacts {
    ImageFacts {
        spacing_known: series.spacing_known(),
        times_known: series.times_known(),
        ..facts(&series.image, series.modality)
    }
}

impl Query for ImageProposalQuery {
    type Answer = ImageProposal;
    const TITLE: &'static str = "Look at images";
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, _study: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, cx: &Context<'_>) -> Result<ImageProposal, Interrupted> {
        cx.progress().check()?;
        let facts = series_facts(&self.0.0);
        Ok(ImageProposal {
            proposal: proposed(&facts),
            facts,
        })
    }

    fn memory(proposal: &ImageProposal, memory: &mut Memory) {
        let labels = proposal.facts.labels.as_deref().unwrap_or_default();
        memory.own(size_of_val(labels) + proposal.proposal.reason.len());
    }

    fn replaces(&self, _other: &Self) -> bool {
        false
    }
}
