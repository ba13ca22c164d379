//! The same work on the items of a list, on both halves of it at once. Knows nothing of what the work is.

/// `f` of each item, in the order of the list.
pub(crate) fn in_parallel<T: Sync, R: Send>(items: &[T], f: impl Fn(usize, &T) -> R + Sync) -> Vec<R> {
    let mut each: Vec<&T> = items.iter().collect();
    in_parallel_mut(&mut each, |i, item| f(i, item))
}

/// `f` of each item, which it may change, in the order of the list.
pub(crate) fn in_parallel_mut<T: Send, R: Send>(items: &mut [T], f: impl Fn(usize, &mut T) -> R + Sync) -> Vec<R> {
    if items.len() < 2 {
        return items.iter_mut().enumerate().map(|(i, item)| f(i, item)).collect();
    }
    let middle = items.len() / 2;
    let (left, right) = items.split_at_mut(middle);
    std::thread::scope(|scope| {
        let other = scope.spawn(|| right.iter_mut().enumerate().map(|(i, item)| f(middle + i, item)).collect::<Vec<R>>());
        let mut all: Vec<R> = left.iter_mut().enumerate().map(|(i, item)| f(i, item)).collect();
        match other.join() {
            Ok(rest) => all.extend(rest),
            Err(panic) => std::panic::resume_unwind(panic),
        }
        all
    })
}
