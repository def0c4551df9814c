use std::ffi::{c_char, CString};

use alphamst_sys as sys;

use crate::error::{check, must};
use crate::{array, Entity, EntityId, Error, Mesh, Result};

/// Markers: numbers of boundaries and lines inside (edges), regions (faces) and points (vertices), which operations
/// keep, and their names. They are no ids. 0 is none; vertices with a marker are
/// [`Flags::CORNER`](crate::Flags::CORNER).
impl Mesh {
    /// The marker of the given vertices, edges or faces becomes `value`. The revision stays.
    ///
    /// Errors: `Range` (id), `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_markers(&[EdgeId::new(2), EdgeId::new(5)], 7)?;
    /// assert_eq!(mesh.markers(Entity::Edge)[5], 7);
    /// assert_eq!(mesh.marker_list(Entity::Edge), [7]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_markers<I: EntityId>(&mut self, ids: &[I], value: i32) -> Result<()> {
        // An empty slice has a pointer too, so it is not taken for NULL, which stands for all.
        self.change(|mesh| unsafe {
            // SAFETY: ids are int32_t in every respect; the handle is ours alone.
            check(sys::amst_mesh_set_markers(
                mesh,
                I::ENTITY.into(),
                ids.as_ptr().cast(),
                ids.len() as i64,
                value,
            ))
        })
    }

    /// The same for all vertices, edges or faces.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_all_markers(Entity::Face, 20)?;
    /// assert_eq!(mesh.markers(Entity::Face), [20; 16]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_all_markers(&mut self, entity: Entity, value: i32) -> Result<()> {
        // SAFETY: as above.
        self.change(|mesh| unsafe {
            check(sys::amst_mesh_set_markers(mesh, entity.into(), std::ptr::null(), 0, value))
        })
    }

    /// The marker of every vertex, edge or face.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.markers(Entity::Edge), [0; 40]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn markers(&self, entity: Entity) -> Vec<i32> {
        // SAFETY: the handle is valid, nobody changes the mesh during the call.
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_markers(mesh, entity.into(), out, capacity, needed)
            })
        }))
    }

    /// The markers that some vertex, edge or face has, ascending, without 0.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert!(mesh.marker_list(Entity::Face).is_empty());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn marker_list(&self, entity: Entity) -> Vec<i32> {
        // SAFETY: as above.
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_marker_list(mesh, entity.into(), out, capacity, needed)
            })
        }))
    }

    /// Calls a marker by a name; `""` takes the name away.
    ///
    /// Errors: `Argument` (marker 0, a name with double quotes or control characters), `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_marker_name(Entity::Edge, 7, "inlet")?;
    /// assert_eq!(mesh.marker_name(Entity::Edge, 7), "inlet");
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_marker_name(&mut self, entity: Entity, marker: i32, name: &str) -> Result<()> {
        let name = CString::new(name).map_err(|_| Error::argument("the name has a zero byte"))?;
        // SAFETY: the name ends with a zero byte; the handle is ours alone.
        self.change(|mesh| unsafe {
            check(sys::amst_mesh_set_marker_name(mesh, entity.into(), marker, name.as_ptr()))
        })
    }

    /// What a marker is called; `""` if it has no name.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.marker_name(Entity::Vertex, 77), "");
    /// # Ok::<(), Error>(())
    /// ```
    pub fn marker_name(&self, entity: Entity, marker: i32) -> String {
        // SAFETY: the handle is valid, nobody changes the mesh during the call; bytes are characters of C.
        let mut bytes: Vec<u8> = must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut c_char, capacity, needed| {
                sys::amst_mesh_get_marker_name(mesh, entity.into(), marker, out, capacity, needed)
            })
        }));
        bytes.pop(); // the zero that ends it
        String::from_utf8_lossy(&bytes).into_owned()
    }
}
