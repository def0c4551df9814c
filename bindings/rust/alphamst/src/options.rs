use std::fmt;
use std::ptr::{self, NonNull};

use alphamst_sys as sys;

use crate::enumeration::enumeration;
use crate::error::{check, create, must, value};
use crate::{array, Result, VertexId};

enumeration! {
    /// A setting of [`Options`], with its default.
    OptionKey {
        /// Integer, 0: seed of every random choice.
        Seed = AMST_OPT_SEED,
        /// Integer, 20: sweeps of shape optimisation, 0 to 1000.
        SmoothSteps = AMST_OPT_SMOOTH_STEPS,
        /// Integer 0 or 1, 1: fill small holes and cut pinches of new patches.
        RepairPatches = AMST_OPT_REPAIR_PATCHES,
        /// Integer, 16: fillings to try in a patch before it is left, 1 to 1000.
        Candidates = AMST_OPT_CANDIDATES,
        /// Integer, 1000: effort of one exact search, in quads laid, 0 to 10^9.
        NodeLimit = AMST_OPT_NODE_LIMIT,
        /// Integer 0 or 1, 0: triangles of a new mesh are paired, 1: every face is split.
        Quadrangulate = AMST_OPT_QUADRANGULATE,
        /// Integer 0 or 1, 0: the boundary of a plane mesh stays vertex for vertex, 1: vertices come and go
        /// on it where edges would be far from the wanted length, and where that saves singular vertices.
        /// Flagged ones, corners and ends of markers stay; new ones lie on the boundary as it was, or see
        /// [`Mesh::set_projection`](crate::Mesh::set_projection). On a curved mesh and with
        /// [`Strategy`](Self::Strategy) 1: chords may take vertices from features and boundary where these
        /// turn by less than 30 degrees.
        EditBoundary = AMST_OPT_EDIT_BOUNDARY,
        /// Integer, 0: a whole mesh is adapted by windows, 1: by chords alone.
        Strategy = AMST_OPT_STRATEGY,
        /// Integer 0 or 1, 0: edges of curved meshes follow their cross field.
        Align = AMST_OPT_ALIGN,
        /// Integer, 0: map of what is curved, 0: a plane or a circle, 1: mean value, 2: conformal,
        /// 3: low stretch.
        Chart = AMST_OPT_CHART,
        /// Integer 0 or 1, 0: new meshes get no vertex on the boundary, or fail.
        KeepBoundary = AMST_OPT_KEEP_BOUNDARY,
        /// Integer, 1: searches of a whole mesh with different luck, of which the best is kept; they share the
        /// threads of the context, 1 to 1000.
        Starts = AMST_OPT_STARTS,
        /// Real, 0.0: no filling with a scaled Jacobian at or below, 0 to 1.
        MinQuality = AMST_OPT_MIN_QUALITY,
        /// Real, 0.6: a patch below is [`Defects::NOT_CONVEX`](crate::Defects::NOT_CONVEX), 0 to 1.
        MinConvexity = AMST_OPT_MIN_CONVEXITY,
        /// Real, 100: faces of a patch that automatic decomposition aims at, at least 1.
        PatchFaces = AMST_OPT_PATCH_FACES,
        /// Real, 0.5: farthest from the surface or the boundary, in wanted edges, 0.01 to 100.
        Tolerance = AMST_OPT_TOLERANCE,
        /// Real, 1.0: times as much is spent on better fillings, 0.01 to 100.
        Effort = AMST_OPT_EFFORT,
        /// Real, 0.7: of wanted sizes against shapes, 0 to 1.
        SizeWeight = AMST_OPT_SIZE_WEIGHT,
        /// Real, 0.5: of a patch's depth, over which sizes change, 0.05 to 1.
        Transition = AMST_OPT_TRANSITION,
        /// Real, 0.125: area over wanted area; no smaller face is made, 0 to 1.
        LeastSize = AMST_OPT_LEAST_SIZE,
        /// Real, 40.0: triangles of a new mesh are not paired over sharper edges, 0 to 180 degrees.
        SharpAngle = AMST_OPT_SHARP_ANGLE,
        /// Real, 0.0: log2 of areas; in whole plane meshes with a field "size" faces off by less stay, and the
        /// field alone says how many faces there are; 0: all may change.
        SizeBand = AMST_OPT_SIZE_BAND,
        /// Integer, 2: layers of faces around each that get the size it asks for by its indicator, 0 to 1000.
        BufferLayers = AMST_OPT_BUFFER_LAYERS,
        /// Real, 0.0: least size of an indicator, a length.
        MinEdge = AMST_OPT_MIN_EDGE,
        /// Real, 0.0: largest one; 0: the extent of the mesh.
        MaxEdge = AMST_OPT_MAX_EDGE,
        /// Real, 0.2: growth of sizes of an indicator over the length that they grow in, 0.01 to 100.
        Gradation = AMST_OPT_GRADATION,
        /// Real, 1.0: power of the edge length that an indicator is like, 0.1 to 16.
        ErrorOrder = AMST_OPT_ERROR_ORDER,
    }
}

