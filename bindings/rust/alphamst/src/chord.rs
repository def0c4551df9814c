use alphamst_sys as sys;

use crate::enumeration::enumeration;
use crate::error::must;
use crate::{array, options, EdgeId, Mesh, Options, Patches, Report, Result};

/// The row of faces met when each is left through the edge opposite to the one it was entered by.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Chord {
    /// The edges it crosses, in order.
    pub edges: Vec<EdgeId>,
    /// Whether the last face leads back to the first edge; else it goes from boundary to boundary.
    pub closed: bool,
    /// Faces it passes twice.
    pub crossings: usize,
}

enumeration! {
    /// What [`Mesh::chords`] tells of each chord.
    ChordProperty {
        /// Its smallest edge.
        Edge = AMST_CHORD_EDGE,
        /// 1: cyclic, 0: from boundary to boundary.
        Closed = AMST_CHORD_CLOSED,
        /// Faces it passes, those passed twice counted twice.
        Length = AMST_CHORD_LENGTH,
        /// The same, counted once.
        Faces = AMST_CHORD_FACES,
        /// Faces where it crosses itself.
        Crossings = AMST_CHORD_CROSSINGS,
        /// Vertices at more than one of its edges.
        Touches = AMST_CHORD_TOUCHES,
        /// Singular vertices at its edges.
        Singularities = AMST_CHORD_SINGULARITIES,
        /// Bits of [`Refusals`](crate::Refusals) of its collapse; 0: it can be collapsed.
        Refusal = AMST_CHORD_REFUSAL,
        /// Singular vertices of the mesh once it is collapsed; now, if it cannot be.
        SingularAfter = AMST_CHORD_SINGULAR_AFTER,
    }
}

// SAFETY, throughout: the handles are valid, those that change are ours alone; ids are int32_t.

/// Chords. Each edge is on one of them; their lengths sum up to twice the faces.
impl Mesh {
    /// The chord through an edge: from that edge round if it is closed, else from its end with the
    /// smaller edge.
    ///
    /// Errors: `Range`.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let chord = mesh.chord(EdgeId::new(0))?;
    /// assert_eq!((chord.edges.len(), chord.closed, chord.crossings), (5, false, 0));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn chord(&self, edge: EdgeId) -> Result<Chord> {
        let (closed, crossings) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
        let edges = self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                let (closed, crossings) = (closed.as_ptr(), crossings.as_ptr());
                sys::amst_mesh_get_chord(mesh, edge.into(), closed, crossings, out, capacity, needed)
            })
        })?;
        Ok(Chord { edges, closed: closed.get() != 0, crossings: array::count(crossings.get()) })
    }

    /// The number of the chord of each edge, and how many chords there are. They are numbered in the
    /// order of their smallest edges. As an edge field "chord" they are drawn in colour by
    /// [`write`](Mesh::write).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let (ids, n_chords) = mesh.chord_ids();
    /// assert_eq!((ids.len(), n_chords), (40, 8));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn chord_ids(&self) -> (Vec<i32>, usize) {
        let n_chords = std::cell::Cell::new(0);
        let ids = must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_chord_ids(mesh, n_chords.as_ptr(), out, capacity, needed)
            })
        }));
        (ids, array::count(n_chords.get()))
    }

    /// A property of each chord. Of the options [`edit_boundary`](Options::edit_boundary) counts.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.chords(ChordProperty::Length, None), [4; 8]);
    /// let refusals = mesh.chords(ChordProperty::Refusal, None);
    /// assert_eq!(refusals, [i64::from(Refusals::BOUNDARY.bits()); 8]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn chords<'a>(&self, property: ChordProperty, options: impl Into<Option<&'a Options>>) -> Vec<i64> {
        let options = options::raw(options.into());
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i64, capacity, needed| {
                sys::amst_mesh_get_chords(mesh, property.into(), options, out, capacity, needed)
            })
        }))
    }

    /// Removes the chord through an edge: the two ends of each of its edges become one vertex. The faces
    /// around it are smoothed.
    ///
    /// Errors: `Range`, `Chord` (it cannot be; the message has the reason), `Geometry`, and those of all
    /// operations.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.collapse_chord(EdgeId::new(0), None).unwrap_err().status, Status::Chord);
    /// let options = Options::new().edit_boundary(true);
    /// mesh.collapse_chord(EdgeId::new(0), &options)?;
    /// assert_eq!(mesh.n_faces(), 12);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn collapse_chord<'a>(
        &mut self,
        edge: EdgeId,
        options: impl Into<Option<&'a Options>>,
    ) -> Result<Report> {
        let options = options::raw(options.into());
        self.operate(0, |mesh, report| unsafe {
            sys::amst_collapse_chord(mesh, edge.into(), options, report)
        })
    }

    /// Cuts the chord through an edge into n + 1 parallel ones; no vertex becomes singular.
    ///
    /// Errors: `Range` (also n below 1), `Chord`, `Geometry`, and those of all operations.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let options = Options::new().edit_boundary(true);
    /// mesh.split_chord(EdgeId::new(0), 2, &options)?;
    /// assert_eq!(mesh.n_faces(), 24);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn split_chord<'a>(
        &mut self,
        edge: EdgeId,
        n: i32,
        options: impl Into<Option<&'a Options>>,
    ) -> Result<Report> {
        let options = options::raw(options.into());
        self.operate(0, |mesh, report| unsafe {
            sys::amst_split_chord(mesh, edge.into(), n, options, report)
        })
    }

    /// Lays n closed chords around the core of each patch: rings between its boundary, which stays, and
    /// its faces. A patch needs 3 to 6 corners (boundary vertices with one of its faces), or none, and two
    /// of its faces at all other boundary vertices; others are left.
    ///
    /// Errors: `Range` (n), and those of all operations.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut patches = Patches::new(&mesh, None);
    /// patches.add_box([0.; 3], [4., 4., 0.])?;
    /// mesh.insert_chords(&mut patches, 1, None)?;
    /// assert_eq!((mesh.n_faces(), mesh.singularities().len()), (32, 4));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn insert_chords<'a>(
        &mut self,
        patches: &mut Patches,
        n: i32,
        options: impl Into<Option<&'a Options>>,
    ) -> Result<Report> {
        let (set, n_patches) = (patches.raw(), patches.len());
        let options = options::raw(options.into());
        self.operate(n_patches, |mesh, report| unsafe {
            sys::amst_insert_chords(mesh, set, n, options, report)
        })
    }
}
