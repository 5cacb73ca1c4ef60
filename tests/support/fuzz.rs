//! Run time of tests with random input: seconds in `npm test`, longer with `SHAPE_UP_FUZZ=N`, which
//! multiplies the number of cases by N and uses random seeds.

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// `cases` cases with a fixed seed, or a multiple with random seeds if requested.
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
