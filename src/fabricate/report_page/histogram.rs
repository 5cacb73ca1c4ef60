//! Histogram of the values behind a number of the build check, from 0 to the limit or beyond.

use crate::fabricate::file::{escaped, places};

/// Number of bars.
const BARS: usize = 30;
/// Width and height, in mm when printed.
const SIZE: [f64; 2] = [54.0, 8.5];
/// The height of the bars; the labels are below.
const BASE: f64 = 5.5;

/// Draws `values`, which should be from 0 to `limit`, as SVG; `words` writes a value with its unit.
/// Empty without a value above 0 or a limit.
pub(super) fn histogram(values: &[f64], limit: f64, words: impl Fn(f64) -> String) -> String {
    let worst = values.iter().copied().fold(0.0, f64::max);
    let end = worst.max(1.25 * limit);
    if values.is_empty() || !(end.is_finite() && end > 0.0) {
        return String::new();
    }
    let mut counts = [0_u32; BARS];
    for value in values {
        counts[((value / end * BARS as f64) as usize).min(BARS - 1)] += 1;
    }
    let most = f64::from(counts.iter().copied().fold(1, u32::max));
    let [width, height] = SIZE;
    let step = width / BARS as f64;
    let mut bars = String::new();
    for (k, count) in counts.into_iter().enumerate().filter(|(_, count)| *count > 0) {
        // Rare values remain visible.
        let high = (f64::from(count) / most * BASE).max(0.4);
        let class = if k as f64 / BARS as f64 * end >= limit { "beyond" } else { "within" };
        let [x, y, wide, high] =
            [k as f64 * step, BASE - high, 0.85 * step, high].map(|at| places(at, 2));
        bars += &format!(
            "<rect class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\"/>"
        );
    }
    let at = places(limit / end * width, 2);
    let (words, below) = (escaped(&words(end)), places(BASE + 0.6, 2));
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{} values from 0 to {words}\">\
         <path class=\"axis\" d=\"M0,{BASE}H{width}\"/>{bars}<path class=\"limit\" d=\"M{at},0V{below}\"/>\
         <text y=\"8.3\">0</text><text class=\"end\" x=\"{width}\" y=\"8.3\">{words}</text></svg>",
        values.len()
    )
}
