//! The loss of the graphics device: checked before each picture, and awaited in between.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::task::{Poll, Waker};

/// Whether a device is lost. A lost device never recovers.
#[derive(Debug, Default)]
pub struct Loss {
    happened: AtomicBool,
    waiting: Mutex<Option<Waker>>,
}

impl Loss {
    /// Returns whether the device is lost.
    pub fn happened(&self) -> bool {
        self.happened.load(Ordering::Relaxed)
    }

    /// Records the loss, and wakes the waiting task.
    pub fn happen(&self) {
        self.happened.store(true, Ordering::Relaxed);
        let mut waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(waker) = waiting.take() {
            waker.wake();
        }
    }

    /// Completes when the device is lost. Only one task can wait at a time.
    pub async fn wait(&self) {
        std::future::poll_fn(|context| {
            if self.happened() {
                return Poll::Ready(());
            }
            let mut waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
            *waiting = Some(context.waker().clone());
            Poll::Pending
        })
        .await;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::pin::pin;
    use std::task::Context;

    #[test]
    fn whoever_waits_goes_on_when_it_happens() {
        let loss = Loss::default();
        let mut waiting = pin!(loss.wait());
        let mut context = Context::from_waker(Waker::noop());
        assert!(waiting.as_mut().poll(&mut context).is_pending());
        assert!(!loss.happened());
        loss.happen();
        assert!(loss.happened());
        assert!(waiting.as_mut().poll(&mut context).is_ready());
    }
}
