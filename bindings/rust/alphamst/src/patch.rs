use alphamst_sys as sys;

use crate::error::check;
use crate::{array, options, Defects, FaceId, Options, PatchId, Patches, Result, VertexId};

/// One patch of [`Patches`]. Errors of all its calls: `Stale`.
#[derive(Clone, Copy, Debug)]
pub struct Patch<'a> {
    set: &'a Patches,
    id: PatchId,
}

/// What [`Mesh::adapt`](crate::Mesh::adapt) would deliver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Prediction {
    /// Number of faces.
    pub faces: usize,
    /// Number of interior singularities.
    pub singularities: usize,
}

impl<'a> Patch<'a> {
    pub(crate) fn of(set: &'a Patches, id: PatchId) -> Result<Self> {
        // SAFETY, here and below: the handle is valid, nobody changes the patches or their mesh during
        // the call; outputs are written through valid pointers.
        set.ask(|set| {
            let mut n = 0;
            check(unsafe { sys::amst_patches_get_faces(set, id.into(), std::ptr::null_mut(), 0, &mut n) })
        })?;
        Ok(Self { set, id })
    }

    pub(crate) fn at(set: &'a Patches, index: usize) -> Self {
        Self { set, id: PatchId::new(index as i32) }
    }

    /// Its number.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(12), 1)?;
    /// assert_eq!(patches.patch(patch)?.id(), patch);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn id(&self) -> PatchId {
        self.id
    }

    /// Its faces, ascending.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(6), 1)?;
    /// assert_eq!(patches.patch(patch)?.faces()?, [0, 1, 4, 5].map(FaceId::new));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn faces(&self) -> Result<Vec<FaceId>> {
        self.set.ask(|set| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_patches_get_faces(set, self.id.into(), out, capacity, needed)
            })
        })
    }

    /// Its boundary vertices, counter-clockwise, from the first corner.
    ///
    /// Errors: also `Patch` (not a disk).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_faces(&[FaceId::new(5)])?;
    /// let mut boundary = patches.patch(patch)?.boundary()?;
    /// boundary.sort();
    /// assert_eq!(boundary, [6, 7, 11, 12].map(VertexId::new));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn boundary(&self) -> Result<Vec<VertexId>> {
        self.set.ask(|set| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_patches_get_boundary(set, self.id.into(), out, capacity, needed)
            })
        })
    }

    /// The corners that were set; otherwise the boundary vertices where one face fits.
    ///
    /// Errors: also `Patch` (not a disk).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(12), 1)?;
    /// assert_eq!(patches.patch(patch)?.corners()?.len(), 4);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn corners(&self) -> Result<Vec<VertexId>> {
        self.set.ask(|set| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_patches_get_corners(set, self.id.into(), out, capacity, needed)
            })
        })
    }

    /// Its defects, none if it is usable, and its convexity: the area over that of the convex hull, 1
    /// for a convex patch, 0 if it is no disk.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(12), 1)?;
    /// let (defects, convexity) = patches.patch(patch)?.check()?;
    /// assert!(defects.is_empty() && (convexity - 1.0).abs() < 1e-12);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn check(&self) -> Result<(Defects, f64)> {
        let (mut defects, mut convexity) = (0, 0.0);
        self.set.ask(|set| {
            check(unsafe { sys::amst_patches_check(set, self.id.into(), &mut defects, &mut convexity) })
        })?;
        Ok((Defects::from_bits(defects), convexity))
    }

    /// What would come of it for that alpha, without doing it.
    ///
    /// Errors: also `Argument` (alpha, which must be above 0), `NotFinite`, `Patch`, `NoFilling`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// let patch = patches.add_rings(VertexId::new(12), 2)?;
    /// let prediction = patches.patch(patch)?.predict(1.0, None)?;
    /// assert_eq!(prediction, Prediction { faces: 16, singularities: 0 });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn predict<'o>(&self, alpha: f64, options: impl Into<Option<&'o Options>>) -> Result<Prediction> {
        let options = options::raw(options.into());
        let (mut faces, mut singular) = (0, 0);
        self.set.ask(|set| {
            let patch = self.id.into();
            check(unsafe { sys::amst_patches_predict(set, patch, alpha, options, &mut faces, &mut singular) })
        })?;
        Ok(Prediction { faces: array::count(faces), singularities: array::count(singular) })
    }
}
