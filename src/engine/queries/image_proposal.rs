//! What is known of a series of images, and the settings that are proposed for it.

use crate::analysis::preparation::{ImageFacts, Proposal, proposed};
use crate::engine::image_walls::series_facts;
use crate::engine::queries::image_series::SeriesRef;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query, Urgency};
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
