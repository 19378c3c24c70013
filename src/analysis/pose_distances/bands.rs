//! Poses made ready for comparison: all at once, or, where they are too many for that, a band of them at a time.

use std::sync::Arc;

use rayon::prelude::*;

use super::source::Source;
use crate::analysis::metrics::{Metric, PreparedPose};
use crate::numeric::in_waves;
use crate::progress::{Progress, Stopped};

/// Bytes that poses made ready may take. A pose of 5,000 vertices takes 0.8 MB, and making it ready as long as some 40
/// pairs: 5,000 of them are made ready in eight bands, 4.5 times each, which adds a fifteenth to the time of their pairs.
pub(super) const PREPARED_BYTES: usize = 1 << 30;

/// Poses that a thread makes ready, and blocks of pairs that it compares, before other work may have it: of meshes of
/// 5,000 vertices within some 50 milliseconds.
pub(super) const WAVE: usize = 16;

/// Poses in bands of equal length, the last may be shorter.
pub(super) struct Bands<'a> {
    metric: &'a Metric,
    sources: Vec<&'a Source<'a>>,
    length: usize,
    /// All of them, where they are one band.
    whole: Option<Arc<Vec<PreparedPose>>>,
}

impl<'a> Bands<'a> {
    /// Makes every pose ready once, each a step; says which cannot be. Two bands at a time take at most `bytes`; their
    /// length is a multiple of `unit`.
    pub(super) fn new(
        metric: &'a Metric,
        sources: &'a [Source<'a>],
        (bytes, unit): (usize, usize),
        progress: &Progress,
    ) -> Result<(Self, Vec<bool>), Stopped> {
        let first = sources.first();
        let one = first.and_then(|source| metric.prepare(&source.normalised()).ok());
        let one = one.map_or(1, |pose| pose.bytes().max(1));
        let length = match sources.len().saturating_mul(one) > bytes {
            true => (bytes / (2 * one) / unit).max(1) * unit,
            false => sources.len().max(1),
        };
        let (mut usable, mut whole) = (Vec::with_capacity(sources.len()), None);
        let all: Vec<&Source<'_>> = sources.iter().collect();
        for band in all.chunks(length) {
            let prepared = prepare(metric, band, progress)?;
            usable.extend(prepared.iter().map(Option::is_some));
            if band.len() == sources.len() {
                whole = Some(Arc::new(prepared.into_iter().flatten().collect()));
            }
        }
        let bands = Self {
            metric,
            sources: all,
            length,
            whole,
        };
        Ok((bands, usable))
    }

    /// Without the poses that are not kept: by pose, whether it could be made ready and is kept.
    pub(super) fn keep(&mut self, usable: &[bool], kept: &[bool]) {
        if let Some(whole) = self.whole.take() {
            let of_usable = usable.iter().zip(kept).filter(|(usable, _)| **usable);
            let whole = Arc::unwrap_or_clone(whole).into_iter().zip(of_usable);
            let whole = whole.filter(|(_, (_, kept))| **kept).map(|(pose, _)| pose);
            self.whole = Some(Arc::new(whole.collect()));
        }
        let mut kept = kept.iter();
        self.sources.retain(|_| kept.next() == Some(&true));
    }

    pub(super) fn sources(&self) -> &[&'a Source<'a>] {
        &self.sources
    }

    /// Poses of a band.
    pub(super) fn length(&self) -> usize {
        self.length
    }

    /// The poses of a band, made ready.
    pub(super) fn band(
        &self,
        band: usize,
        progress: &Progress,
    ) -> Result<Arc<Vec<PreparedPose>>, Stopped> {
        if let Some(whole) = &self.whole {
            return Ok(Arc::clone(whole));
        }
        let sources = self.sources.chunks(self.length).nth(band);
        let prepared = prepare(self.metric, sources.unwrap_or_default(), &progress.within())?;
        Ok(Arc::new(prepared.into_iter().flatten().collect()))
    }
}

/// One entry per source: `None` where lengths overflow.
fn prepare(
    metric: &Metric,
    sources: &[&Source<'_>],
    progress: &Progress,
) -> Result<Vec<Option<PreparedPose>>, Stopped> {
    let ready = |source: &&Source<'_>| -> Result<Option<PreparedPose>, Stopped> {
        progress.step()?;
        Ok(metric.prepare(&source.normalised()).ok())
    };
    in_waves(sources, WAVE, |wave| wave.par_iter().map(ready).collect())
}
