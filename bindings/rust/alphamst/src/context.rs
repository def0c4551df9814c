use std::ffi::c_void;
use std::fmt;
use std::ops::ControlFlow;
use std::ptr::NonNull;
use std::sync::Arc;

use alphamst_sys as sys;

use crate::callback::{report_log, report_progress, Callbacks, Log, LogLevel, Progress};
use crate::error::{check, create, must, value};
use crate::thread::Turn;
use crate::Result;

/// Threads and callbacks of the meshes made from it.
///
/// Its calls take `&self`, since its meshes use it too and borrowing could not keep them apart; they
/// wait until no other thread changes anything of this context. Meshes keep what they need of it.
///
/// A callback that owns a handle of its own context keeps both for ever, unless it is cleared; a
/// [`CancelToken`] it may own.
pub struct Context {
    raw: Arc<RawContext>,
    pub(crate) shared: Arc<Shared>,
}

/// What the handles of one context have in common.
#[derive(Default)]
pub(crate) struct Shared {
    pub(crate) turn: Turn,
    pub(crate) callbacks: Callbacks,
}

struct RawContext(NonNull<sys::amst_context>);

// SAFETY: what is called without a Turn, destroying, cancelling and asking for the progress, may be
// called from any thread at any time.
unsafe impl Send for RawContext {}
unsafe impl Sync for RawContext {}

impl Drop for RawContext {
    fn drop(&mut self) {
        // SAFETY: the handle is destroyed here only.
        unsafe { sys::amst_context_destroy(self.0.as_ptr()) }
    }
}

impl Context {
    /// A context with ids from 0, one thread and no callbacks.
    ///
    /// ```
    /// # use alphamst::Context;
    /// let context = Context::new();
    /// assert_eq!(context.progress(), 0.0);
    /// ```
    #[must_use]
    pub fn new() -> Self {
        // SAFETY: the output is written through a valid pointer.
        let raw = must(create(|out| unsafe { sys::amst_context_create(0, out) }));
        Self { raw: Arc::new(RawContext(raw)), shared: Arc::default() }
    }

