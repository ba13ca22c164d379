//! The same work on the items of a list, on all cores at once. Knows nothing of what the work is.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// `f` of each item, in the order of the list. Whoever is free takes the next item: they may cost very different times.
pub fn in_parallel<T: Sync, R: Send>(items: &[T], f: impl Fn(usize, &T) -> R + Sync) -> Vec<R> {
    let mut each: Vec<&T> = items.iter().collect();
    in_parallel_mut(&mut each, |i, item| f(i, item))
}

/// `f` of each item, which it may change, in the order of the list.
pub(crate) fn in_parallel_mut<T: Send, R: Send>(items: &mut [T], f: impl Fn(usize, &mut T) -> R + Sync) -> Vec<R> {
    let workers = std::thread::available_parallelism().map_or(1, usize::from).min(items.len());
    if workers < 2 {
        return items.iter_mut().enumerate().map(|(i, item)| f(i, item)).collect();
    }
    let next = AtomicUsize::new(0);
    // each item is taken once, so nobody waits for a lock
    let open: Vec<Mutex<(&mut T, Option<R>)>> = items.iter_mut().map(|item| Mutex::new((item, None))).collect();
    let work = || {
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(one) = open.get(i) else { break };
            let mut one = one.lock().unwrap_or_else(PoisonError::into_inner);
            let done = f(i, one.0);
            one.1 = Some(done);
        }
    };
    std::thread::scope(|scope| {
        let others: Vec<_> = (1..workers).map(|_| scope.spawn(work)).collect();
        work();
        for other in others {
            if let Err(panic) = other.join() {
                std::panic::resume_unwind(panic);
            }
        }
    });
    open.into_iter().filter_map(|one| one.into_inner().unwrap_or_else(PoisonError::into_inner).1).collect()
}

#[cfg(test)]
mod tests {
    use super::in_parallel;

    #[test]
    fn answers_stand_in_the_order_of_the_list_however_long_each_takes() {
        let items: Vec<u64> = (0..40).collect();
        let slow = |i: usize, item: &u64| {
            std::thread::sleep(std::time::Duration::from_micros(if i.is_multiple_of(7) { 900 } else { 10 }));
            item * item
        };
        assert_eq!(in_parallel(&items, slow), items.iter().map(|i| i * i).collect::<Vec<_>>());
        assert!(in_parallel(&[] as &[u64], |_, _| 0).is_empty());
    }
}
