//! The command line (design section 6).

fn main() {}
