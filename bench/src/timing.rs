//! Time per call on a machine that does other things too: the minimum over many short batches.

use std::time::{Duration, Instant};

const BATCH: Duration = Duration::from_micros(500);
const BATCHES: usize = 400;

/// Nanoseconds per call of `call`, which is given a number that differs from call to call.
pub fn per_call(mut call: impl FnMut(f64)) -> f64 {
    let mut count = 1_usize;
    let mut run = |count: usize| {
        let start = Instant::now();
        for i in 0..count {
            call(i as f64 * 1e-9);
        }
        start.elapsed()
    };
    // long enough for the clock, short enough to fall between two interruptions now and then
    while run(count) < BATCH {
        count *= 2;
    }
    let least = (0..BATCHES).map(|_| run(count)).min().unwrap_or_default();
    least.as_secs_f64() * 1e9 / count as f64
}

/// Milliseconds of the fastest of some runs, and the last result.
pub fn fastest<T>(runs: usize, mut run: impl FnMut() -> T) -> (f64, T) {
    let mut timed = || {
        let start = Instant::now();
        let value = run();
        (start.elapsed().as_secs_f64() * 1e3, value)
    };
    let (mut least, mut value) = timed();
    for _ in 1..runs {
        let (time, next) = timed();
        least = least.min(time);
        value = next;
    }
    (least, value)
}
