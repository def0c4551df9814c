use std::ffi::CString;
use std::fmt;
use std::path::Path;
use std::ptr::NonNull;
use std::sync::Arc;

use alphamst_sys as sys;

use crate::boundary::Projection;
use crate::context::Shared;
use crate::error::{check, create, must, value};
use crate::strided::sealed::Sealed;
use crate::{array, options, Context, Corner, Entity, Error, Options, Result, Strided};

/// A mesh of quadrilaterals with flags, markers, fields and savepoints.
pub struct Mesh {
    raw: NonNull<sys::amst_mesh>,
    pub(crate) shared: Arc<Shared>,
    pub(crate) projection: Option<Arc<Projection>>, // the library has its address, see Drop
}

// SAFETY: what reads or changes the mesh takes its context's turn, through this handle or through the
// patches of the mesh; destroying is allowed at any time.
unsafe impl Send for Mesh {}
unsafe impl Sync for Mesh {}

impl Drop for Mesh {
    fn drop(&mut self) {
        // SAFETY: the handle is destroyed here only.
        unsafe { sys::amst_mesh_destroy(self.raw.as_ptr()) }
    }
}

/// The path as the library takes it: UTF-8 that ends with a zero byte.
pub(crate) fn utf8(path: &Path) -> Result<CString> {
    let text = path.to_str().ok_or_else(|| Error::argument(format!("{} is not UTF-8", path.display())))?;
    CString::new(text).map_err(|_| Error::argument("the path has a zero byte"))
}

/// Making meshes.
impl Mesh {
    /// A mesh from points of 2 or 3 coordinates and faces of three or four corners, counter-clockwise; -1
    /// as the last of four makes a triangle. Triangles are merged in pairs, and all given vertices keep
    /// their ids; [`Mesh::from_strided`] takes options, such as [`OptionKey::Quadrangulate`]. At least one
    /// face, at most 2^28 - 1; unreferenced vertices stay. Faces that run another way round than their
    /// neighbours, or clockwise in the plane, are turned over, and the log tells how many.
    ///
    /// [`OptionKey::Quadrangulate`]: crate::OptionKey::Quadrangulate
    ///
    /// Errors: `Argument` (another number of coordinates or corners), `Range` (corner, count),
    /// `NotFinite`, `NotQuad`, `NotManifold`.
    ///
    /// ```
    /// # use alphamst::{Context, Mesh};
    /// let points = [[0., 0., 1.], [1., 0., 1.], [1., 1., 1.], [0., 1., 1.]];
    /// let mesh = Mesh::new(&Context::new(), &points, &[[0, 1, 2, 3]])?;
    /// assert_eq!((mesh.n_vertices(), mesh.n_edges(), mesh.n_faces(), mesh.dim()), (4, 4, 1, 3));
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn new<I: Corner, const D: usize, const C: usize>(
        context: &Context,
        points: &[[f64; D]],
        faces: &[[I; C]],
    ) -> Result<Self> {
        Self::from_strided(context, Strided::rows(points), Strided::rows(faces), None)
    }

