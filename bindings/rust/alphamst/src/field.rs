use std::ffi::CString;

use alphamst_sys as sys;

use crate::enumeration::enumeration;
use crate::error::check;
use crate::{array, Entity, Error, FaceId, Mesh, Result};

enumeration! {
    /// How a field follows the mesh through an operation: what gives new entities their values.
    Carry {
        /// The field goes with an operation that changes connectivity.
        Drop = AMST_CARRY_DROP,
        /// The value of the nearest entity that was replaced.
        Inherit = AMST_CARRY_INHERIT,
        /// Interpolated linearly; for vertices, also where they have moved.
        Linear = AMST_CARRY_LINEAR,
        /// The mean over a face, or over the quarters of faces at a vertex; the sum of value times area
        /// stays. The field before is taken as linear on each of them.
        Conserve = AMST_CARRY_CONSERVE,
        /// As `Conserve`, but the field before is taken as constant there.
        Average = AMST_CARRY_AVERAGE,
    }
}

/// What a face of one mesh and a face of another share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// The face of the mesh before.
    pub before: FaceId,
    /// The face of the mesh after.
    pub after: FaceId,
    /// The area of both.
    pub area: f64,
}

fn utf8(name: &str) -> Result<CString> {
    CString::new(name).map_err(|_| Error::argument("the name has a zero byte"))
}

/// Fields: named numbers on every vertex, edge or face, which follow the mesh through operations.
impl Mesh {
    /// A new field, or a new one in the place of the old: `components` numbers for each entity, those
    /// of one entity side by side. Operations keep the values of what they keep; `carry` gives the
    /// others theirs. The revision stays.
    ///
    /// The library reads `"size"`, one number above 0 at each vertex: the wanted edge length; and `"cross"`,
    /// three at each face, see [`compute_cross_field`](Mesh::compute_cross_field). [`adapt`](Mesh::adapt) and
    /// [`reduce_singularities`](Mesh::reduce_singularities) write to `"size error"`, one number at each face, if
    /// it is there, log2(area / wanted area) where they want sizes; pictures show it in colour.
    ///
    /// Errors: `Argument` (name empty, name or carry not for this entity), `Range` (components, number of
    /// values, a size not above 0), `NotFinite`, `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_field(Entity::Vertex, "size", 1, Carry::Linear, &[0.5; 25])?;
    /// mesh.set_field(Entity::Face, "velocity", 2, Carry::Conserve, &[0.0; 32])?;
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_field(
        &mut self,
        entity: Entity,
        name: &str,
        components: usize,
        carry: Carry,
        values: &[f64],
    ) -> Result<()> {
        let name = utf8(name)?;
        let width = i32::try_from(components).unwrap_or(i32::MAX);
        if components > 0 && values.len() % components != 0 {
            return Err(Error::argument(format!("{} values are no rows of {components}", values.len())));
        }
        // Of 0 components there are no rows; the library says so.
        let n = values.len().checked_div(components).unwrap_or(0) as i64;
        // SAFETY: there are n rows of that many values; the handle is ours alone.
        self.change(|mesh| unsafe {
            let (name, values) = (name.as_ptr(), values.as_ptr());
            check(sys::amst_mesh_set_field(mesh, entity.into(), name, width, carry.into(), values, n))
        })
    }

    /// The numbers of every vertex, edge or face.
    ///
    /// Errors: `Argument` (name empty), `NotFound`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_field(Entity::Face, "wet", 1, Carry::Inherit, &[1.0; 16])?;
    /// assert_eq!(mesh.field(Entity::Face, "wet")?, [1.0; 16]);
    /// assert_eq!(mesh.field(Entity::Edge, "wet").unwrap_err().status, Status::NotFound);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn field(&self, entity: Entity, name: &str) -> Result<Vec<f64>> {
        let name = utf8(name)?;
        // SAFETY: the handle is valid, nobody changes the mesh during the call.
        self.ask(|mesh| unsafe {
            array::rows(|out: *mut f64, capacity, needed| {
                sys::amst_mesh_get_field(mesh, entity.into(), name.as_ptr(), out, capacity, needed)
            })
        })
    }

    /// Writes the numbers to the front of `out` and tells how many they are.
    ///
    /// Errors: `Argument` (name empty), `NotFound`, `BufferTooSmall`; nothing is written then.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_field(Entity::Face, "wet", 1, Carry::Inherit, &[1.0; 16])?;
    /// let mut numbers = [0.0; 20];
    /// assert_eq!(mesh.field_into(Entity::Face, "wet", &mut numbers)?, 16);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn field_into(&self, entity: Entity, name: &str, out: &mut [f64]) -> Result<usize> {
        let name = utf8(name)?;
        // SAFETY: as above.
        self.ask(|mesh| {
            array::fill(out, |out, capacity, needed| unsafe {
                sys::amst_mesh_get_field(mesh, entity.into(), name.as_ptr(), out, capacity, needed)
            })
        })
    }

    /// Takes a field away.
    ///
    /// Errors: `Argument` (name empty), `NotFound`, `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_field(Entity::Face, "wet", 1, Carry::Drop, &[1.0; 16])?;
    /// mesh.remove_field(Entity::Face, "wet")?;
    /// assert!(mesh.remove_field(Entity::Face, "wet").is_err());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn remove_field(&mut self, entity: Entity, name: &str) -> Result<()> {
        let name = utf8(name)?;
        // SAFETY: the handle is ours alone.
        self.change(|mesh| check(unsafe { sys::amst_mesh_remove_field(mesh, entity.into(), name.as_ptr()) }))
    }

    /// What the faces of two meshes of one domain share, as a clone of a mesh and that mesh after an
    /// operation, for codes that carry their fields themselves: ascending by the face after, then before. In
    /// a plane the areas of a face sum up to its own where the other mesh covers it.
    ///
    /// Errors: `Argument` (one mesh has dim 2, the other 3).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let rows = mesh.overlap(&mesh)?;
    /// assert_eq!(rows.len(), 16);
    /// assert!(rows.iter().all(|row| row.before == row.after && (row.area - 1.0).abs() < 1e-12));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn overlap(&self, after: &Mesh) -> Result<Vec<Overlap>> {
        // Mostly enough, so that the work is done once: a face meets about four, on either side.
        let mut capacity = 4 * (self.n_faces() + after.n_faces());
        loop {
            let (mut ids, mut others, mut areas) =
                (vec![0; capacity], vec![0; capacity], vec![0.0; capacity]);
            let mut needed = 0;
            // SAFETY: the handles are valid, nobody changes the meshes during the call, which writes at most
            // the capacity.
            let status = self.ask_both(after, |before, after| unsafe {
                let (ids, others) = (ids.as_mut_ptr(), others.as_mut_ptr());
                let room = capacity as i64;
                sys::amst_mesh_get_overlap(before, after, ids, others, areas.as_mut_ptr(), room, &mut needed)
            });
            if status != sys::AMST_ERR_BUFFER_TOO_SMALL {
                check(status)?;
                let rows = ids.into_iter().zip(others).zip(areas).take(array::count(needed));
                return Ok(rows
                    .map(|((before, after), area)| Overlap {
                        before: before.into(),
                        after: after.into(),
                        area,
                    })
                    .collect());
            }
            capacity = array::count(needed);
        }
    }
}
