use alphamst_sys as sys;

use crate::error::check;
use crate::{Error, Mesh, Result};

/// The surface that a curved mesh keeps to: operations project the vertices to it that they move or add.
/// Until it is set it is the mesh as it is when the first operation on it begins.
impl Mesh {
    /// Makes it of triangles, at least one; their corners are numbers of `points` from 0. It is part of
    /// the mesh as fields are; the revision stays.
    ///
    /// Errors: `Argument` (`D` is not the mesh's dim), `Range` (no triangle, a corner that is no point),
    /// `NotFinite`, `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let corners = [[0., 0.], [4., 0.], [4., 4.], [0., 4.]];
    /// mesh.set_surface(&corners, &[[0, 1, 2], [0, 2, 3]])?;
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_surface<const D: usize>(&mut self, points: &[[f64; D]], triangles: &[[i32; 3]]) -> Result<()> {
        let dim = self.dim();
        if D != dim {
            return Err(Error::argument(format!(
                "points of {D} coordinates are given to a mesh of dim {dim}"
            )));
        }
        let (n_points, n_triangles) = (points.len() as i64, triangles.len() as i64);
        // An empty slice has a pointer too, so it is not taken for NULL, which stands for the mesh.
        self.change(|mesh| unsafe {
            // SAFETY: there are n rows of that many numbers in both; the handle is ours alone.
            let (points, triangles) = (points.as_ptr().cast(), triangles.as_ptr().cast());
            check(sys::amst_mesh_set_surface(mesh, points, n_points, triangles, n_triangles))
        })
    }

    /// Makes it of the mesh as it is now, two triangles a face.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_surface_to_mesh()?;
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_surface_to_mesh(&mut self) -> Result<()> {
        let none = std::ptr::null();
        // SAFETY: as above.
        self.change(|mesh| check(unsafe { sys::amst_mesh_set_surface(mesh, none, 0, std::ptr::null(), 0) }))
    }
}
