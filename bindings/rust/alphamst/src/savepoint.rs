use alphamst_sys as sys;

use crate::error::{check, value};
use crate::{Mesh, Result};

/// Undoing.
impl Mesh {
    /// Remembers the mesh, with points, connectivity, flags and fields, and tells its revision, which
    /// names the savepoint. Savepoints nest; of several with one name the latest is meant. Memory is taken only
    /// when the mesh changes.
    ///
    /// Errors: `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.mark()?, mesh.revision());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn mark(&mut self) -> Result<i64> {
        // SAFETY: the handle is valid and ours alone; the output is written through a valid pointer.
        self.change(|mesh| value(|out| unsafe { sys::amst_mesh_mark(mesh, out) }))
    }

    /// Back to a savepoint, which stays; later ones are forgotten. Patches of its revision are current
    /// again.
    ///
    /// Errors: `NotFound`, `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let (start, digest) = (mesh.mark()?, mesh.checksum());
    /// mesh.set_all_flags(Entity::Face, Flags::FIXED, Flags::FIXED)?;
    /// mesh.rollback(start)?;
    /// assert_eq!(mesh.checksum(), digest);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn rollback(&mut self, revision: i64) -> Result<()> {
        // SAFETY: as above.
        self.change(|mesh| check(unsafe { sys::amst_mesh_rollback(mesh, revision) }))
    }

    /// Gives up one savepoint; the mesh stays as it is.
    ///
    /// Errors: `NotFound`, `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let start = mesh.mark()?;
    /// mesh.forget(start)?;
    /// assert_eq!(mesh.rollback(start).unwrap_err().status, Status::NotFound);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn forget(&mut self, revision: i64) -> Result<()> {
        // SAFETY: as above.
        self.change(|mesh| check(unsafe { sys::amst_mesh_forget(mesh, revision) }))
    }
}
