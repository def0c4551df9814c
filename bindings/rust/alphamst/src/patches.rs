use std::fmt;
use std::path::Path;
use std::ptr::NonNull;
use std::sync::Arc;

use alphamst_sys as sys;

use crate::context::Shared;
use crate::enumeration::enumeration;
use crate::error::{check, create, must, value};
use crate::mesh::utf8;
use crate::{array, options, FaceId, Mesh, Options, Patch, PatchId, Result, VertexId};

enumeration! {
    /// How [`Patches::decompose`] makes patches.
    Decomposition {
        /// Compact clusters of faces (Lloyd).
        Clusters = AMST_DECOMPOSE_CLUSTERS,
        /// Balanced partition of the graph.
        Partition = AMST_DECOMPOSE_PARTITION,
        /// Geodesic Voronoi cells of faces far from one another.
        Voronoi = AMST_DECOMPOSE_VORONOI,
        /// Discs: faces within the largest inscribed circles. Not every face is in one.
        Medial = AMST_DECOMPOSE_MEDIAL,
        /// Faces around singular vertices that lie together; no others.
        Singularities = AMST_DECOMPOSE_SINGULARITIES,
    }
}

/// Disjoint patches of one revision of one mesh. Operations given the patches move them along to the
/// new revision; other changes of the mesh make them `Stale`.
///
/// Faces that an earlier patch has, or that are [`FIXED`](crate::Flags::FIXED), are left out of a new
/// one; [`OptionKey::RepairPatches`](crate::OptionKey::RepairPatches) then makes it a disk if it can.
///
/// Errors of all calls but [`new`](Patches::new) and those that count: `Stale`, `Range` (patch, face,
/// vertex, count), and of changes `State` (in a callback). Of those that add a patch also: `Patch` (no
/// face would be left), `NotFinite`.
pub struct Patches {
    raw: NonNull<sys::amst_patches>,
    shared: Arc<Shared>,
}

// SAFETY: they read their mesh, so every call takes the context's turn; destroying is allowed at any
// time.
unsafe impl Send for Patches {}
unsafe impl Sync for Patches {}

impl Drop for Patches {
    fn drop(&mut self) {
        // SAFETY: the handle is destroyed here only.
        unsafe { sys::amst_patches_destroy(self.raw.as_ptr()) }
    }
}