    /// The same from matrices that lie otherwise: one row for each point or face. Of the options
    /// [`OptionKey::Quadrangulate`](crate::OptionKey::Quadrangulate) counts.
    ///
    /// ```
    /// # use alphamst::{Context, Mesh, Strided};
    /// let padded = [0., 0., -9., 1., 0., -9., 1., 1., -9., 0., 1., -9.];
    /// let points = Strided::new(&padded, 4, 2, 3, 1)?;
    /// let mesh = Mesh::from_strided(&Context::new(), points, Strided::packed(&[0, 1, 2, 3], 4)?, None)?;
    /// assert_eq!(mesh.points::<2>()?, [[0., 0.], [1., 0.], [1., 1.], [0., 1.]]);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn from_strided<'a, I: Corner>(
        context: &Context,
        points: Strided<'_, f64>,
        faces: Strided<'_, I>,
        options: impl Into<Option<&'a Options>>,
    ) -> Result<Self> {
        let options = options::raw(options.into());
        // SAFETY: both matrices lie in their slices; the handles are valid.
        Self::made_by(context, |out| unsafe {
            Sealed::create_mesh(context.raw(), points, faces, options, out)
        })
    }

    /// A mesh from a file: .off .obj .ply .msh (Gmsh 1, 2.2, 4.0 and 4.1 ASCII) .su2 .vtk (legacy). It
    /// has dim 2 when every z is 0. Numbers of points, boundaries and regions are [`markers`](Mesh::markers),
    /// with their names; the boundaries of a .su2 file get the numbers 1, 2, ... in the order of the file.
    /// What numbers could not be kept is told by the log, see [`Context::set_log`]. Borders of regions and
    /// marked edges act as [`Flags::FEATURE`]. Triangles become quads as in [`Mesh::from_strided`], but none
    /// is merged with one of another region or over a marked edge.
    ///
    /// Errors: `Io`, `Format`, `Unsupported` (extension, binary variant), `Argument` (a path that is not
    /// UTF-8) and those of [`Mesh::new`].
    ///
    /// [`Flags::FEATURE`]: crate::Flags::FEATURE
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let path = std::env::temp_dir().join("alphamst_read_doc.off");
    /// mesh.write(&path)?;
    /// assert_eq!(Mesh::read(&context, &path, None)?.checksum(), mesh.checksum());
    /// # std::fs::remove_file(path).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    pub fn read<'a>(
        context: &Context,
        path: impl AsRef<Path>,
        options: impl Into<Option<&'a Options>>,
    ) -> Result<Self> {
        let path = utf8(path.as_ref())?;
        let options = options::raw(options.into());
        // SAFETY: the string ends with a zero byte; the handles are valid.
        Self::made_by(context, |out| unsafe {
            sys::amst_mesh_read(context.raw(), path.as_ptr(), options, out)
        })
    }

    /// Writes a file of the same formats, or a picture (.svg) with the singularities marked. All markers and
    /// names are kept by .msh; what another format has no place for is told by the log. A failure leaves no
    /// half-written file.
    ///
    /// Errors: `Io`, `Unsupported` (extension), `Argument` (a path that is not UTF-8).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let path = std::env::temp_dir().join("alphamst_write_doc.svg");
    /// mesh.write(&path)?;
    /// assert!(std::fs::read_to_string(&path).unwrap().contains("<svg"));
    /// # std::fs::remove_file(path).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    pub fn write(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = utf8(path.as_ref())?;
        // SAFETY: as above.
        self.ask(|mesh| check(unsafe { sys::amst_mesh_write(mesh, path.as_ptr()) }))
    }

    fn made_by(context: &Context, call: impl FnOnce(*mut *mut sys::amst_mesh) -> i32) -> Result<Self> {
        let raw = context.shared.turn.change(|| create(call))?;
        Ok(Self { raw, shared: Arc::clone(&context.shared), projection: None })
    }

    /// Runs a call that reads the mesh.
    pub(crate) fn ask<R>(&self, call: impl FnOnce(*const sys::amst_mesh) -> R) -> R {
        self.shared.turn.ask(|| call(self.raw.as_ptr()))
    }

    /// Runs a call that asks this mesh and another one.
    pub(crate) fn ask_both<R>(
        &self,
        other: &Mesh,
        call: impl FnOnce(*const sys::amst_mesh, *const sys::amst_mesh) -> R,
    ) -> R {
        if Arc::ptr_eq(&self.shared, &other.shared) {
            return self.ask(|mesh| call(mesh, other.raw.as_ptr().cast_const()));
            // one turn is for both
        }
        self.ask(|mesh| other.ask(|other| call(mesh, other)))
    }

    /// Runs a call that changes the mesh.
    pub(crate) fn change<R>(&mut self, call: impl FnOnce(*mut sys::amst_mesh) -> R) -> R {
        self.shared.turn.change(|| call(self.raw.as_ptr()))
    }
}

