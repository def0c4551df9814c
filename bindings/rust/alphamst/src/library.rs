use std::ffi::{CStr, CString};

use alphamst_sys as sys;

/// major * 10000 + minor * 100 + patch of the library in use.
///
/// ```
/// assert_eq!(alphamst::version() / 100, 1); // 0.1
/// ```
pub fn version() -> i32 {
    // SAFETY: takes nothing.
    unsafe { sys::amst_version() }
}

/// The same as text.
///
/// ```
/// assert!(alphamst::version_string().starts_with("0.1."));
/// ```
pub fn version_string() -> &'static str {
    // SAFETY: the answer is a constant string.
    unsafe { CStr::from_ptr(sys::amst_version_string()) }.to_str().unwrap_or_default()
}

/// Whether the build has the named feature: "threads".
///
/// ```
/// assert!(alphamst::has("threads"));
/// assert!(!alphamst::has("wings"));
/// ```
pub fn has(feature: &str) -> bool {
    // SAFETY: the string ends with a zero byte.
    CString::new(feature).map_or(false, |feature| unsafe { sys::amst_has(feature.as_ptr()) } != 0)
}
