use std::ffi::c_void;
use std::ops::ControlFlow;
use std::slice;
use std::sync::{Arc, Mutex};

use alphamst_sys as sys;

use crate::callback::lock;
use crate::context::Shared;
use crate::error::check;
use crate::{Error, Mesh, Result};

type Project = Box<dyn FnMut(&[i32], &[f64], &mut [f64]) -> ControlFlow<()> + Send>;

/// What the library is given as `user`. A mesh and its copies hold it, and so it lives as long as one of
/// them.
pub(crate) struct Projection {
    project: Mutex<Project>,
    shared: Arc<Shared>, // takes the panics
    dim: usize,
}

/// Of a slice of coordinates the points.
fn rows<const D: usize>(numbers: &[f64]) -> &[[f64; D]] {
    // SAFETY: an array of numbers is aligned as they are, and has no other bytes.
    unsafe { slice::from_raw_parts(numbers.as_ptr().cast(), numbers.len() / D) }
}

fn rows_mut<const D: usize>(numbers: &mut [f64]) -> &mut [[f64; D]] {
    // SAFETY: as above.
    unsafe { slice::from_raw_parts_mut(numbers.as_mut_ptr().cast(), numbers.len() / D) }
}

/// The boundary as the caller knows it.
impl Mesh {
    /// Says where the boundary runs, for operations with [`Options::edit_boundary`]: `project` is given the
    /// markers of edges and points on or near these, and writes the points of the boundary that belong to
    /// them. Such an operation calls it once when it begins, to learn where the boundary runs, and once in
    /// the end, for new vertices, which come to lie where it says, bit for bit. Copies of the mesh have it,
    /// too; files do not. Until it is set the boundary runs as the edges of the mesh do.
    ///
    /// The operation fails with `Projection`, and changes nothing, if `project` gives `Break`, if a result
    /// is not finite or farther off than [`Options::tolerance`] edges, and if a new vertex turned a face
    /// over there. A panic goes on from the operation's call. `project` is called on the thread of the
    /// operation, may ask the mesh but not change it, and gives equal results for equal points.
    ///
    /// Errors: `Argument` (`D` is not the mesh's dim), `State` (in a callback).
    ///
    /// [`Options::edit_boundary`]: crate::Options::edit_boundary
    /// [`Options::tolerance`]: crate::Options::tolerance
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// use std::ops::ControlFlow;
    /// mesh.set_projection(|_, points: &[[f64; 2]], projected| {
    ///     for (&[x, y], to) in points.iter().zip(projected) {
    ///         *to = [x.clamp(0., 4.), y.clamp(0., 4.)]; // the square that the mesh covers
    ///     }
    ///     ControlFlow::Continue(())
    /// })?;
    /// mesh.adapt(None, 4.0, &Options::new().edit_boundary(true))?;
    /// assert_eq!(mesh.n_faces(), 64);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_projection<F, const D: usize>(&mut self, mut project: F) -> Result<()>
    where
        F: FnMut(&[i32], &[[f64; D]], &mut [[f64; D]]) -> ControlFlow<()> + Send + 'static,
    {
        let dim = self.dim();
        if D != dim {
            return Err(Error::argument(format!(
                "a projection of {D} coordinates is given to a mesh of dim {dim}"
            )));
        }
        let flat: Project =
            Box::new(move |markers, points, projected| project(markers, rows(points), rows_mut(projected)));
        let shared = Arc::clone(&self.shared);
        self.replace_projection(Some(Arc::new(Projection { project: Mutex::new(flat), shared, dim })))
    }

    /// The boundary runs as the edges of the mesh do. Errors: `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_projection(|_, _: &[[f64; 2]], _| std::ops::ControlFlow::Break(()))?;
    /// let options = Options::new().edit_boundary(true);
    /// assert_eq!(mesh.adapt(None, 4.0, &options).unwrap_err().status, Status::Projection);
    /// mesh.clear_projection()?;
    /// mesh.adapt(None, 4.0, &options)?;
    /// # Ok::<(), Error>(())
    /// ```
    pub fn clear_projection(&mut self) -> Result<()> {
        self.replace_projection(None)
    }

    fn replace_projection(&mut self, new: Option<Arc<Projection>>) -> Result<()> {
        let user = new.as_ref().map_or(std::ptr::null(), Arc::as_ptr).cast_mut().cast();
        let thunk: sys::amst_projection_fn = if new.is_some() { Some(project) } else { None };
        // SAFETY: the handle is ours alone; the mesh and its copies hold what `user` points to.
        self.change(|mesh| check(unsafe { sys::amst_mesh_set_projection(mesh, thunk, user) }))?;
        self.projection = new; // drops the old one, where nothing is locked
        Ok(())
    }
}

/// For `amst_mesh_set_projection`, with a `*const Projection` as `user`.
unsafe extern "C" fn project(
    user: *mut c_void,
    n: i64,
    marker: *const i32,
    points: *const f64,
    projected: *mut f64,
) -> i32 {
    if n <= 0 {
        return 0; // the pointers may be NULL, which no slice has
    }
    // SAFETY: the mesh whose operation calls is borrowed for it, and holds its projection.
    let projection = &*user.cast::<Projection>();
    let n = n as usize;
    let markers = slice::from_raw_parts(marker, n);
    let points = slice::from_raw_parts(points, n * projection.dim);
    let projected = slice::from_raw_parts_mut(projected, n * projection.dim);
    let mut project = lock(&projection.project);
    let verdict = projection.shared.callbacks.run(|| project(markers, points, projected));
    (verdict != Some(ControlFlow::Continue(()))).into()
}
