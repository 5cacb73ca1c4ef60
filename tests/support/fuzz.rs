//! How long tests with random input run: seconds in `npm test`, longer with `SHAPE_UP_FUZZ=N`, which
//! multiplies the cases by N and draws others every time.
#![allow(dead_code, reason = "each test uses some of these")]

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// `cases` of a seed of their own, or more of random seeds where that is asked for.
pub(crate) fn cases(cases: u32) -> ProptestConfig {
    let factor: Option<u32> =
        std::env::var("SHAPE_UP_FUZZ").ok().map(|n| n.parse().expect("SHAPE_UP_FUZZ is a number"));
    ProptestConfig {
        cases: cases * factor.unwrap_or(1),
        rng_seed: if factor.is_some() { RngSeed::Random } else { RngSeed::Fixed(2012) },
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}
