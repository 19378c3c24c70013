//! Parallel work in waves, between which others have the threads.

/// Parallel `work` on all items in their order, so many for each thread at a time. What else waits for a thread has its
/// turn between two waves: of a subject that was clicked, while all subjects are measured or compared.
///
/// # Errors
/// The first of the first wave that has one.
pub fn in_waves<T, R, E>(
    items: &[T],
    each: usize,
    mut work: impl FnMut(&[T]) -> Result<Vec<R>, E>,
) -> Result<Vec<R>, E> {
    let mut done = Vec::with_capacity(items.len());
    for wave in items.chunks((each * rayon::current_num_threads()).max(1)) {
        done.append(&mut work(wave)?);
    }
    Ok(done)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_come_in_order_and_an_error_ends_the_work() {
        let items: Vec<usize> = (0..1000).collect();
        let mut waves = 0;
        let doubled = in_waves(&items, 3, |wave| {
            waves += 1;
            Ok::<_, ()>(wave.iter().map(|item| 2 * item).collect())
        });
        assert_eq!(
            doubled.unwrap(),
            (0..1000).map(|item| 2 * item).collect::<Vec<_>>()
        );
        assert!(waves > 1 && waves == 1000_usize.div_ceil(3 * rayon::current_num_threads()));
        let mut begun = 0;
        let failed = in_waves(&items, 1, |_| {
            begun += 1;
            Err::<Vec<()>, _>("no")
        });
        assert_eq!((failed, begun), (Err("no"), 1));
    }
}
