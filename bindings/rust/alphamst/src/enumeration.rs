use std::{error, fmt};

/// A number that is none of an enumeration's: a newer library may have more of them.
///
/// ```
/// # use alphamst::{Metric, UnknownValue};
/// assert_eq!(Metric::try_from(1234), Err(UnknownValue(1234)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownValue(pub i32);

impl fmt::Display for UnknownValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is no value of this enumeration", self.0)
    }
}

impl error::Error for UnknownValue {}

/// An enumeration of the header, with conversions from and to its numbers.
macro_rules! enumeration {
    ($(#[$about:meta])* $name:ident { $($(#[$what:meta])* $variant:ident = $constant:ident,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[repr(i32)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$what])* $variant = alphamst_sys::$constant,)+
        }

        impl TryFrom<i32> for $name {
            type Error = $crate::UnknownValue;

            fn try_from(value: i32) -> Result<Self, $crate::UnknownValue> {
                match value {
                    $(alphamst_sys::$constant => Ok(Self::$variant),)+
                    _ => Err($crate::UnknownValue(value)),
                }
            }
        }

        impl From<$name> for i32 {
            fn from(value: $name) -> i32 {
                value as i32
            }
        }
    };
}
pub(crate) use enumeration;
