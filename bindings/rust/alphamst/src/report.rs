use std::fmt;
use std::ptr::NonNull;

use alphamst_sys as sys;

use crate::enumeration::enumeration;
use crate::error::{must, value};
use crate::{array, EdgeId, Entity, FaceId, OptionKey, PatchId, Result, Status, VertexId};

enumeration! {
    /// A result of an operation, see the methods of [`Outcome`].
    ResultKey {
        /// Integer: [`Outcome::status`].
        Status = AMST_RESULT_STATUS,
        /// Integer: [`Outcome::faces_before`].
        FacesBefore = AMST_RESULT_FACES_BEFORE,
        /// Integer: [`Outcome::faces_after`].
        FacesAfter = AMST_RESULT_FACES_AFTER,
        /// Integer: [`Outcome::faces_wanted`].
        FacesWanted = AMST_RESULT_FACES_WANTED,
        /// Integer: [`Outcome::singular_before`].
        SingularBefore = AMST_RESULT_SINGULAR_BEFORE,
        /// Integer: [`Outcome::singular_after`].
        SingularAfter = AMST_RESULT_SINGULAR_AFTER,
        /// Integer: [`Outcome::singular_bound`].
        SingularBound = AMST_RESULT_SINGULAR_BOUND,
        /// Integer: [`Outcome::candidate`].
        Candidate = AMST_RESULT_CANDIDATE,
        /// Integer: [`Outcome::unused_option`].
        UnusedOption = AMST_RESULT_UNUSED_OPTION,
        /// Real: [`Outcome::alpha`].
        Alpha = AMST_RESULT_ALPHA,
        /// Real: [`Outcome::quality_before`].
        QualityBefore = AMST_RESULT_QUALITY_BEFORE,
        /// Real: [`Outcome::quality_after`].
        QualityAfter = AMST_RESULT_QUALITY_AFTER,
        /// Real: [`Outcome::seconds`].
        Seconds = AMST_RESULT_SECONDS,
        /// Real: [`Outcome::size_error_before`].
        SizeErrorBefore = AMST_RESULT_SIZE_ERROR_BEFORE,
        /// Real: [`Outcome::size_error_after`].
        SizeErrorAfter = AMST_RESULT_SIZE_ERROR_AFTER,
        /// Real: [`Outcome::least_area_before`].
        LeastAreaBefore = AMST_RESULT_LEAST_AREA_BEFORE,
        /// Real: [`Outcome::least_area_after`].
        LeastAreaAfter = AMST_RESULT_LEAST_AREA_AFTER,
        /// Real: [`Outcome::time_step`].
        TimeStep = AMST_RESULT_TIME_STEP,
        /// Real: [`Outcome::shortest_edge_before`].
        ShortestEdgeBefore = AMST_RESULT_SHORTEST_EDGE_BEFORE,
        /// Real: [`Outcome::shortest_edge_after`].
        ShortestEdgeAfter = AMST_RESULT_SHORTEST_EDGE_AFTER,
        /// Real: [`Outcome::aspect_ratio_before`].
        AspectRatioBefore = AMST_RESULT_ASPECT_RATIO_BEFORE,
        /// Real: [`Outcome::aspect_ratio_after`].
        AspectRatioAfter = AMST_RESULT_ASPECT_RATIO_AFTER,
        /// Real: area after less area before, with [`Options::edit_boundary`](crate::Options::edit_boundary);
        /// else 0.
        AreaGained = AMST_RESULT_AREA_GAINED,
    }
}

/// What one operation did, per patch and in all. It never changes, outlives mesh and patches, and waits
/// for nobody.
#[must_use = "it tells whether all was done that was asked for, see `Report::is_partial`"]
pub struct Report {
    raw: NonNull<sys::amst_report>,
    n_patches: usize,
}

// SAFETY: a report is immutable and shares nothing.
unsafe impl Send for Report {}
unsafe impl Sync for Report {}

impl Drop for Report {
    fn drop(&mut self) {
        // SAFETY: the handle is destroyed here only.
        unsafe { sys::amst_report_destroy(self.raw.as_ptr()) }
    }
}

impl Report {
    pub(crate) fn new(raw: NonNull<sys::amst_report>, n_patches: usize) -> Self {
        Self { raw, n_patches }
    }

    /// Whether some patch was left or missed alpha.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert!(!mesh.smooth(None, None)?.is_partial());
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn is_partial(&self) -> bool {
        self.all().status() == Status::Partial
    }

