//! A context serves one thread at a time.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{PoisonError, RwLock};

/// Whose turn it is with a context and all that was made from it. Taken here and not by borrowing,
/// since a mesh and its patches, which read it, are objects of their own.
#[derive(Default)]
pub(crate) struct Turn {
    lock: RwLock<()>,
    owner: AtomicUsize, // the thread that changes something now, 0 for none
}

impl Turn {
    /// A call that changes nothing: may run beside others of the kind.
    pub(crate) fn ask<R>(&self, call: impl FnOnce() -> R) -> R {
        if self.is_mine() {
            return call(); // a callback: it may ask
        }
        let _shared = self.lock.read().unwrap_or_else(PoisonError::into_inner);
        call()
    }

    /// A call that may change something, or call back: runs alone.
    pub(crate) fn change<R>(&self, call: impl FnOnce() -> R) -> R {
        if self.is_mine() {
            return call(); // a callback: the library refuses it
        }
        let _alone = self.lock.write().unwrap_or_else(PoisonError::into_inner);
        let _mine = Owned::new(&self.owner);
        call()
    }

    // Only this thread can have stored its own mark, so no ordering is needed.
    fn is_mine(&self) -> bool {
        self.owner.load(Ordering::Relaxed) == mark()
    }
}

struct Owned<'a>(&'a AtomicUsize);

impl<'a> Owned<'a> {
    fn new(owner: &'a AtomicUsize) -> Self {
        owner.store(mark(), Ordering::Relaxed);
        Self(owner)
    }
}

impl Drop for Owned<'_> {
    fn drop(&mut self) {
        self.0.store(0, Ordering::Relaxed);
    }
}

/// A number that no other thread has while this one lives.
fn mark() -> usize {
    thread_local!(static PLACE: u8 = const { 0 });
    PLACE.with(|place| place as *const u8 as usize)
}
