//! The clock for reports and for work in slices: seconds from an arbitrary start, never going back.

/// Seconds since an arbitrary start.
#[cfg(not(target_arch = "wasm32"))]
pub fn now() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}

/// Seconds since an arbitrary start.
// `Instant::now` panics on this target.
#[cfg(target_arch = "wasm32")]
pub fn now() -> f64 {
    performance::now() / 1000.0
}

/// Repeats a step, at least once, for about the given time in seconds, or until it returns that
/// there is nothing more to do. Returns whether there is more.
///
/// # Errors
/// That of the step which fails.
pub fn repeat<E>(seconds: f64, mut step: impl FnMut() -> Result<bool, E>) -> Result<bool, E> {
    let until = now() + seconds;
    while step()? {
        if now() >= until {
            return Ok(true);
        }
    }
    Ok(false)
}

#[cfg(target_arch = "wasm32")]
mod performance {
    use wasm_bindgen::prelude::wasm_bindgen;

    #[wasm_bindgen]
    extern "C" {
        /// Milliseconds; available in windows and in workers.
        #[wasm_bindgen(js_namespace = performance)]
        pub(super) fn now() -> f64;
    }
}
