//! How much memory answers hold, and how much they may.

use std::sync::{Arc, OnceLock};

/// Budget where the size of the machine's memory cannot be read.
const UNKNOWN_MACHINE: usize = 2 << 30;

/// Memory of one answer, near enough to bound a store by it.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    own: usize,
    /// Address and size of each part that other answers may hold too.
    shared: Vec<(usize, usize)>,
}

impl Memory {
    /// Counts what no other answer holds.
    pub fn own(&mut self, bytes: usize) {
        self.own += bytes;
    }

    /// Counts what other answers may hold too: it counts once, whoever holds it.
    pub fn shared<T>(&mut self, part: &Arc<T>, bytes: usize) {
        self.shared.push((Arc::as_ptr(part).addr(), bytes));
    }

    /// Its own bytes.
    pub(super) fn own_bytes(&self) -> usize {
        self.own
    }

    /// Address and size of its shared parts.
    pub(super) fn shared_parts(&self) -> &[(usize, usize)] {
        &self.shared
    }
}

/// What the command line asked for.
static ASKED: OnceLock<usize> = OnceLock::new();

/// Sets the budget of all stores of this run of the program, in MiB; the first word stands.
pub fn configure_memory(asked_mib: Option<usize>) {
    if let Some(mib) = asked_mib {
        ASKED.set(mib.saturating_mul(1 << 20)).ok();
    }
}

/// What was asked for, else a quarter of the machine's memory.
pub fn default_budget() -> usize {
    (ASKED.get().copied())
        .unwrap_or_else(|| machine_memory().map_or(UNKNOWN_MACHINE, |bytes| bytes / 4))
}

/// From `/proc/meminfo`, which says `MemTotal: 16384 kB`; other systems have no such file.
fn machine_memory() -> Option<usize> {
    let table = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = table
        .lines()
        .find_map(|line| line.strip_prefix("MemTotal:"))?;
    let kib: usize = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    kib.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::store::StoreOptions;

    #[test]
    fn what_was_asked_for_is_the_budget_of_every_store_and_the_first_word_stands() {
        configure_memory(None);
        // Far more than other tests of this process hold.
        configure_memory(Some(3_000));
        configure_memory(Some(1));
        assert_eq!(default_budget(), 3_000 << 20);
        assert_eq!(StoreOptions::default().budget, 3_000 << 20);
    }
}
