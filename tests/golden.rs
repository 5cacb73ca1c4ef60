//! Native and wasm give the same bits: the digest of the positions after 30 steps is one constant.
//! `wasm_engine.rs` compares the same scenes with the same constants in a browser.

use crate::support::grid;

#[path = "data/golden.rs"]
mod digests;

#[test]
fn thirty_steps_give_the_same_bits_natively() {
    digests::check();
}
