use crate::enumeration::enumeration;

enumeration! {
    /// What a mesh is made of.
    ///
    /// ```
    /// # use alphamst::Entity;
    /// assert_eq!(Entity::try_from(2), Ok(Entity::Face));
    /// ```
    Entity {
        /// A point of the mesh.
        Vertex = AMST_VERTEX,
        /// A side of a face.
        Edge = AMST_EDGE,
        /// A quadrilateral.
        Face = AMST_FACE,
    }
}

/// The number of a vertex, edge or face. Only this crate implements it.
pub trait EntityId: Copy + sealed::Sealed {
    /// What is numbered.
    const ENTITY: Entity;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! id {
    ($name:ident, $what:literal) => {
        #[doc = concat!("The number of a ", $what, ", counted from 0.")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(transparent)]
        pub struct $name(i32);

        impl $name {
            #[doc = concat!("The ", $what, " of this number. Whether there is one is told where it is used.")]
            ///
            /// ```
            #[doc = concat!("# use alphamst::", stringify!($name), ";")]
            #[doc = concat!("assert!(", stringify!($name), "::new(1) < ", stringify!($name), "::new(2));")]
            /// ```
            pub const fn new(number: i32) -> Self {
                Self(number)
            }

            /// The number, to index with. Panics if it is negative, which no id of the library is.
            ///
            /// ```
            #[doc = concat!("# use alphamst::", stringify!($name), ";")]
            #[doc = concat!("assert_eq!(", stringify!($name), "::new(3).index(), 3);")]
            /// ```
            pub fn index(self) -> usize {
                usize::try_from(self.0).expect("a negative id")
            }

            /// The id, unless it is the library's "none".
            #[allow(dead_code)]
            pub(crate) fn some(number: i32) -> Option<Self> {
                (number >= 0).then_some(Self(number))
            }
        }

        impl From<i32> for $name {
            fn from(number: i32) -> Self {
                Self(number)
            }
        }

        impl From<$name> for i32 {
            fn from(id: $name) -> i32 {
                id.0
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.0.fmt(f)
            }
        }
    };
    ($name:ident, $what:literal, $entity:ident) => {
        id!($name, $what);

        impl sealed::Sealed for $name {}
        impl EntityId for $name {
            const ENTITY: Entity = Entity::$entity;
        }
    };
}

id!(VertexId, "vertex", Vertex);
id!(EdgeId, "edge", Edge);
id!(FaceId, "face", Face);
id!(PatchId, "patch");
