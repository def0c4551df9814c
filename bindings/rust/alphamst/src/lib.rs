//! AlphaMST adapts meshes of quadrilaterals patch by patch.
//!
//! One parameter, alpha, is the wanted ratio of face counts: below 1 a patch is made coarser, above 1
//! finer, and at 1 it is only improved.
//!
//! ```
//! use alphamst::{Context, Mesh, Patches};
//!
//! # fn main() -> Result<(), alphamst::Error> {
//! let points: Vec<[f64; 2]> = (0..121).map(|v| [f64::from(v % 11), f64::from(v / 11)]).collect();
//! let faces: Vec<[i32; 4]> = (0..100).map(|f| f + f / 10).map(|v| [v, v + 1, v + 12, v + 11]).collect();
//! let context = Context::new();
//! let mut mesh = Mesh::new(&context, &points, &faces)?;
//! let mut patches = Patches::new(&mesh, None);
//! let patch = patches.add_box([2., 2., 0.], [8., 8., 0.])?;
//! let report = mesh.adapt(&mut patches, 2.0, None)?; // twice the faces
//! assert_eq!(report.patch(patch)?.faces_after(), 72);
//! assert_eq!(mesh.n_faces(), 136);
//! # Ok(())
//! # }
//! ```
//!
//! # What holds everywhere
//!
//! * **Errors.** After an [`Error`] everything passed in is as it was before the call. A call that
//!   returns a plain value can fail only for want of memory, and panics then.
//! * **Ownership.** Every handle is ended by its `Drop`, in any order and on any thread: a mesh may
//!   outlive its context, patches their mesh, a report all of them.
//! * **Ids** count from 0 and are valid for one revision of the mesh. Faces list their corners
//!   counter-clockwise.
//! * **Units.** Lengths are in the unit of the given coordinates, angles in degrees.
//! * **Threads.** A [`Context`] with all that was made from it serves one thread at a time. All handles
//!   are `Send` and `Sync`; calls that would change something wait until the context is free, and so do
//!   questions while another thread changes something. Work that is to run at the same time takes a
//!   context per thread. A [`Report`] and [`Options`] wait for nobody.
//! * **Callbacks** run on the thread of the call they belong to. They may ask, and drop handles; a call
//!   that would change something of the same context gives [`Status::State`] there. A callback that
//!   waits for another thread which uses the same context waits for ever.
//! * **Panics** in callbacks do not cross the library: they cancel the operation and go on from the
//!   call that started it.

#![deny(missing_docs)]
#![warn(missing_debug_implementations)]

pub use alphamst_sys as sys;

mod array;
mod boundary;
mod callback;
mod chord;
mod connectivity;
mod context;
mod cross_field;
mod enumeration;
mod error;
mod field;
mod flag;
mod geometry;
mod id;
mod indicator;
mod library;
mod markers;
mod mesh;
mod operation;
mod options;
mod patch;
mod patches;
mod quality;
mod report;
mod savepoint;
mod status;
mod strided;
mod surface;
mod thread;

pub use callback::LogLevel;
pub use chord::{Chord, ChordProperty};
pub use context::{CancelToken, Context};
pub use enumeration::UnknownValue;
pub use error::{Error, Place};
pub use field::{Carry, Overlap};
pub use flag::{Defects, Flags, Refusals};
pub use id::{EdgeId, Entity, EntityId, FaceId, PatchId, VertexId};
pub use library::{has, version, version_string};
pub use mesh::Mesh;
pub use options::{OptionKey, Options};
pub use patch::{Patch, Prediction};
pub use patches::{Decomposition, Patches};
pub use quality::{Metric, Summary};
pub use report::{Outcome, Report, ResultKey};
pub use status::Status;
pub use strided::{Corner, Strided};

/// The result of a call that may fail.
pub type Result<T, E = Error> = std::result::Result<T, E>;
