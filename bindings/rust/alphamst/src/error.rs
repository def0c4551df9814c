use std::ffi::CStr;
use std::{error, fmt, ptr};

use alphamst_sys as sys;

use crate::{EdgeId, Entity, FaceId, PatchId, Result, Status, VertexId};

/// Why a call failed, in the library's words, and where.
///
/// ```
/// # use alphamst::{Context, Mesh, Place, FaceId, Status};
/// let points = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]];
/// let error = Mesh::new(&Context::new(), &points, &[[0, 1, 2, 7]]).unwrap_err();
/// assert_eq!(error.status, Status::Range);
/// assert_eq!(error.place, Some(Place::Face(FaceId::new(0))));
/// assert!(error.to_string().contains("corner 7"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Error {
    /// What kind of failure it is.
    pub status: Status,
    /// A sentence for people.
    pub message: String,
    /// The entity it is about, if it is about one.
    pub place: Option<Place>,
    /// The patch it is about, if it is about one.
    pub patch: Option<PatchId>,
}

/// The entity that a failure is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A vertex.
    Vertex(VertexId),
    /// An edge.
    Edge(EdgeId),
    /// A face.
    Face(FaceId),
}

impl Error {
    /// The number of the status, below 0.
    ///
    /// ```
    /// # use alphamst::{Context, Mesh};
    /// assert_eq!(Mesh::read(&Context::new(), "no such file.off", None).unwrap_err().code(), -11);
    /// ```
    pub fn code(&self) -> i32 {
        self.status.into()
    }

    // The last failure of this thread: to be asked for right after the call that failed.
    fn last(code: i32) -> Self {
        let (mut entity, mut id, mut patch) = (sys::AMST_ENTITY_NONE, -1, -1);
        // SAFETY: the sentence is valid until the next failing call on this thread.
        let message = unsafe {
            sys::amst_last_error_where(&mut entity, &mut id, &mut patch);
            CStr::from_ptr(sys::amst_last_error()).to_string_lossy().into_owned()
        };
        let place = match Entity::try_from(entity) {
            Ok(Entity::Vertex) => Some(Place::Vertex(VertexId::new(id))),
            Ok(Entity::Edge) => Some(Place::Edge(EdgeId::new(id))),
            Ok(Entity::Face) => Some(Place::Face(FaceId::new(id))),
            Err(_) => None,
        };
        Self { status: code.into(), message, place, patch: PatchId::some(patch) }
    }

    /// A failure that this crate finds before the library is asked.
    pub(crate) fn argument(message: impl Into<String>) -> Self {
        Self { status: Status::Argument, message: message.into(), place: None, patch: None }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl error::Error for Error {}

/// The error of a failed call on this thread.
pub(crate) fn check(status: i32) -> Result<()> {
    if status < 0 {
        return Err(Error::last(status));
    }
    Ok(())
}

/// For calls that fail only when the library is out of memory.
#[track_caller]
pub(crate) fn must<T>(result: Result<T>) -> T {
    result.unwrap_or_else(|error| panic!("{}: {error}", error.status))
}

/// A new handle written through an output argument.
pub(crate) fn create<T>(call: impl FnOnce(*mut *mut T) -> i32) -> Result<ptr::NonNull<T>> {
    let mut raw = ptr::null_mut();
    check(call(&mut raw))?;
    Ok(ptr::NonNull::new(raw).expect("a successful call writes its handle"))
}

/// One number written through an output argument.
pub(crate) fn value<T: Default>(call: impl FnOnce(*mut T) -> i32) -> Result<T> {
    let mut value = T::default();
    check(call(&mut value))?;
    Ok(value)
}
