use crate::{Error, Result, VertexId};
use alphamst_sys as sys;

/// A matrix in a slice: row i, column j is element `i * row_stride + j * column_stride`.
///
/// ```
/// # use alphamst::{Context, Mesh, Strided};
/// let columns = [0., 1., 1., 0., /* all x, then all y */ 0., 0., 1., 1.];
/// let points = Strided::new(&columns, 4, 2, 1, 4)?;
/// let faces = Strided::packed(&[0_i64, 1, 2, 3], 4)?;
/// let mesh = Mesh::from_strided(&Context::new(), points, faces, None)?;
/// assert_eq!(mesh.points::<2>()?[2], [1., 1.]);
/// # Ok::<(), alphamst::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Strided<'a, T> {
    data: &'a [T],
    rows: usize,
    columns: usize,
    row_stride: usize,
    column_stride: usize,
}

impl<'a, T> Strided<'a, T> {
    /// Errors: `Argument` (a stride of 0, or an element beyond the slice).
    ///
    /// ```
    /// # use alphamst::Strided;
    /// assert!(Strided::new(&[1., 2., 3., 4., 5., 6., 7., 8.], 2, 3, 4, 1).is_ok());
    /// assert!(Strided::new(&[1., 2., 3., 4., 5., 6.], 2, 3, 4, 1).is_err());
    /// ```
    pub fn new(
        data: &'a [T],
        rows: usize,
        columns: usize,
        row_stride: usize,
        column_stride: usize,
    ) -> Result<Self> {
        if row_stride == 0 || column_stride == 0 {
            return Err(Error::argument("a stride is 0"));
        }
        let last = |n: usize, stride: usize| n.checked_sub(1)?.checked_mul(stride);
        let is_inside = match (last(rows, row_stride), last(columns, column_stride)) {
            (Some(row), Some(column)) => row.checked_add(column).map_or(false, |last| last < data.len()),
            _ => rows == 0 || columns == 0,
        };
        // Strides count elements in an int64_t, and the last one is inside, or there is none.
        if !is_inside || row_stride > isize::MAX as usize || column_stride > isize::MAX as usize {
            return Err(Error::argument(format!(
                "{rows} x {columns} elements with strides {row_stride} and {column_stride} do not lie in a slice of {}",
                data.len()
            )));
        }
        Ok(Self { data, rows, columns, row_stride, column_stride })
    }

    /// Rows one after the other. Errors: `Argument` (no columns, or the last row is not complete).
    ///
    /// ```
    /// # use alphamst::Strided;
    /// assert!(Strided::packed(&[0., 0., 1., 0., 1., 1.], 2).is_ok());
    /// assert!(Strided::packed(&[0., 0., 1., 0., 1.], 2).is_err());
    /// ```
    pub fn packed(data: &'a [T], columns: usize) -> Result<Self> {
        if columns == 0 || data.len() % columns != 0 {
            return Err(Error::argument(format!("{} elements are no rows of {columns}", data.len())));
        }
        Self::new(data, data.len() / columns, columns, columns, 1)
    }

    pub(crate) fn rows<const N: usize>(rows: &'a [[T; N]]) -> Self {
        // SAFETY: arrays lie in a slice without gaps.
        let data = unsafe { std::slice::from_raw_parts(rows.as_ptr().cast(), rows.len() * N) };
        Self { data, rows: rows.len(), columns: N, row_stride: N.max(1), column_stride: 1 }
    }

    /// first element, rows, columns, and the strides of a row and of a column
    pub(crate) fn parts(&self) -> (*const T, i64, i32, i64, i64) {
        (
            self.data.as_ptr(),
            self.rows as i64,
            i32::try_from(self.columns).unwrap_or(i32::MAX),
            self.row_stride as i64,
            self.column_stride as i64,
        )
    }
}

/// The type of a face's corners in a new mesh: `i32`, `i64` or [`VertexId`].
pub trait Corner: Copy + sealed::Sealed {}

impl Corner for i32 {}
impl Corner for i64 {}
impl Corner for VertexId {}

pub(crate) mod sealed {
    use super::*;

    /// The library's function for this type.
    pub trait Sealed: Sized {
        /// # Safety
        ///
        /// As of `amst_mesh_create`: the parts are those of a matrix, the handles are valid.
        unsafe fn create_mesh(
            context: *mut sys::amst_context,
            points: Strided<'_, f64>,
            faces: Strided<'_, Self>,
            options: *const sys::amst_options,
            out: *mut *mut sys::amst_mesh,
        ) -> i32;
    }

    macro_rules! corner {
        ($type:ty, $create:ident) => {
            impl Sealed for $type {
                unsafe fn create_mesh(
                    context: *mut sys::amst_context,
                    points: Strided<'_, f64>,
                    faces: Strided<'_, Self>,
                    options: *const sys::amst_options,
                    out: *mut *mut sys::amst_mesh,
                ) -> i32 {
                    let (coords, n_vertices, dim, vertex, component) = points.parts();
                    let (corners, n_faces, per_face, face, corner) = faces.parts();
                    sys::$create(
                        context,
                        dim,
                        coords,
                        n_vertices,
                        vertex,
                        component,
                        corners.cast(),
                        n_faces,
                        face,
                        corner,
                        per_face,
                        options,
                        out,
                    )
                }
            }
        };
    }
    corner!(i32, amst_mesh_create);
    corner!(i64, amst_mesh_create_i64);
    corner!(VertexId, amst_mesh_create); // the same bytes
}