    /// How many threads an operation uses: 0 all cores, n at most n. Results do not depend on it.
    ///
    /// Errors: `Range` (below 0), `State` (in a callback).
    ///
    /// ```
    /// # use alphamst::{Context, Status};
    /// let context = Context::new();
    /// context.set_threads(2)?;
    /// assert_eq!(context.set_threads(-1).unwrap_err().status, Status::Range);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn set_threads(&self, n: i32) -> Result<()> {
        // SAFETY: the handle is valid, and ours alone for the call.
        self.shared.turn.change(|| check(unsafe { sys::amst_context_set_threads(self.raw(), n) }))
    }

    /// Tells `progress` how far an operation is, as a fraction from 0 to 1, and the word for its stage;
    /// `Break` cancels it, which gives `Cancelled` and leaves the mesh as it was. So does a panic, which
    /// goes on from the operation's call.
    ///
    /// Errors: `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// context.set_progress(|_, _| std::ops::ControlFlow::Break(()))?;
    /// assert_eq!(mesh.smooth(None, None).unwrap_err().status, Status::Cancelled);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_progress<F>(&self, progress: F) -> Result<()>
    where
        F: FnMut(f64, &str) -> ControlFlow<()> + Send + 'static,
    {
        self.replace_progress(Some(Box::new(progress)))
    }

    /// Tells nobody any more. Errors: `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// context.set_progress(|_, _| std::ops::ControlFlow::Break(()))?;
    /// context.clear_progress()?;
    /// mesh.smooth(None, None)?;
    /// # Ok::<(), Error>(())
    /// ```
    pub fn clear_progress(&self) -> Result<()> {
        self.replace_progress(None)
    }

    /// Tells `log` what operations say, up to a level.
    ///
    /// A panic in it goes on from the operation's call, which may have been done by then.
    ///
    /// Errors: `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let (send, receive) = std::sync::mpsc::channel();
    /// context.set_log(LogLevel::Info, move |_, message| send.send(message.to_owned()).unwrap())?;
    /// mesh.smooth(None, None)?;
    /// assert!(receive.try_recv().unwrap().starts_with("smooth: 16 faces before"));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_log<F>(&self, level: LogLevel, log: F) -> Result<()>
    where
        F: FnMut(LogLevel, &str) + Send + 'static,
    {
        self.replace_log(level, Some(Box::new(log)))
    }

    /// Tells nobody any more. Errors: `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// context.set_log(LogLevel::Info, |_, message| panic!("{message}"))?;
    /// context.clear_log()?;
    /// mesh.smooth(None, None)?;
    /// # Ok::<(), Error>(())
    /// ```
    pub fn clear_log(&self) -> Result<()> {
        self.replace_log(LogLevel::Off, None)
    }

    /// 0 to 1, of the operation under way or else of the last one. Waits for nobody.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.smooth(None, None)?;
    /// assert_eq!(context.progress(), 1.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn progress(&self) -> f64 {
        self.raw.progress()
    }

    /// What stops the operations of this context from another thread.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let token = context.cancel_token();
    /// std::thread::spawn(move || token.cancel()).join().unwrap();
    /// assert_eq!(mesh.smooth(None, None).unwrap_err().status, Status::Cancelled);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn cancel_token(&self) -> CancelToken {
        CancelToken(Arc::clone(&self.raw))
    }

    pub(crate) fn raw(&self) -> *mut sys::amst_context {
        self.raw.0.as_ptr()
    }

    fn callbacks(&self) -> *mut c_void {
        let callbacks: *const Callbacks = &self.shared.callbacks;
        callbacks.cast_mut().cast()
    }

    fn replace_progress(&self, progress: Option<Progress>) -> Result<()> {
        let old = self.shared.turn.change(|| {
            // The library is asked even to clear: in a callback it refuses, and the lock on the old
            // function is held by ourselves.
            // SAFETY: as for set_threads; the callbacks live as long as a handle that may call them.
            check(unsafe {
                sys::amst_context_set_progress(self.raw(), Some(report_progress), self.callbacks())
            })?;
            Ok(self.shared.callbacks.replace_progress(progress))
        })?;
        drop(old);
        Ok(())
    }

    fn replace_log(&self, level: LogLevel, log: Option<Log>) -> Result<()> {
        let old = self.shared.turn.change(|| {
            // SAFETY: as for replace_progress.
            check(unsafe {
                sys::amst_context_set_log(self.raw(), level.into(), Some(report_log), self.callbacks())
            })?;
            Ok(self.shared.callbacks.replace_log(log))
        })?;
        drop(old);
        Ok(())
    }
}

impl RawContext {
    fn progress(&self) -> f64 {
        // SAFETY: allowed at any time.
        must(value(|fraction| unsafe { sys::amst_context_get_progress(self.0.as_ptr(), fraction) }))
    }

    fn set_cancel(&self, flag: i32) {
        // SAFETY: allowed at any time.
        must(check(unsafe { sys::amst_context_set_cancel(self.0.as_ptr(), flag) }));
    }
}

impl Default for Context {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Debug for Context {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Context").field("progress", &self.progress()).finish_non_exhaustive()
    }
}

/// Stops the operations of a context, from any thread and without waiting.
#[derive(Clone)]
pub struct CancelToken(Arc<RawContext>);

impl CancelToken {
    /// The operation under way and all later ones give `Cancelled`, until [`CancelToken::reset`].
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// context.cancel_token().cancel();
    /// assert_eq!(mesh.clean(None).unwrap_err().status, Status::Cancelled);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn cancel(&self) {
        self.0.set_cancel(1);
    }

    /// Operations are let through again.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let token = context.cancel_token();
    /// token.cancel();
    /// token.reset();
    /// mesh.clean(None)?;
    /// # Ok::<(), Error>(())
    /// ```
    pub fn reset(&self) {
        self.0.set_cancel(0);
    }

    /// As [`Context::progress`].
    ///
    /// ```
    /// # use alphamst::Context;
    /// assert_eq!(Context::new().cancel_token().progress(), 0.0);
    /// ```
    pub fn progress(&self) -> f64 {
        self.0.progress()
    }
}

impl fmt::Debug for CancelToken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("CancelToken").field("progress", &self.progress()).finish_non_exhaustive()
    }
}
