//! An order in which each thing stands behind what it needs, and the circles that keep it from existing.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Result of sorting.
pub(super) struct Order {
    /// All indices; behind those in order stand those that are stuck.
    pub order: Vec<usize>,
    /// Circles, each starting at its first member.
    pub circles: Vec<Vec<usize>>,
    /// On a circle, or in need of one.
    pub stuck: Vec<usize>,
}

impl Order {
    /// `needs[k]` lists what k needs. Among those that are ready, the smallest index comes first.
    pub(super) fn of(needs: &[Vec<usize>]) -> Self {
        let n = needs.len();
        let mut waiting: Vec<usize> = needs.iter().map(Vec::len).collect();
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); n];
        for (k, list) in needs.iter().enumerate() {
            for &j in list {
                users[j].push(k);
            }
        }
        let mut ready: BinaryHeap<Reverse<usize>> = (0..n).filter(|&k| waiting[k] == 0).map(Reverse).collect();
        let mut order = Vec::with_capacity(n);
        let mut done = vec![false; n];
        while let Some(Reverse(k)) = ready.pop() {
            done[k] = true;
            order.push(k);
            for &user in &users[k] {
                waiting[user] -= 1;
                if waiting[user] == 0 {
                    ready.push(Reverse(user));
                }
            }
        }
        let stuck: Vec<usize> = (0..n).filter(|&k| !done[k]).collect();
        order.extend(&stuck);
        // every stuck one needs a stuck one: following the first of them runs into a circle
        let mut seen = vec![0_usize; n];
        let mut circles = Vec::new();
        for (run, &start) in stuck.iter().enumerate() {
            let mut path = Vec::new();
            let mut at = start;
            while seen[at] == 0 {
                seen[at] = run + 1;
                path.push(at);
                match needs[at].iter().find(|&&j| !done[j]) {
                    Some(&next) => at = next,
                    None => break,
                }
            }
            if seen[at] == run + 1
                && let Some(from) = path.iter().position(|&k| k == at)
            {
                let mut circle = path.split_off(from);
                let least = circle.iter().enumerate().min_by_key(|(_, k)| **k).map_or(0, |(i, _)| i);
                circle.rotate_left(least);
                circles.push(circle);
            }
        }
        Self { order, circles, stuck }
    }
}
