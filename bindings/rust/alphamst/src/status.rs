use std::ffi::CStr;
use std::fmt;

macro_rules! statuses {
    ($($(#[$what:meta])* $variant:ident = $constant:ident,)+) => {
        /// How a call, or the work on one patch, ended.
        ///
        /// ```
        /// # use alphamst::Status;
        /// assert_eq!(Status::from(-9), Status::Stale);
        /// assert_eq!(i32::from(Status::Partial), 1);
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Status {
            $($(#[$what])* $variant,)+
            /// A status that this crate does not know yet; negative ones are failures.
            Other(i32),
        }

        impl From<i32> for Status {
            fn from(code: i32) -> Self {
                match code {
                    $(alphamst_sys::$constant => Self::$variant,)+
                    _ => Self::Other(code),
                }
            }
        }

        impl From<Status> for i32 {
            fn from(status: Status) -> i32 {
                match status {
                    $(Status::$variant => alphamst_sys::$constant,)+
                    Status::Other(code) => code,
                }
            }
        }
    };
}

statuses! {
    /// A bug in the library.
    Internal = AMST_ERR_INTERNAL,
    /// No filling could be given a valid shape; the patch is as before.
    Geometry = AMST_ERR_GEOMETRY,
    /// The projection of the boundary failed, see [`Mesh::set_projection`](crate::Mesh::set_projection);
    /// the mesh is as before the call.
    Projection = AMST_ERR_PROJECTION,
    /// A chord cannot be collapsed or split, see [`Refusals`](crate::Refusals).
    Chord = AMST_ERR_CHORD,
    /// No filling with the wanted faces was found; the patch is as before.
    NoFilling = AMST_ERR_NO_FILLING,
    /// A call that is not allowed now, such as a change from a callback.
    State = AMST_ERR_STATE,
    /// Not enough memory.
    NoMemory = AMST_ERR_NO_MEMORY,
    /// Cancelled; the mesh is as before the call.
    Cancelled = AMST_ERR_CANCELLED,
    /// A file variant or a curved patch, which this version cannot do.
    Unsupported = AMST_ERR_UNSUPPORTED,
    /// A malformed file.
    Format = AMST_ERR_FORMAT,
    /// A file cannot be opened, read or written.
    Io = AMST_ERR_IO,
    /// No such key or revision.
    NotFound = AMST_ERR_NOT_FOUND,
    /// Patches of an older revision.
    Stale = AMST_ERR_STALE,
    /// A patch that is not a usable disk, see [`Defects`](crate::Defects).
    Patch = AMST_ERR_PATCH,
    /// An edge with three or more faces, a surface with one side, or faces that meet in a vertex alone.
    NotManifold = AMST_ERR_NOT_MANIFOLD,
    /// A face without four distinct corners.
    NotQuad = AMST_ERR_NOT_QUAD,
    /// NaN or infinity in the input.
    NotFinite = AMST_ERR_NOT_FINITE,
    /// The slice given is too short for the answer.
    BufferTooSmall = AMST_ERR_BUFFER_TOO_SMALL,
    /// An id, count or value out of range.
    Range = AMST_ERR_RANGE,
    /// Another argument that cannot be accepted.
    Argument = AMST_ERR_ARGUMENT,
    /// A required pointer is NULL; this crate never passes one.
    Null = AMST_ERR_NULL,
    /// Success.
    Ok = AMST_OK,
    /// Done, but some patch was left or missed alpha.
    Partial = AMST_PARTIAL,
}

impl Status {
    /// The name in C, or "unknown status".
    ///
    /// ```
    /// # use alphamst::Status;
    /// assert_eq!(Status::Stale.name(), "AMST_ERR_STALE");
    /// ```
    pub fn name(self) -> &'static str {
        // SAFETY: the answer is a constant string, never NULL.
        let name = unsafe { CStr::from_ptr(alphamst_sys::amst_status_name(self.into())) };
        name.to_str().unwrap_or("unknown status")
    }

    /// Whether this is a failure: neither success nor success with a remark.
    ///
    /// ```
    /// # use alphamst::Status;
    /// assert!(Status::Io.is_failure() && !Status::Partial.is_failure());
    /// ```
    pub fn is_failure(self) -> bool {
        i32::from(self) < 0
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
