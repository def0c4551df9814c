use std::ptr;

use alphamst_sys as sys;

use crate::callback::resume;
use crate::error::create;
use crate::{options, Mesh, Options, Patches, Report, Result};

/// Operations. Each changes the mesh or, on an error, a cancel and a panic in a progress callback or a
/// projection, not at all; it works on a copy, so that for a moment the mesh takes twice its memory. Patches with
/// defects are left and make the report [`is_partial`](Report::is_partial). The patches move along to
/// the new revision and the new faces.
///
/// Errors of all: `Argument` (patches of another mesh), `Stale`, `State`, `Cancelled`.
impl Mesh {
    /// Replaces each patch by its alpha template. `alpha`, above 0, is for the patches that have none of
    /// their own. Without patches the whole mesh, plane or curved, with windows that the library chooses:
    /// round(alpha * faces) faces, as few singular vertices as it can, boundary and features kept; a
    /// vertex field "size" says where the faces go. A curved mesh keeps to its surface; features of one
    /// lose and get vertices only where they are straight. [`Options::edit_boundary`] lets the boundary
    /// change, see [`OptionKey::EditBoundary`](crate::OptionKey::EditBoundary).
    ///
    /// Errors: also `Argument` (alpha), `NotFinite`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// patches.add_box([0.; 3], [4., 4., 0.])?;
    /// let report = mesh.adapt(&mut patches, 2.0, None)?;
    /// assert_eq!((mesh.n_faces(), report.all().alpha()), (32, 2.0));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn adapt<'a, 'p>(
        &mut self,
        patches: impl Into<Option<&'p mut Patches>>,
        alpha: f64,
        options: impl Into<Option<&'a Options>>,
    ) -> Result<Report> {
        let (patches, options) = (patches.into(), options::raw(options.into()));
        let (set, n_patches) = patches.map_or((ptr::null_mut(), 0), |set| (set.raw(), set.len()));
        // SAFETY, here and below: the handles are valid, those that change are ours alone.
        self.operate(n_patches, |mesh, report| unsafe { sys::amst_adapt(mesh, set, alpha, options, report) })
    }

    /// Replaces each patch by its minimum singularity template; its boundary is kept, but for
    /// [`Options::edit_boundary`]. Without patches the whole mesh; its number of faces stays within a few percent.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(12), 2)?;
    /// let report = mesh.reduce_singularities(&mut patches, None)?;
    /// assert_eq!(report.patch(patch)?.singular_after(), 0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn reduce_singularities<'a, 'p>(
        &mut self,
        patches: impl Into<Option<&'p mut Patches>>,
        options: impl Into<Option<&'a Options>>,
    ) -> Result<Report> {
        let (patches, options) = (patches.into(), options::raw(options.into()));
        let (set, n_patches) = patches.map_or((ptr::null_mut(), 0), |set| (set.raw(), set.len()));
        self.operate(n_patches, |mesh, report| unsafe {
            sys::amst_reduce_singularities(mesh, set, options, report)
        })
    }

    /// Moves interior vertices of the patches, or of the mesh without patches; flagged ones stay, but for
    /// those on straight features of a curved mesh, which slide along them. The revision stays, too.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut points = mesh.points::<2>()?;
    /// points[12] = [2.4, 1.7];
    /// mesh.set_points(&points)?;
    /// let report = mesh.smooth(None, None)?;
    /// assert!(report.all().quality_after() > report.all().quality_before());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn smooth<'a, 'p>(
        &mut self,
        patches: impl Into<Option<&'p Patches>>,
        options: impl Into<Option<&'a Options>>,
    ) -> Result<Report> {
        let (patches, options) = (patches.into(), options::raw(options.into()));
        let set = patches.map_or(ptr::null_mut(), Patches::raw);
        self.operate(patches.map_or(0, Patches::len), |mesh, report| unsafe {
            sys::amst_smooth(mesh, set, options, report)
        })
    }

    /// Removes doublets and splits valences above 5. The revision rises if there were any.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let report = mesh.clean(None)?;
    /// assert_eq!((report.all().faces_before(), report.all().faces_after()), (16, 16));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn clean<'a>(&mut self, options: impl Into<Option<&'a Options>>) -> Result<Report> {
        let options = options::raw(options.into());
        self.operate(0, |mesh, report| unsafe { sys::amst_clean(mesh, options, report) })
    }

    pub(crate) fn operate(
        &mut self,
        n_patches: usize,
        call: impl FnOnce(*mut sys::amst_mesh, *mut *mut sys::amst_report) -> i32,
    ) -> Result<Report> {
        let shared = self.shared.clone();
        let (result, panic) = self.change(|mesh| {
            let result = create(|report| call(mesh, report));
            // Taken before the turn of another thread, whose operation it must not stop.
            (result, shared.callbacks.take_panic())
        });
        let report = result.map(|raw| Report::new(raw, n_patches));
        resume(panic);
        report
    }
}
