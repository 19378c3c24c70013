//! Keeps what was uploaded for as long as the same `Arc` is drawn.

use std::collections::HashMap;
use std::sync::{Arc, Weak};

/// Redraws after which an upload that nothing asked for is let go: about eight seconds of playing.
const KEPT_REDRAWS: u64 = 512;

struct Entry<T: ?Sized, G> {
    /// Keeps the address from being given to another array.
    source: Weak<T>,
    upload: Arc<G>,
    last_used: u64,
}

/// Uploads of shared arrays, found by the identity of the array.
pub(super) struct Cache<T: ?Sized, G> {
    entries: HashMap<usize, Entry<T, G>>,
}

impl<T: ?Sized, G> Default for Cache<T, G> {
    fn default() -> Self {
        Self {
            entries: HashMap::new(),
        }
    }
}

impl<T: ?Sized, G> Cache<T, G> {
    /// The upload of `source`, made by `upload` if this array has none yet.
    pub fn get(&mut self, source: &Arc<T>, now: u64, upload: impl FnOnce(&T) -> G) -> Arc<G> {
        let address = Arc::as_ptr(source).cast::<()>() as usize;
        let entry = self.entries.entry(address).or_insert_with(|| Entry {
            source: Arc::downgrade(source),
            upload: Arc::new(upload(source)),
            last_used: now,
        });
        entry.last_used = now;
        Arc::clone(&entry.upload)
    }

    /// Lets go of what no longer exists and of what was not drawn lately.
    pub fn evict(&mut self, now: u64) {
        self.entries.retain(|_, entry| {
            entry.source.strong_count() > 0 && now.saturating_sub(entry.last_used) <= KEPT_REDRAWS
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_array_is_uploaded_once_and_an_equal_one_again() {
        let mut cache = Cache::default();
        let (a, b) = (Arc::new(vec![1, 2]), Arc::new(vec![1, 2]));
        let mut uploads = 0;
        for source in [&a, &a, &b, &b] {
            cache.get(source, 0, |_| uploads += 1);
        }
        assert_eq!(uploads, 2);
    }

    #[test]
    fn what_was_dropped_or_long_unused_is_let_go() {
        let mut cache = Cache::default();
        let (kept, dropped, idle) = (Arc::new(1), Arc::new(2), Arc::new(3));
        for source in [&kept, &dropped, &idle] {
            cache.get(source, 0, |_| ());
        }
        drop(dropped);
        cache.get(&kept, KEPT_REDRAWS + 1, |_| ());
        cache.evict(KEPT_REDRAWS + 1);
        assert_eq!(cache.entries.len(), 1);
    }
}