/// What a mesh is asked.
impl Mesh {
    /// 2 or 3 coordinates a point.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.dim(), 2);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn dim(&self) -> usize {
        // SAFETY, here and below: the handle is valid and nobody changes the mesh during the call;
        // outputs are written through valid pointers.
        let dim: i32 = must(self.ask(|mesh| value(|out| unsafe { sys::amst_mesh_get_dim(mesh, out) })));
        array::count(dim.into())
    }

    /// Number of vertices, edges or faces.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.count(Entity::Edge), 40);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn count(&self, entity: Entity) -> usize {
        array::count(must(
            self.ask(|mesh| value(|out| unsafe { sys::amst_mesh_get_count(mesh, entity.into(), out) })),
        ))
    }

    /// Number of vertices.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.n_vertices(), 25);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn n_vertices(&self) -> usize {
        self.count(Entity::Vertex)
    }

    /// Number of edges.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.n_edges(), 40);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn n_edges(&self) -> usize {
        self.count(Entity::Edge)
    }

    /// Number of faces.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.n_faces(), 16);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn n_faces(&self) -> usize {
        self.count(Entity::Face)
    }

    /// Rises with every change of connectivity; never repeats in one mesh, except that
    /// [`Mesh::rollback`] returns to the number it names.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.revision(), 0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn revision(&self) -> i64 {
        must(self.ask(|mesh| value(|out| unsafe { sys::amst_mesh_get_revision(mesh, out) })))
    }

    /// The points, with `D` the mesh's dim or 3: z is 0 in a mesh of dim 2.
    ///
    /// Errors: `Argument` (another `D`).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.points::<2>()?[8], [3., 1.]);
    /// assert_eq!(mesh.points::<3>()?[8], [3., 1., 0.]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn points<const D: usize>(&self) -> Result<Vec<[f64; D]>> {
        let dim = self.dim();
        if D == dim {
            return self.ask(|mesh| unsafe {
                array::rows(|out: *mut f64, capacity, needed| {
                    sys::amst_mesh_get_points(mesh, out, capacity, needed)
                })
            });
        }
        if D != 3 {
            return Err(Error::argument(format!(
                "points of {D} coordinates are asked of a mesh of dim {dim}"
            )));
        }
        let lifted = |[x, y]: [f64; 2]| {
            let mut point = [0.0; D];
            point[..2].copy_from_slice(&[x, y]);
            point
        };
        Ok(self.points::<2>()?.into_iter().map(lifted).collect())
    }

    /// Writes the points to the front of `out`, dim numbers each, and tells how many numbers that are.
    ///
    /// Errors: `BufferTooSmall`; nothing is written then.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut numbers = [0.0; 50];
    /// assert_eq!(mesh.points_into(&mut numbers)?, 50);
    /// assert_eq!(numbers[16..18], [3., 1.]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn points_into(&self, out: &mut [f64]) -> Result<usize> {
        self.ask(|mesh| {
            array::fill(out, |out, capacity, needed| unsafe {
                sys::amst_mesh_get_points(mesh, out, capacity, needed)
            })
        })
    }

    /// New positions for all vertices; connectivity and revision stay.
    ///
    /// Errors: `Argument` (`D` is not the mesh's dim), `Range` (another number of points), `NotFinite`,
    /// `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut points = mesh.points::<2>()?;
    /// points[6] = [1.25, 1.0];
    /// mesh.set_points(&points)?;
    /// assert_eq!(mesh.points::<2>()?, points);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_points<const D: usize>(&mut self, points: &[[f64; D]]) -> Result<()> {
        let dim = self.dim();
        if D != dim {
            return Err(Error::argument(format!(
                "points of {D} coordinates are given to a mesh of dim {dim}"
            )));
        }
        // SAFETY: there are n points of dim coordinates each; the handle is ours alone.
        self.change(|mesh| {
            check(unsafe { sys::amst_mesh_set_points(mesh, points.as_ptr().cast(), points.len() as i64) })
        })
    }

    /// Full check of connectivity and, for dim 2, orientation: no corner turned over or flat. The first
    /// fault is the error's place.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.check()?;
    /// let mut points = mesh.points::<2>()?;
    /// points[6] = [9., 9.];
    /// mesh.set_points(&points)?;
    /// assert!(matches!(mesh.check().unwrap_err().place, Some(Place::Face(_))));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn check(&self) -> Result<()> {
        self.ask(|mesh| check(unsafe { sys::amst_mesh_check(mesh) }))
    }

    /// A mesh of its own in another context, without savepoints and without projection: for threads that work at
    /// the same time, each on a clone in a context of its own.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let clones: Vec<Mesh> = (0..2).map(|_| mesh.clone_into(&Context::new())).collect();
    /// let sums: Vec<i64> = std::thread::scope(|scope| {
    ///     let work = |mut mesh: Mesh| mesh.adapt(None, 2.0, None).map(|_| mesh.checksum());
    ///     let threads: Vec<_> = clones.into_iter().map(|mesh| scope.spawn(move || work(mesh))).collect();
    ///     threads.into_iter().map(|thread| thread.join().unwrap()).collect::<Result<_>>()
    /// })?;
    /// assert_eq!(sums[0], sums[1]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn clone_into(&self, context: &Context) -> Self {
        let raw = must(
            self.ask(|mesh| create(|out| unsafe { sys::amst_mesh_clone_into(mesh, context.raw(), out) })),
        );
        Self { raw, shared: Arc::clone(&context.shared), projection: None }
    }

    /// A digest of coordinates, connectivity, flags and markers; equal for equal meshes. Fields
    /// and names of markers are not in it.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.checksum(), mesh.clone().checksum());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn checksum(&self) -> i64 {
        must(self.ask(|mesh| value(|out| unsafe { sys::amst_mesh_get_checksum(mesh, out) })))
    }
}

/// A mesh of its own in the same context, with flags, markers, fields, revision and projection, without savepoints.
impl Clone for Mesh {
    fn clone(&self) -> Self {
        let raw = must(self.ask(|mesh| create(|out| unsafe { sys::amst_mesh_clone(mesh, out) })));
        Self { raw, shared: Arc::clone(&self.shared), projection: self.projection.clone() }
    }
}

impl fmt::Debug for Mesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Mesh")
            .field("n_vertices", &self.n_vertices())
            .field("n_faces", &self.n_faces())
            .finish_non_exhaustive()
    }
}