    /// All patches together: counts are sums, qualities and areas the smallest and size errors the root mean
    /// square over all faces, but singularities, valences and the time step are those of the whole mesh. An
    /// operation that had no patches has only this.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.smooth(None, None)?.all().status(), Status::Ok);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn all(&self) -> Outcome<'_> {
        Outcome { report: self, patch: sys::AMST_ALL }
    }

    /// One patch. Errors: `Range`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let report = mesh.smooth(None, None)?; // had no patches
    /// assert_eq!(report.patch(PatchId::new(0)).unwrap_err().status, Status::Range);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn patch(&self, patch: PatchId) -> Result<Outcome<'_>> {
        // A negative number may be that of all patches, which is no patch.
        let outcome = Outcome { report: self, patch: i32::from(patch).max(-1) };
        outcome.get_int(ResultKey::Status)?;
        Ok(outcome)
    }

    /// All patches, one by one.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, &Options::new().patch_faces(8.0)?);
    /// patches.decompose(Decomposition::Partition)?;
    /// let report = mesh.adapt(&mut patches, 1.0, None)?;
    /// assert_eq!(report.patches().map(|patch| patch.faces_before()).sum::<usize>(), 16);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn patches(&self) -> impl ExactSizeIterator<Item = Outcome<'_>> {
        (0..self.n_patches).map(|patch| Outcome { report: self, patch: patch as i32 })
    }

    /// For each vertex of the mesh after the operation the one it was before, `None` if it is new.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let report = mesh.smooth(None, None)?;
    /// assert_eq!(report.vertex_origins()[3], Some(VertexId::new(3)));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn vertex_origins(&self) -> Vec<Option<VertexId>> {
        self.origins(Entity::Vertex).into_iter().map(VertexId::some).collect()
    }

    /// The same for edges, which are the same if their vertices are.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.smooth(None, None)?.edge_origins().len(), 40);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn edge_origins(&self) -> Vec<Option<EdgeId>> {
        self.origins(Entity::Edge).into_iter().map(EdgeId::some).collect()
    }

    /// The same for faces, which are the same if their vertices are. [`Mesh::overlap`](crate::Mesh::overlap) tells what the
    /// others cover.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// patches.add_rings(VertexId::new(6), 1)?;
    /// let report = mesh.adapt(&mut patches, 2.0, None)?;
    /// assert_eq!(report.face_origins().iter().flatten().count(), 12); // the others are new
    /// # Ok::<(), Error>(())
    /// ```
    pub fn face_origins(&self) -> Vec<Option<FaceId>> {
        self.origins(Entity::Face).into_iter().map(FaceId::some).collect()
    }

    fn origins(&self, entity: Entity) -> Vec<i32> {
        let report = self.raw.as_ptr();
        // SAFETY: the handle is valid and its report never changes.
        must(unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_report_get_origin(report, entity.into(), out, capacity, needed)
            })
        })
    }
}

impl fmt::Debug for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Report")
            .field("status", &self.all().status())
            .field("n_patches", &self.n_patches)
            .finish_non_exhaustive()
    }
}

/// What was done to one patch, or to all.
#[derive(Clone, Copy, Debug)]
pub struct Outcome<'a> {
    report: &'a Report,
    patch: i32,
}

