use alphamst_sys as sys;

use crate::error::{check, value};
use crate::{options, Mesh, Options, Result};

/// The cross field: which way edges should run, and which way they do.
impl Mesh {
    /// Gives the faces a new field `"cross"`, three numbers also in the plane: a direction of length 1 that
    /// edges shall have there, or one at right angles to it. Along the boundary, features and borders of
    /// markers it is that of the edges, elsewhere a principal direction, the more the curvatures in them
    /// differ; and between that it is as smooth as can be. New faces inherit it. Of the options
    /// [`smooth_steps`](Options::smooth_steps) counts. The revision stays.
    ///
    /// Errors: `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.compute_cross_field(None)?;
    /// assert_eq!(mesh.field(Entity::Face, "cross")?.len(), 3 * mesh.n_faces());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn compute_cross_field<'a>(&mut self, options: impl Into<Option<&'a Options>>) -> Result<()> {
        let options = options::raw(options.into());
        // SAFETY: the handle is ours alone, the options live through the call.
        self.change(|mesh| check(unsafe { sys::amst_mesh_compute_cross_field(mesh, options) }))
    }

    /// Mean angle in degrees, 0 to 45, between the sides of faces and the nearest of the four directions of
    /// the face field `"cross"`: 0 where edges follow it, 22.5 where they do not know of it.
    ///
    /// Errors: `NotFound`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.compute_cross_field(None)?;
    /// assert!(mesh.alignment()? < 1e-9);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn alignment(&self) -> Result<f64> {
        // SAFETY: the angle is written through a valid pointer; nobody changes the mesh during the call.
        self.ask(|mesh| value(|degrees| unsafe { sys::amst_mesh_get_alignment(mesh, degrees) }))
    }
}
