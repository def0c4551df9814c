//! The library's arrays: `(T *out, int64_t capacity, int64_t *needed)`.

use std::mem::size_of;
use std::ptr;

use crate::error::check;
use crate::Result;

/// Asks for the size, then for the array, as rows of `T`.
///
/// # Safety
///
/// A `Row` is made of nothing but `T`s. Given a pointer and a success, `call` has written exactly
/// `needed` of them, at most as many as the capacity.
pub(crate) unsafe fn rows<Row, T>(call: impl Fn(*mut T, i64, *mut i64) -> i32) -> Result<Vec<Row>> {
    let width = size_of::<Row>() / size_of::<T>();
    let mut needed = 0;
    check(call(ptr::null_mut(), 0, &mut needed))?;
    let mut rows = Vec::<Row>::with_capacity(needed as usize / width);
    check(call(rows.as_mut_ptr().cast(), needed, &mut needed))?;
    rows.set_len(needed as usize / width);
    Ok(rows)
}

/// Fills the front of a slice and tells how many elements of it that are.
pub(crate) fn fill<T>(out: &mut [T], call: impl FnOnce(*mut T, i64, *mut i64) -> i32) -> Result<usize> {
    let mut needed = 0;
    check(call(out.as_mut_ptr(), out.len() as i64, &mut needed))?;
    Ok(needed as usize)
}

/// A count of the library.
pub(crate) fn count(value: i64) -> usize {
    usize::try_from(value).expect("the library counts from 0")
}