/// Generates the plain getters.
macro_rules! results {
    ($($(#[$about:meta])* $name:ident -> $type:ty = $get:ident($key:ident) $assert:literal;)+) => {
        impl Outcome<'_> {
            $(
                $(#[$about])*
                ///
                /// ```
                #[doc = include_str!("grid.txt")]
                /// let mut patches = Patches::new(&mesh, None);
                /// patches.add_rings(VertexId::new(12), 2)?; // all 16 faces
                /// let report = mesh.adapt(&mut patches, 2.0, None)?;
                /// let outcome = report.patch(PatchId::new(0))?;
                #[doc = $assert]
                /// # Ok::<(), Error>(())
                /// ```
                pub fn $name(&self) -> $type {
                    self.$get(ResultKey::$key)
                }
            )+
        }
    };
}

results! {
    /// Number of faces before.
    faces_before -> usize = count(FacesBefore) "assert_eq!(outcome.faces_before(), 16);";
    /// Number of faces after.
    faces_after -> usize = count(FacesAfter) "assert_eq!(outcome.faces_after(), 32);";
    /// alpha times the faces before, rounded.
    faces_wanted -> usize = count(FacesWanted) "assert_eq!(outcome.faces_wanted(), 32);";
    /// Singular vertices before: of the mesh, in the patch with its boundary.
    singular_before -> usize = count(SingularBefore) "assert_eq!(outcome.singular_before(), 0);";
    /// Singular vertices after, likewise.
    singular_after -> usize = count(SingularAfter) "assert!(outcome.singular_after() > 0);";
    /// The least number that any filling of the boundary has.
    singular_bound -> usize = count(SingularBound) "assert_eq!(outcome.singular_bound(), 0);";
    /// 0: the filling as predicted; n: geometry forced the n-th later one.
    candidate -> usize = count(Candidate) "assert!(outcome.candidate() < 16);";
    /// Faces after over faces before.
    alpha -> f64 = real(Alpha) "assert_eq!(outcome.alpha(), 2.0);";
    /// The smallest scaled Jacobian before.
    quality_before -> f64 = real(QualityBefore) "assert_eq!(outcome.quality_before(), 1.0);";
    /// The smallest scaled Jacobian after.
    quality_after -> f64 = real(QualityAfter) "assert!(outcome.quality_after() > 0.0);";
    /// Seconds spent.
    seconds -> f64 = real(Seconds) "assert!(outcome.seconds() < 60.0);";
    /// Root mean square of log2(area / wanted area) of the faces before; NaN if no sizes were wanted. They
    /// are where [`Mesh::adapt`](crate::Mesh::adapt) and
    /// [`Mesh::reduce_singularities`](crate::Mesh::reduce_singularities) fill: in patches as they were at the
    /// border, and inside as the number of faces asks for; without patches as they were, as the field `"size"`
    /// says or as the curvature asks for, times one factor.
    size_error_before -> f64 = real(SizeErrorBefore) "assert!(outcome.size_error_before() > 0.0);";
    /// The same of the faces after.
    size_error_after -> f64 = real(SizeErrorAfter) "assert!(outcome.size_error_after() < 2.0);";
    /// The smallest area over wanted area before; NaN if no sizes were wanted.
    least_area_before -> f64 = real(LeastAreaBefore) "assert!(outcome.least_area_before() >= 0.99);";
    /// The smallest area over wanted area after, likewise.
    least_area_after -> f64 = real(LeastAreaAfter) "assert!(outcome.least_area_after() > 0.0);";
    /// The smallest area over perimeter of a face, after over before.
    time_step -> f64 = real(TimeStep) "assert!(outcome.time_step() < 1.0); // smaller faces";
    /// The smallest edge over the root of the area wanted there, before; NaN if no sizes were wanted.
    shortest_edge_before -> f64 = real(ShortestEdgeBefore) "assert!(outcome.shortest_edge_before() >= 0.99);";
    /// The same after.
    shortest_edge_after -> f64 = real(ShortestEdgeAfter) "assert!(outcome.shortest_edge_after() > 0.0);";
    /// The largest aspect ratio of a face before.
    aspect_ratio_before -> f64 = real(AspectRatioBefore) "assert!(outcome.aspect_ratio_before() < 1.01); // squares";
    /// The same after.
    aspect_ratio_after -> f64 = real(AspectRatioAfter) "assert!(outcome.aspect_ratio_after() > 1.0);";
}

impl<'a> Outcome<'a> {
    /// The patch, `None` for all together.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.smooth(None, None)?.all().id(), None);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn id(&self) -> Option<PatchId> {
        PatchId::some(self.patch)
    }

    /// How the work on the patch ended; of all: how the call did.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.clean(None)?.all().status(), Status::Ok);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn status(&self) -> Status {
        (must(self.get_int(ResultKey::Status)) as i32).into()
    }

    /// The first option that was set and had no effect on the call, of all together. Also `None` if it is
    /// one that this crate does not know.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let options = Options::new().tolerance(0.3)?; // a plane mesh is as near as can be
    /// let report = mesh.adapt(None, 2.0, &options)?;
    /// assert_eq!(report.all().unused_option(), Some(OptionKey::Tolerance));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn unused_option(&self) -> Option<OptionKey> {
        OptionKey::try_from(must(self.get_int(ResultKey::UnusedOption)) as i32).ok()
    }

    /// Interior vertices of one valence before the operation.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.smooth(None, None)?.all().valence_before(4), 9);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn valence_before(&self, valence: i32) -> usize {
        self.valence(0, valence)
    }

    /// Interior vertices of one valence after the operation.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.smooth(None, None)?.all().valence_after(3), 0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn valence_after(&self, valence: i32) -> usize {
        self.valence(1, valence)
    }

    /// An integer, by key or by the number of one that this crate does not know.
    ///
    /// Errors: `NotFound` (a real's key, or one unknown to the library).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let report = mesh.clean(None)?;
    /// assert_eq!(report.all().get_int(ResultKey::FacesAfter)?, 16);
    /// assert_eq!(report.all().get_int(999).unwrap_err().status, Status::NotFound);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn get_int(&self, key: impl Into<i32>) -> Result<i64> {
        let report = self.report.raw.as_ptr();
        // SAFETY: the handle is valid, the output is written through a valid pointer.
        value(|out| unsafe { sys::amst_report_get_int(report, self.patch, key.into(), out) })
    }

    /// A real, likewise.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.clean(None)?.all().get_real(ResultKey::Alpha)?, 1.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn get_real(&self, key: impl Into<i32>) -> Result<f64> {
        let report = self.report.raw.as_ptr();
        // SAFETY: as above.
        value(|out| unsafe { sys::amst_report_get_real(report, self.patch, key.into(), out) })
    }

    fn valence(&self, after: i32, valence: i32) -> usize {
        let report = self.report.raw.as_ptr();
        // SAFETY: as above.
        array::count(must(value(|out| unsafe {
            sys::amst_report_get_valence(report, self.patch, after, valence, out)
        })))
    }

    fn count(&self, key: ResultKey) -> usize {
        array::count(must(self.get_int(key)))
    }

    fn real(&self, key: ResultKey) -> f64 {
        must(self.get_real(key))
    }
}
