//! Whether a number of the build check is within its limit.

/// Numbers below this, in mm of the building or degrees, are rounding errors: a limit of 0 is met by
/// them.
pub(super) const ROUNDING: f64 = 1e-6;

/// Whether a number is within its limit.
pub(super) fn is_within(value: f64, limit: f64) -> bool {
    value <= limit.max(ROUNDING)
}
