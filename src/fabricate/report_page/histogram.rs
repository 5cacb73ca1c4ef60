//! Histogram of the values behind a number of the build check, from 0 to the limit or beyond.

use super::mark::{GREY, Mark, PALE, RED, block, line, text, text_to};
use super::words::with_unit;
use crate::math::plane::Point2;

/// Number of bars.
const BARS: usize = 30;
/// The font size of its labels.
const TEXT_SIZE: f64 = 2.1;
/// The colour of values within the limit.
const WITHIN: [u8; 3] = [88, 104, 150];

/// Draws `values`, which should be from 0 to `limit`, in a box.
pub(super) fn histogram(
    values: &[f64],
    limit: f64,
    unit: &str,
    [x, y]: Point2,
    [width, height]: [f64; 2],
) -> Vec<Mark> {
    let worst = values.iter().copied().fold(0.0, f64::max);
    let end = worst.max(1.25 * limit);
    if values.is_empty() || !(end.is_finite() && end > 0.0) {
        return Vec::new();
    }
    let mut counts = [0_u32; BARS];
    for value in values {
        counts[((value / end * BARS as f64) as usize).min(BARS - 1)] += 1;
    }
    let most = f64::from(counts.iter().copied().fold(1, u32::max));
    let base = y + TEXT_SIZE + 0.6;
    let room = height - TEXT_SIZE - 0.6;
    let step = width / BARS as f64;
    let mut marks = vec![line([[x, base], [x + width, base]], 0.15, PALE)];
    for (k, count) in counts.into_iter().enumerate().filter(|(_, count)| *count > 0) {
        let from = k as f64 / BARS as f64 * end;
        // Rare values remain visible.
        let high = (f64::from(count) / most * room).max(0.4);
        let fill = if from >= limit { RED } else { WITHIN };
        marks.push(block([x + k as f64 * step, base], [0.85 * step, high], fill));
    }
    let at = x + limit / end * width;
    marks.push(line([[at, base - 0.6], [at, base + room]], 0.25, RED));
    let words = with_unit(end, unit);
    marks.extend([
        text([x, y], TEXT_SIZE, GREY, "0"),
        text_to([x + width, y], TEXT_SIZE, GREY, &words),
    ]);
    marks
}
