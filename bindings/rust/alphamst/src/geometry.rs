use alphamst_sys as sys;

use crate::error::must;
use crate::{array, Error, Mesh, Result};

/// What a code needs of faces and edges that solves on the mesh.
impl Mesh {
    /// Centroids of what the faces cover; `D` is 2 or 3, that of the mesh.
    ///
    /// Errors: `Argument` (another `D`).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.centroids::<2>()?[5], [1.5, 1.5]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn centroids<const D: usize>(&self) -> Result<Vec<[f64; D]>> {
        self.require_dim(D)?;
        Ok(self.geometry(sys::AMST_GEOMETRY_CENTROIDS))
    }

    /// Lengths of edges.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert!(mesh.lengths().iter().all(|&length| length == 1.0));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn lengths(&self) -> Vec<f64> {
        self.geometry(sys::AMST_GEOMETRY_LENGTHS)
    }

    /// Normals of edges, of length 1, out of the first face of [`edge_faces`](Self::edge_faces), so on the
    /// boundary outwards. On curved meshes they are at right angles to the mean normal of the faces, too.
    ///
    /// Errors: `Argument` (another `D`).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let bottom = mesh.find_edges(&[[VertexId::new(0), VertexId::new(1)]])?[0].unwrap();
    /// assert_eq!(mesh.normals::<2>()?[bottom.index()], [0.0, -1.0]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn normals<const D: usize>(&self) -> Result<Vec<[f64; D]>> {
        self.require_dim(D)?;
        Ok(self.geometry(sys::AMST_GEOMETRY_NORMALS))
    }

    fn require_dim(&self, dim: usize) -> Result<()> {
        if dim == self.dim() {
            return Ok(());
        }
        Err(Error::argument(format!("rows of {dim} numbers are asked of a mesh of dim {}", self.dim())))
    }

    fn geometry<Row>(&self, key: sys::amst_geometry) -> Vec<Row> {
        // SAFETY: rows are of numbers, as many as the mesh has dimensions.
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut f64, capacity, needed| {
                sys::amst_mesh_get_geometry(mesh, key, out, capacity, needed)
            })
        }))
    }
}
