use std::ffi::CString;

use alphamst_sys as sys;

use crate::enumeration::enumeration;
use crate::error::check;
use crate::{array, Entity, Error, Mesh, Result};

enumeration! {
    /// How a field follows the mesh through an operation: what gives new entities their values.
    Carry {
        /// The field goes with an operation that changes connectivity.
        Drop = AMST_CARRY_DROP,
        /// The value of the nearest entity that was replaced.
        Inherit = AMST_CARRY_INHERIT,
        /// Interpolated linearly; for vertices.
        Linear = AMST_CARRY_LINEAR,
        /// Averaged by area, so that the sum of value times area stays; for faces.
        Conserve = AMST_CARRY_CONSERVE,
    }
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
}
