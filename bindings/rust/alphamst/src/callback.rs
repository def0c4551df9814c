//! The caller's functions, and what stands between them and the library: no panic may cross it.

use std::any::Any;
use std::ffi::{c_char, c_void, CStr};
use std::ops::ControlFlow;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::enumeration::enumeration;

enumeration! {
    /// How much the log is told.
    ///
    /// ```
    /// # use alphamst::LogLevel;
    /// assert_eq!(LogLevel::try_from(2), Ok(LogLevel::Info));
    /// ```
    LogLevel {
        /// Nothing.
        Off = AMST_LOG_OFF,
        /// Failures.
        Error = AMST_LOG_ERROR,
        /// What was left undone and options without effect, too.
        Warning = AMST_LOG_WARNING,
        /// What was done, too: one line a stage.
        Info = AMST_LOG_INFO,
        /// Everything: one line a patch or window.
        Debug = AMST_LOG_DEBUG,
    }
}

pub(crate) type Progress = Box<dyn FnMut(f64, &str) -> ControlFlow<()> + Send>;
pub(crate) type Log = Box<dyn FnMut(LogLevel, &str) + Send>;
pub(crate) type Panic = Box<dyn Any + Send>;

/// Lives as long as any handle whose calls may call back.
#[derive(Default)]
pub(crate) struct Callbacks {
    progress: Mutex<Option<Progress>>,
    log: Mutex<Option<Log>>,
    panic: Mutex<Option<Panic>>,
}

pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Callbacks {
    /// The old function, to be dropped where nothing is locked.
    pub(crate) fn replace_progress(&self, new: Option<Progress>) -> Option<Progress> {
        std::mem::replace(&mut *lock(&self.progress), new)
    }

    pub(crate) fn replace_log(&self, new: Option<Log>) -> Option<Log> {
        std::mem::replace(&mut *lock(&self.log), new)
    }

    pub(crate) fn take_panic(&self) -> Option<Panic> {
        lock(&self.panic).take()
    }

    /// None if it panicked, now or before.
    pub(crate) fn run<R>(&self, call: impl FnOnce() -> R) -> Option<R> {
        if lock(&self.panic).is_some() {
            return None;
        }
        match catch_unwind(AssertUnwindSafe(call)) {
            Ok(result) => Some(result),
            Err(panic) => {
                *lock(&self.panic) = Some(panic);
                None
            }
        }
    }
}

/// Goes on with a panic that was stopped before the library.
pub(crate) fn resume(panic: Option<Panic>) {
    if let Some(panic) = panic {
        resume_unwind(panic);
    }
}

/// For `amst_context_set_progress`, with a `*const Callbacks` as `user`.
pub(crate) unsafe extern "C" fn report_progress(
    user: *mut c_void,
    fraction: f64,
    stage: *const c_char,
) -> i32 {
    // SAFETY: the mesh whose operation calls back keeps its callbacks alive.
    let callbacks = &*user.cast::<Callbacks>();
    let stage = CStr::from_ptr(stage).to_string_lossy();
    let mut progress = lock(&callbacks.progress);
    let verdict = callbacks.run(|| match progress.as_mut() {
        Some(progress) => progress(fraction, &stage),
        None => ControlFlow::Continue(()),
    });
    (verdict != Some(ControlFlow::Continue(()))).into()
}

/// For `amst_context_set_log`, likewise.
pub(crate) unsafe extern "C" fn report_log(user: *mut c_void, level: i32, message: *const c_char) {
    // SAFETY: as above.
    let callbacks = &*user.cast::<Callbacks>();
    let message = CStr::from_ptr(message).to_string_lossy();
    let level = LogLevel::try_from(level).unwrap_or(LogLevel::Debug);
    let mut log = lock(&callbacks.log);
    callbacks.run(|| {
        if let Some(log) = log.as_mut() {
            log(level, &message);
        }
    });
}
