use alphamst_sys as sys;

use crate::error::{check, must};
use crate::{array, EdgeId, FaceId, Mesh, Result, VertexId};

// SAFETY, throughout: the handle is valid and nobody changes the mesh during the call; ids are int32_t.

/// Connectivity.
impl Mesh {
    /// The corners of every face, counter-clockwise.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.faces()[4], [5, 6, 11, 10].map(VertexId::new));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn faces(&self) -> Vec<[VertexId; 4]> {
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_faces(mesh, out, capacity, needed)
            })
        }))
    }

    /// Writes the corners of the faces to the front of `out` and tells how many faces there are.
    ///
    /// Errors: `BufferTooSmall`; nothing is written then.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut faces = [[VertexId::new(0); 4]; 20];
    /// assert_eq!(mesh.faces_into(&mut faces)?, 16);
    /// assert_eq!(faces[..16], mesh.faces());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn faces_into(&self, out: &mut [[VertexId; 4]]) -> Result<usize> {
        // SAFETY: a VertexId is an int32_t, and arrays lie in a slice without gaps.
        let ids = unsafe { std::slice::from_raw_parts_mut(out.as_mut_ptr().cast::<i32>(), 4 * out.len()) };
        let n = self.ask(|mesh| {
            array::fill(ids, |out, capacity, needed| unsafe {
                sys::amst_mesh_get_faces(mesh, out, capacity, needed)
            })
        })?;
        Ok(n / 4)
    }

    /// The vertices of every edge, the smaller id first.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert!(mesh.edges().contains(&[VertexId::new(7), VertexId::new(12)]));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn edges(&self) -> Vec<[VertexId; 2]> {
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_edges(mesh, out, capacity, needed)
            })
        }))
    }

    /// The vertices of sharp edges that pairs of triangles have been made over, ids being those when the mesh
    /// was created or read.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert!(mesh.crossed_edges().is_empty());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn crossed_edges(&self) -> Vec<[VertexId; 2]> {
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_crossed_edges(mesh, out, capacity, needed)
            })
        }))
    }

    /// Two vertices and the new one at the midpoint of the edge between them, which may be half of another
    /// edge, likewise.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert!(mesh.split_edges().is_empty());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn split_edges(&self) -> Vec<[VertexId; 3]> {
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_split_edges(mesh, out, capacity, needed)
            })
        }))
    }

    /// The faces left and right of every edge, seen from its first vertex to its second; on the boundary the
    /// one face there is, then `None`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let bottom = mesh.find_edges(&[[VertexId::new(0), VertexId::new(1)]])?[0].unwrap();
    /// assert_eq!(mesh.edge_faces()[bottom.index()], [Some(FaceId::new(0)), None]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn edge_faces(&self) -> Vec<[Option<FaceId>; 2]> {
        let sides: Vec<[i32; 2]> = must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_edge_faces(mesh, out, capacity, needed)
            })
        }));
        sides.into_iter().map(|pair| pair.map(FaceId::some)).collect()
    }

    /// The faces around each vertex, counter-clockwise, on the boundary from one of its edges to the other:
    /// those of vertex v are `faces[offsets[v]..offsets[v + 1]]` of the pair `(offsets, faces)`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let (offsets, faces) = mesh.vertex_faces();
    /// assert_eq!(faces[offsets[6]..offsets[7]].len(), mesh.valences()[6] as usize);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn vertex_faces(&self) -> (Vec<usize>, Vec<FaceId>) {
        let mut offsets = vec![0; self.n_vertices() + 1];
        let first: *mut i32 = offsets.as_mut_ptr();
        let faces = must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_vertex_faces(mesh, first, out, capacity, needed)
            })
        }));
        (offsets.into_iter().map(|offset| array::count(offset.into())).collect(), faces)
    }

    /// The edge of each pair of vertices, `None` where there is no such edge.
    ///
    /// Errors: `Range` (vertex).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let found = mesh.find_edges(&[[6, 7], [6, 12]].map(|pair| pair.map(VertexId::new)))?;
    /// assert!(found[0].is_some() && found[1].is_none());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn find_edges(&self, pairs: &[[VertexId; 2]]) -> Result<Vec<Option<EdgeId>>> {
        let mut edges = vec![-1; pairs.len()];
        self.ask(|mesh| {
            let (first, n) = (pairs.as_ptr().cast(), pairs.len() as i64);
            check(unsafe { sys::amst_mesh_find_edges(mesh, first, n, edges.as_mut_ptr()) })
        })?;
        Ok(edges.into_iter().map(EdgeId::some).collect())
    }

    /// Number of edges at each vertex.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.valences()[..7], [2, 3, 3, 3, 2, 3, 4]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn valences(&self) -> Vec<i32> {
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_valences(mesh, out, capacity, needed)
            })
        }))
    }

    /// Interior vertices of valence other than 4, ascending.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.singularities().len(), 0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn singularities(&self) -> impl ExactSizeIterator<Item = VertexId> {
        let ids: Vec<VertexId> = must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_singularities(mesh, out, capacity, needed)
            })
        }));
        ids.into_iter()
    }
}