/// Numeric settings, all with defaults. `None` in place of them stands for all defaults.
///
/// Errors of the setters: `Range` (the value, see [`OptionKey`]), `NotFinite`.
///
/// ```
/// # use alphamst::{OptionKey, Options};
/// let options = Options::new().seed(7).smooth_steps(40)?.patch_faces(80.0)?;
/// assert_eq!(options.get_int(OptionKey::SmoothSteps)?, 40);
/// # Ok::<(), alphamst::Error>(())
/// ```
pub struct Options(NonNull<sys::amst_options>);

// SAFETY: options belong to no context, and borrowing keeps questions and changes apart.
unsafe impl Send for Options {}
unsafe impl Sync for Options {}

impl Drop for Options {
    fn drop(&mut self) {
        // SAFETY: the handle is destroyed here only.
        unsafe { sys::amst_options_destroy(self.0.as_ptr()) }
    }
}

/// NULL for none.
pub(crate) fn raw(options: Option<&Options>) -> *const sys::amst_options {
    options.map_or(ptr::null(), |options| options.0.as_ptr())
}

impl Options {
    /// All defaults.
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().get_real(OptionKey::MinConvexity)?, 0.6);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    #[must_use]
    pub fn new() -> Self {
        // SAFETY: the output is written through a valid pointer.
        Self(must(create(|out| unsafe { sys::amst_options_create(out) })))
    }

    /// Sets [`OptionKey::Seed`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().seed(-3).get_int(OptionKey::Seed)?, -3);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    #[must_use]
    pub fn seed(self, seed: i64) -> Self {
        must(self.with_int(OptionKey::Seed, seed))
    }

    /// Sets [`OptionKey::SmoothSteps`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options, Status};
    /// assert_eq!(Options::new().smooth_steps(5)?.get_int(OptionKey::SmoothSteps)?, 5);
    /// assert_eq!(Options::new().smooth_steps(1001).unwrap_err().status, Status::Range);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn smooth_steps(self, steps: i64) -> Result<Self> {
        self.with_int(OptionKey::SmoothSteps, steps)
    }

    /// Sets [`OptionKey::RepairPatches`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().repair_patches(false).get_int(OptionKey::RepairPatches)?, 0);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    #[must_use]
    pub fn repair_patches(self, repair: bool) -> Self {
        must(self.with_int(OptionKey::RepairPatches, repair.into()))
    }

    /// Sets [`OptionKey::Candidates`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().candidates(3)?.get_int(OptionKey::Candidates)?, 3);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn candidates(self, n: i64) -> Result<Self> {
        self.with_int(OptionKey::Candidates, n)
    }

    /// Sets [`OptionKey::NodeLimit`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().node_limit(50)?.get_int(OptionKey::NodeLimit)?, 50);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn node_limit(self, quads: i64) -> Result<Self> {
        self.with_int(OptionKey::NodeLimit, quads)
    }

    /// Sets [`OptionKey::Quadrangulate`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().quadrangulate(1)?.get_int(OptionKey::Quadrangulate)?, 1);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn quadrangulate(self, how: i64) -> Result<Self> {
        self.with_int(OptionKey::Quadrangulate, how)
    }

    /// Sets [`OptionKey::EditBoundary`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().edit_boundary(true).get_int(OptionKey::EditBoundary)?, 1);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    #[must_use]
    pub fn edit_boundary(self, edit: bool) -> Self {
        must(self.with_int(OptionKey::EditBoundary, edit.into()))
    }

    /// Sets [`OptionKey::Strategy`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().strategy(1)?.get_int(OptionKey::Strategy)?, 1);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn strategy(self, strategy: i64) -> Result<Self> {
        self.with_int(OptionKey::Strategy, strategy)
    }

    /// Sets [`OptionKey::Align`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().align(true).get_int(OptionKey::Align)?, 1);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    #[must_use]
    pub fn align(self, align: bool) -> Self {
        must(self.with_int(OptionKey::Align, align.into()))
    }

    /// Sets [`OptionKey::KeepBoundary`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().keep_boundary(true).get_int(OptionKey::KeepBoundary)?, 1);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    #[must_use]
    pub fn keep_boundary(self, keep_boundary: bool) -> Self {
        must(self.with_int(OptionKey::KeepBoundary, keep_boundary.into()))
    }

    /// Sets [`OptionKey::Starts`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().starts(4)?.get_int(OptionKey::Starts)?, 4);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn starts(self, searches: i64) -> Result<Self> {
        self.with_int(OptionKey::Starts, searches)
    }

    /// Sets [`OptionKey::Chart`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options, Status};
    /// assert_eq!(Options::new().chart(2)?.get_int(OptionKey::Chart)?, 2);
    /// assert_eq!(Options::new().chart(4).unwrap_err().status, Status::Range);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn chart(self, map: i64) -> Result<Self> {
        self.with_int(OptionKey::Chart, map)
    }

    /// Edges of a new mesh, by their vertices, that no pair of triangles crosses, instead of those set before.
    /// A mesh is not made, with `NotFound`, if one of them is no side of its faces.
    ///
    /// ```
    /// # use alphamst::{Options, VertexId};
    /// let diagonal = [VertexId::new(0), VertexId::new(2)];
    /// assert_eq!(Options::new().edges(&[diagonal]).get_edges(), [diagonal]);
    /// ```
    #[must_use]
    pub fn edges(self, edges: &[[VertexId; 2]]) -> Self {
        // SAFETY: a VertexId is an id of the library, and the slice has two of them for each edge.
        must(check(unsafe {
            sys::amst_options_set_edges(self.0.as_ptr(), edges.as_ptr().cast(), edges.len() as i64)
        }));
        self
    }

    /// The edges that were set.
    #[must_use]
    pub fn get_edges(&self) -> Vec<[VertexId; 2]> {
        // SAFETY: rows of two ids, of which the library says how many there are.
        must(unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_options_get_edges(self.0.as_ptr(), out, capacity, needed)
            })
        })
    }

    /// Sets [`OptionKey::MinQuality`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().min_quality(0.2)?.get_real(OptionKey::MinQuality)?, 0.2);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn min_quality(self, scaled_jacobian: f64) -> Result<Self> {
        self.with_real(OptionKey::MinQuality, scaled_jacobian)
    }

    /// Sets [`OptionKey::MinConvexity`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().min_convexity(0.9)?.get_real(OptionKey::MinConvexity)?, 0.9);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn min_convexity(self, convexity: f64) -> Result<Self> {
        self.with_real(OptionKey::MinConvexity, convexity)
    }

    /// Sets [`OptionKey::PatchFaces`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().patch_faces(12.5)?.get_real(OptionKey::PatchFaces)?, 12.5);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn patch_faces(self, faces: f64) -> Result<Self> {
        self.with_real(OptionKey::PatchFaces, faces)
    }

    /// Sets [`OptionKey::Tolerance`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().tolerance(0.2)?.get_real(OptionKey::Tolerance)?, 0.2);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn tolerance(self, edges: f64) -> Result<Self> {
        self.with_real(OptionKey::Tolerance, edges)
    }

    /// Sets [`OptionKey::Effort`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().effort(4.0)?.get_real(OptionKey::Effort)?, 4.0);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn effort(self, times: f64) -> Result<Self> {
        self.with_real(OptionKey::Effort, times)
    }

    /// Sets [`OptionKey::SizeWeight`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().size_weight(0.3)?.get_real(OptionKey::SizeWeight)?, 0.3);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn size_weight(self, weight: f64) -> Result<Self> {
        self.with_real(OptionKey::SizeWeight, weight)
    }

    /// Sets [`OptionKey::Transition`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options, Status};
    /// assert_eq!(Options::new().transition(0.25)?.get_real(OptionKey::Transition)?, 0.25);
    /// assert_eq!(Options::new().transition(0.01).unwrap_err().status, Status::Range);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn transition(self, part: f64) -> Result<Self> {
        self.with_real(OptionKey::Transition, part)
    }

    /// Sets [`OptionKey::LeastSize`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().least_size(0.25)?.get_real(OptionKey::LeastSize)?, 0.25);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn least_size(self, ratio: f64) -> Result<Self> {
        self.with_real(OptionKey::LeastSize, ratio)
    }

    /// Sets [`OptionKey::SharpAngle`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().sharp_angle(25.0)?.get_real(OptionKey::SharpAngle)?, 25.0);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn sharp_angle(self, degrees: f64) -> Result<Self> {
        self.with_real(OptionKey::SharpAngle, degrees)
    }

    /// Sets [`OptionKey::SizeBand`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().size_band(0.5)?.get_real(OptionKey::SizeBand)?, 0.5);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn size_band(self, log2_of_area: f64) -> Result<Self> {
        self.with_real(OptionKey::SizeBand, log2_of_area)
    }

    /// Sets [`OptionKey::BufferLayers`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().buffer_layers(5)?.get_int(OptionKey::BufferLayers)?, 5);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn buffer_layers(self, layers: i64) -> Result<Self> {
        self.with_int(OptionKey::BufferLayers, layers)
    }

    /// Sets [`OptionKey::MinEdge`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().min_edge(0.5)?.get_real(OptionKey::MinEdge)?, 0.5);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn min_edge(self, length: f64) -> Result<Self> {
        self.with_real(OptionKey::MinEdge, length)
    }

    /// Sets [`OptionKey::MaxEdge`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().max_edge(7.0)?.get_real(OptionKey::MaxEdge)?, 7.0);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn max_edge(self, length: f64) -> Result<Self> {
        self.with_real(OptionKey::MaxEdge, length)
    }

    /// Sets [`OptionKey::Gradation`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().gradation(0.3)?.get_real(OptionKey::Gradation)?, 0.3);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn gradation(self, growth: f64) -> Result<Self> {
        self.with_real(OptionKey::Gradation, growth)
    }

    /// Sets [`OptionKey::ErrorOrder`].
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().error_order(2.0)?.get_real(OptionKey::ErrorOrder)?, 2.0);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn error_order(self, power: f64) -> Result<Self> {
        self.with_real(OptionKey::ErrorOrder, power)
    }

    /// Sets an integer, by key or by the number of one that this crate does not know.
    ///
    /// Errors: also `NotFound` (a real's key, or one unknown to the library).
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options, Status};
    /// let mut options = Options::new();
    /// options.set_int(OptionKey::Seed, 7)?;
    /// assert_eq!(options.set_int(999, 7).unwrap_err().status, Status::NotFound);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn set_int(&mut self, key: impl Into<i32>, value: i64) -> Result<()> {
        // SAFETY: the handle is valid and borrowed alone.
        check(unsafe { sys::amst_options_set_int(self.0.as_ptr(), key.into(), value) })
    }

    /// Sets a real, likewise.
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options, Status};
    /// let error = Options::new().set_real(OptionKey::MinQuality, f64::NAN).unwrap_err();
    /// assert_eq!(error.status, Status::NotFinite);
    /// ```
    pub fn set_real(&mut self, key: impl Into<i32>, value: f64) -> Result<()> {
        // SAFETY: as above.
        check(unsafe { sys::amst_options_set_real(self.0.as_ptr(), key.into(), value) })
    }

    /// An integer. Errors: `NotFound`.
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().get_int(OptionKey::Candidates)?, 16);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn get_int(&self, key: impl Into<i32>) -> Result<i64> {
        // SAFETY: the handle is valid, the output is written through a valid pointer.
        value(|out| unsafe { sys::amst_options_get_int(self.0.as_ptr(), key.into(), out) })
    }

    /// A real. Errors: `NotFound`.
    ///
    /// ```
    /// # use alphamst::{OptionKey, Options};
    /// assert_eq!(Options::new().get_real(OptionKey::PatchFaces)?, 100.0);
    /// # Ok::<(), alphamst::Error>(())
    /// ```
    pub fn get_real(&self, key: impl Into<i32>) -> Result<f64> {
        // SAFETY: as above.
        value(|out| unsafe { sys::amst_options_get_real(self.0.as_ptr(), key.into(), out) })
    }

    fn with_int(mut self, key: OptionKey, value: i64) -> Result<Self> {
        self.set_int(key, value)?;
        Ok(self)
    }

    fn with_real(mut self, key: OptionKey, value: f64) -> Result<Self> {
        self.set_real(key, value)?;
        Ok(self)
    }
}

impl Default for Options {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Debug for Options {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("Options");
        for key in [OptionKey::Seed, OptionKey::SmoothSteps, OptionKey::Candidates] {
            shown.field(&format!("{key:?}"), &self.get_int(key));
        }
        shown.finish_non_exhaustive()
    }
}