impl Patches {
    /// No patches yet. The options that count are `RepairPatches`, `PatchFaces`, `MinConvexity` and
    /// `Seed`; they are copied.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert!(Patches::new(&mesh, &Options::new().patch_faces(20.0)?).is_empty());
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn new<'a>(mesh: &Mesh, options: impl Into<Option<&'a Options>>) -> Self {
        let options = options::raw(options.into());
        // SAFETY, here and below: the handles are valid, and ours alone for a call that changes them;
        // outputs are written through valid pointers.
        let raw =
            must(mesh.ask(|mesh| create(|out| unsafe { sys::amst_patches_create(mesh, options, out) })));
        Self { raw, shared: Arc::clone(&mesh.shared) }
    }

    /// A patch of these faces, in any order; repetitions do not count. Without `RepairPatches` a face
    /// that is taken or fixed is an error, `Patch`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_faces(&[5, 6, 9, 10].map(FaceId::new))?;
    /// assert_eq!(patches.patch(patch)?.faces()?, [5, 6, 9, 10].map(FaceId::new));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn add_faces(&mut self, faces: &[FaceId]) -> Result<PatchId> {
        let (first, n) = (faces.as_ptr().cast(), faces.len() as i64);
        self.add(|set, patch| unsafe { sys::amst_patches_add_faces(set, first, n, patch) })
    }

    /// A patch of the faces within `rings` face layers of a vertex; 1: the faces at it.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(12), 2)?;
    /// assert_eq!(patches.patch(patch)?.faces()?.len(), 16);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn add_rings(&mut self, vertex: VertexId, rings: i32) -> Result<PatchId> {
        self.add(|set, patch| unsafe { sys::amst_patches_add_rings(set, vertex.into(), rings, patch) })
    }

    /// A patch of the connected faces around the one nearest to `center` whose centroid is within
    /// `radius`, at least 0. A mesh of dim 2 lies in the plane z = 0.
    ///
    /// Errors: also `Argument` (radius).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_ball([2., 2., 0.], 1.0)?;
    /// assert_eq!(patches.patch(patch)?.faces()?.len(), 4);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn add_ball(&mut self, center: [f64; 3], radius: f64) -> Result<PatchId> {
        self.add(|set, patch| unsafe { sys::amst_patches_add_ball(set, center.as_ptr(), radius, patch) })
    }

    /// A patch of the faces with their centroid in the box, the largest connected part of them.
    ///
    /// Errors: also `Argument` (low above high).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_box([0., 0., 0.], [2., 3., 0.])?;
    /// assert_eq!(patches.patch(patch)?.faces()?.len(), 6);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn add_box(&mut self, low: [f64; 3], high: [f64; 3]) -> Result<PatchId> {
        self.add(|set, patch| unsafe { sys::amst_patches_add_box(set, low.as_ptr(), high.as_ptr(), patch) })
    }

    /// Patches of about `PatchFaces` faces over the faces not yet taken; tells how many.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, &Options::new().patch_faces(8.0)?);
    /// assert_eq!(patches.decompose(Decomposition::Partition)?, patches.len());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn decompose(&mut self, method: Decomposition) -> Result<usize> {
        self.change(|set| value(|added| unsafe { sys::amst_patches_decompose(set, method.into(), added) }))
            .map(array::count)
    }

    /// 3 to 6 boundary vertices of a patch in boundary order, counter-clockwise; none lets the library
    /// choose. Whether they are that is told by [`Patch::check`].
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(12), 1)?;
    /// let corners = [6, 8, 18].map(VertexId::new);
    /// patches.set_corners(patch, &corners)?;
    /// assert_eq!(patches.patch(patch)?.corners()?, corners);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_corners(&mut self, patch: PatchId, vertices: &[VertexId]) -> Result<()> {
        let (first, n) = (vertices.as_ptr().cast(), vertices.len() as i64);
        self.change(|set| check(unsafe { sys::amst_patches_set_corners(set, patch.into(), first, n) }))
    }

    /// alpha of one patch; 0 means that of the operation.
    ///
    /// Errors: also `Argument` (alpha below 0), `NotFinite`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(12), 2)?;
    /// patches.set_alpha(patch, 2.0)?;
    /// mesh.adapt(&mut patches, 1.0, None)?;
    /// assert_eq!(mesh.n_faces(), 32);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_alpha(&mut self, patch: PatchId, alpha: f64) -> Result<()> {
        self.change(|set| check(unsafe { sys::amst_patches_set_alpha(set, patch.into(), alpha) }))
    }

    /// alpha of all patches there are now, likewise.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// patches.add_rings(VertexId::new(12), 2)?;
    /// patches.set_all_alphas(2.0)?;
    /// mesh.adapt(&mut patches, 1.0, None)?;
    /// assert_eq!(mesh.n_faces(), 32);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_all_alphas(&mut self, alpha: f64) -> Result<()> {
        self.change(|set| check(unsafe { sys::amst_patches_set_alpha(set, sys::AMST_ALL, alpha) }))
    }

    /// Number of patches.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// patches.add_rings(VertexId::new(12), 1)?;
    /// assert_eq!(patches.len(), 1);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn len(&self) -> usize {
        array::count(must(self.ask(|set| value(|count| unsafe { sys::amst_patches_get_count(set, count) }))))
    }

    /// Whether there is no patch.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert!(Patches::new(&mesh, None).is_empty());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One patch. Errors: `Range`, `Stale`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let patches = Patches::new(&mesh, None);
    /// assert_eq!(patches.patch(PatchId::new(0)).unwrap_err().status, Status::Range);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn patch(&self, id: PatchId) -> Result<Patch<'_>> {
        Patch::of(self, id)
    }

    /// All patches.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// patches.add_rings(VertexId::new(6), 1)?;
    /// patches.add_rings(VertexId::new(18), 1)?;
    /// for patch in patches.iter() {
    ///     assert_eq!(patch.faces()?.len(), 4);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Patch<'_>> {
        (0..self.len()).map(|p| Patch::at(self, p))
    }

    /// Writes a picture (.svg) of the mesh with the patch outlines and the singularities; a failure
    /// leaves no half-written file.
    ///
    /// Errors: also `Io`, `Unsupported` (extension), `Argument` (a path that is not UTF-8).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let path = std::env::temp_dir().join("alphamst_patches_doc.svg");
    /// Patches::new(&mesh, None).write(&path)?;
    /// assert!(std::fs::read_to_string(&path).unwrap().contains("<svg"));
    /// # std::fs::remove_file(path).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    pub fn write(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = utf8(path.as_ref())?;
        self.ask(|set| check(unsafe { sys::amst_patches_write(set, path.as_ptr()) }))
    }

    pub(crate) fn raw(&self) -> *mut sys::amst_patches {
        self.raw.as_ptr()
    }

    pub(crate) fn ask<R>(&self, call: impl FnOnce(*const sys::amst_patches) -> R) -> R {
        self.shared.turn.ask(|| call(self.raw()))
    }

    fn change<R>(&mut self, call: impl FnOnce(*mut sys::amst_patches) -> R) -> R {
        self.shared.turn.change(|| call(self.raw()))
    }

    fn add(&mut self, call: impl FnOnce(*mut sys::amst_patches, *mut i32) -> i32) -> Result<PatchId> {
        self.change(|set| value(|patch| call(set, patch))).map(PatchId::new)
    }
}

impl fmt::Debug for Patches {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Patches").field("len", &self.len()).finish_non_exhaustive()
    }
}
