use alphamst_sys as sys;

use crate::error::{check, must, value};
use crate::{array, Entity, EntityId, Mesh, Result};

macro_rules! bits {
    ($(#[$about:meta])* $name:ident { $($(#[$what:meta])* $bit:ident = $constant:ident,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        #[repr(transparent)]
        pub struct $name(i32);

        impl $name {
            /// No bit.
            pub const NONE: Self = Self(0);
            $($(#[$what])* pub const $bit: Self = Self(sys::$constant);)+

            /// The set of these bits, known ones or not.
            ///
            /// ```
            #[doc = concat!("# use alphamst::", stringify!($name), ";")]
            #[doc = concat!("assert_eq!(", stringify!($name), "::from_bits(0), ", stringify!($name), "::NONE);")]
            /// ```
            pub const fn from_bits(bits: i32) -> Self {
                Self(bits)
            }

            /// The bits as the library has them.
            ///
            /// ```
            #[doc = concat!("# use alphamst::", stringify!($name), ";")]
            #[doc = concat!("assert_eq!(", stringify!($name), "::from_bits(5).bits(), 5);")]
            /// ```
            pub const fn bits(self) -> i32 {
                self.0
            }

            /// Whether all bits of `other` are here.
            ///
            /// ```
            #[doc = concat!("# use alphamst::", stringify!($name), ";")]
            #[doc = concat!("let three = ", stringify!($name), "::from_bits(3);")]
            #[doc = concat!("assert!(three.contains(", stringify!($name), "::from_bits(2)));")]
            #[doc = concat!("assert!(!three.contains(", stringify!($name), "::from_bits(6)));")]
            /// ```
            pub const fn contains(self, other: Self) -> bool {
                self.0 & other.0 == other.0
            }

            /// Whether there is no bit.
            ///
            /// ```
            #[doc = concat!("# use alphamst::", stringify!($name), ";")]
            #[doc = concat!("assert!(", stringify!($name), "::NONE.is_empty());")]
            /// ```
            pub const fn is_empty(self) -> bool {
                self.0 == 0
            }
        }

        impl std::ops::BitOr for $name {
            type Output = Self;

            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }
    };
}

bits! {
    /// What is asked of operations for one vertex, edge or face; combine with `|`.
    Flags {
        /// Neither moved, split nor removed.
        FIXED = AMST_FLAG_FIXED,
        /// On a curve that must survive; may slide along it.
        FEATURE = AMST_FLAG_FEATURE,
        /// End or crossing of such curves; does not move.
        CORNER = AMST_FLAG_CORNER,
    }
}

bits! {
    /// Why a patch cannot be adapted, or a remark about it.
    Defects {
        /// No face.
        EMPTY = AMST_DEFECT_EMPTY,
        /// More than one piece.
        NOT_CONNECTED = AMST_DEFECT_NOT_CONNECTED,
        /// The Euler characteristic is not 1.
        NOT_DISK = AMST_DEFECT_NOT_DISK,
        /// The boundary touches itself.
        PINCHED = AMST_DEFECT_PINCHED,
        /// Shares a face with an earlier patch.
        OVERLAP = AMST_DEFECT_OVERLAP,
        /// A flagged entity or the border of a region is in the interior.
        CROSSES_FEATURE = AMST_DEFECT_CROSSES_FEATURE,
        /// An odd number of boundary edges.
        ODD_BOUNDARY = AMST_DEFECT_ODD_BOUNDARY,
        /// The given corners are not on the boundary, or not in its order.
        CORNERS = AMST_DEFECT_CORNERS,
        /// A remark only: the convexity is below the option.
        NOT_CONVEX = AMST_DEFECT_NOT_CONVEX,
    }
}

bits! {
    /// Why a chord cannot be collapsed.
    Refusals {
        /// It crosses itself: a face would become a point.
        CROSSING = AMST_REFUSAL_CROSSING,
        /// Its borders meet: no surface would be left between them.
        CLOSED = AMST_REFUSAL_CLOSED,
        /// It would join boundary vertices or, not allowed, change the boundary.
        BOUNDARY = AMST_REFUSAL_BOUNDARY,
        /// A fixed entity would go or move.
        FIXED = AMST_REFUSAL_FIXED,
        /// Two features, or two corners of one, would be merged.
        FEATURE = AMST_REFUSAL_FEATURE,
        /// A vertex would get a valence below 3 or above 6.
        VALENCE = AMST_REFUSAL_VALENCE,
        /// Two edges would have the same vertices, or a face one twice.
        DOUBLE = AMST_REFUSAL_DOUBLE,
    }
}

/// Flags.
impl Mesh {
    /// For the given vertices, edges or faces sets the bits in `mask` as they are in `value`. The
    /// revision stays.
    ///
    /// Errors: `Range` (id, bits that are no flag), `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_flags(&[VertexId::new(6)], Flags::FIXED, Flags::FIXED)?;
    /// assert_eq!(mesh.flags(Entity::Vertex)[6], Flags::FIXED);
    /// assert_eq!(mesh.flags(Entity::Face)[6], Flags::NONE);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_flags<I: EntityId>(&mut self, ids: &[I], mask: Flags, value: Flags) -> Result<()> {
        // An empty slice has a pointer too, so it is not taken for NULL, which stands for all.
        self.change(|mesh| unsafe {
            // SAFETY: ids are int32_t in every respect; the handle is ours alone.
            let (first, n) = (ids.as_ptr().cast(), ids.len() as i64);
            check(sys::amst_mesh_set_flags(mesh, I::ENTITY.into(), first, n, mask.bits(), value.bits()))
        })
    }

    /// The same for all vertices, edges or faces.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// mesh.set_all_flags(Entity::Edge, Flags::FEATURE, Flags::FEATURE)?;
    /// assert!(mesh.flags(Entity::Edge).iter().all(|flags| flags.contains(Flags::FEATURE)));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_all_flags(&mut self, entity: Entity, mask: Flags, value: Flags) -> Result<()> {
        // SAFETY: as above.
        self.change(|mesh| unsafe {
            let none = std::ptr::null();
            check(sys::amst_mesh_set_flags(mesh, entity.into(), none, 0, mask.bits(), value.bits()))
        })
    }

    /// Flags the edges whose two faces have normals more than `angle` degrees apart, 0 to 180, as
    /// [`Flags::FEATURE`], and as [`Flags::CORNER`] the vertices where curves of such edges, these and
    /// those of before, end, cross or turn by more than 60 degrees, but not right back. No flag is taken
    /// away; the revision stays. Tells the number of edges at more than `angle`.
    ///
    /// Errors: `NotFinite`, `Range` (angle), `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.detect_features(30.0)?, 0); // a plane has none
    /// # Ok::<(), Error>(())
    /// ```
    pub fn detect_features(&mut self, angle: f64) -> Result<usize> {
        // SAFETY: found is written through a valid pointer; the handle is ours alone.
        self.change(|mesh| value(|found| unsafe { sys::amst_mesh_detect_features(mesh, angle, found) }))
            .map(array::count)
    }

    /// The flags of every vertex, edge or face.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.flags(Entity::Edge).len(), 40);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn flags(&self, entity: Entity) -> Vec<Flags> {
        // SAFETY: Flags are an int32_t each.
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut i32, capacity, needed| {
                sys::amst_mesh_get_flags(mesh, entity.into(), out, capacity, needed)
            })
        }))
    }
}
