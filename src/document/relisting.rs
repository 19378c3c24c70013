//! How the document goes from a study to an edited one: whatever names a subject by its index follows it.

use std::sync::Arc;

use crate::analysis::transport::Reference;
use crate::study::Study;

use crate::document::document::{Document, TransportChoice, cycle_share, position_at_phase};

impl Document {
    /// Shows an edited study, in which the same subjects have the same indices.
    pub fn show_edited(&mut self, study: Study) {
        self.study.study = Arc::new(study);
        // Its patches are found anew and counted in another order.
        self.let_patch_go();
    }

    /// Shows an edited study whose subjects may have other indices, or be gone: whatever names one follows.
    pub fn show_relisted(&mut self, study: Study) {
        let before = Arc::clone(self.study());
        let place = |index: usize| {
            let subject = before.subject(index)?;
            study.all().position(|other| Arc::ptr_eq(other, subject))
        };
        let selected = place(self.subject);
        self.compare_with = self.compare_with.and_then(place);
        self.transported = self.transported.and_then(|motion| {
            let [from, onto] = [place(motion.from)?, place(motion.onto)?];
            Some(TransportChoice { from, onto })
        });
        if let Some(transport) = &mut self.map.distances.transport
            && let Reference::Subject(index) = transport.reference
        {
            // The reference of a cohort is one of its subjects.
            match place(index).filter(|index| !study.is_excluded(*index)) {
                Some(index) => transport.reference = Reference::Subject(index),
                None => self.map.distances.transport = None,
            }
        }
        let phase = (self.selected()).map_or(0.0, |shown| cycle_share(shown, self.position));
        // Where the selected subject is gone, the one that has its place in the cohort is next to it.
        let next = self.subject.min(study.subjects.len().saturating_sub(1));
        self.study.listing = study.revision;
        self.study.study = Arc::new(study);
        match selected {
            Some(index) => self.subject = index,
            None => {
                self.let_patch_go();
                self.subject = next;
                self.position = (self.selected()).map_or(0.0, |s| position_at_phase(s, phase));
            }
        }
    }
}
