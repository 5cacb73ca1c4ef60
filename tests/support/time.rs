//! Times beside other times.

use std::time::Instant;

/// Asserts that `work` takes less than `factor` times as long as `unit`, by the least time of each.
///
/// Both are timed in turn until that is seen, at most 20 times, because other tests run beside this
/// one and may take the processor away from either.
#[track_caller]
pub(crate) fn takes_less(factor: f64, mut work: impl FnMut(), mut unit: impl FnMut()) {
    fn seconds(what: &mut impl FnMut()) -> f64 {
        let begun = Instant::now();
        what();
        begun.elapsed().as_secs_f64()
    }
    let [mut took, mut beside] = [f64::INFINITY; 2];
    for _ in 0..20 {
        beside = beside.min(seconds(&mut unit));
        took = took.min(seconds(&mut work));
        if took < factor * beside {
            return;
        }
    }
    panic!("{took} s beside {beside} s");
}
