use alphamst_sys as sys;

use crate::enumeration::enumeration;
use crate::error::{check, must};
use crate::{array, Mesh, Result};

enumeration! {
    /// The quadrilateral metrics of Verdict. Areas and Jacobians are in squared units of the
    /// coordinates, angles in degrees, the others have no unit.
    Metric {
        /// Area.
        Area = AMST_METRIC_AREA,
        /// Aspect ratio.
        AspectRatio = AMST_METRIC_ASPECT_RATIO,
        /// Condition number.
        Condition = AMST_METRIC_CONDITION,
        /// Distortion.
        Distortion = AMST_METRIC_DISTORTION,
        /// Longest edge over shortest.
        EdgeRatio = AMST_METRIC_EDGE_RATIO,
        /// Smallest Jacobian of the corners.
        Jacobian = AMST_METRIC_JACOBIAN,
        /// Largest angle.
        MaxAngle = AMST_METRIC_MAX_ANGLE,
        /// Smallest angle.
        MinAngle = AMST_METRIC_MIN_ANGLE,
        /// Oddy's metric.
        Oddy = AMST_METRIC_ODDY,
        /// Radius ratio.
        RadiusRatio = AMST_METRIC_RADIUS_RATIO,
        /// Relative size: of the area and the mean area of the mesh.
        RelativeSize = AMST_METRIC_RELATIVE_SIZE,
        /// Smallest Jacobian of the corners, scaled by the edges there: 1 is a square corner.
        ScaledJacobian = AMST_METRIC_SCALED_JACOBIAN,
        /// Shape.
        Shape = AMST_METRIC_SHAPE,
        /// Shape times relative size.
        ShapeAndSize = AMST_METRIC_SHAPE_AND_SIZE,
        /// Shear.
        Shear = AMST_METRIC_SHEAR,
        /// Shear times relative size.
        ShearAndSize = AMST_METRIC_SHEAR_AND_SIZE,
        /// Skew.
        Skew = AMST_METRIC_SKEW,
        /// Stretch.
        Stretch = AMST_METRIC_STRETCH,
        /// Taper.
        Taper = AMST_METRIC_TAPER,
        /// Warpage.
        Warpage = AMST_METRIC_WARPAGE,
    }
}

/// One metric of all faces.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Summary {
    /// Faces measured.
    pub count: usize,
    /// Faces inside the metric's acceptable range.
    pub acceptable: usize,
    /// The smallest.
    pub min: f64,
    /// The largest.
    pub max: f64,
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub stddev: f64,
}

/// Quality.
impl Mesh {
    /// A metric of each face.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// assert_eq!(mesh.quality(Metric::Area), [1.0; 16]);
    /// assert_eq!(mesh.quality(Metric::MaxAngle), [90.0; 16]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn quality(&self, metric: Metric) -> Vec<f64> {
        // SAFETY: the handle is valid, nobody changes the mesh during the call.
        must(self.ask(|mesh| unsafe {
            array::rows(|out: *mut f64, capacity, needed| {
                sys::amst_mesh_get_quality(mesh, metric.into(), out, capacity, needed)
            })
        }))
    }

    /// Writes a metric of each face to the front of `out` and tells how many faces there are.
    ///
    /// Errors: `BufferTooSmall`; nothing is written then.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let mut areas = [0.0; 16];
    /// mesh.quality_into(Metric::Area, &mut areas)?;
    /// assert_eq!(areas, [1.0; 16]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn quality_into(&self, metric: Metric, out: &mut [f64]) -> Result<usize> {
        // SAFETY: as above.
        self.ask(|mesh| {
            array::fill(out, |out, capacity, needed| unsafe {
                sys::amst_mesh_get_quality(mesh, metric.into(), out, capacity, needed)
            })
        })
    }

    /// A metric of all faces together.
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let jacobians = mesh.summary(Metric::ScaledJacobian);
    /// assert_eq!((jacobians.count, jacobians.acceptable, jacobians.min), (16, 16, 1.0));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn summary(&self, metric: Metric) -> Summary {
        let mut raw =
            sys::amst_summary { count: 0, acceptable: 0, min: 0.0, max: 0.0, mean: 0.0, stddev: 0.0 };
        // SAFETY: as above; the output is written through a valid pointer.
        must(self.ask(|mesh| check(unsafe { sys::amst_mesh_get_summary(mesh, metric.into(), &mut raw) })));
        let sys::amst_summary { count, acceptable, min, max, mean, stddev } = raw;
        Summary { count: array::count(count), acceptable: array::count(acceptable), min, max, mean, stddev }
    }
}
