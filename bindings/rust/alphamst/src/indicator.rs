use alphamst_sys as sys;

use crate::error::value;
use crate::{options, Mesh, Options, Result};

/// From error to mesh.
impl Mesh {
    /// Writes the vertex field "size" that [`Mesh::adapt`] goes by and tells how many faces it asks for.
    ///
    /// The indicator of a face is what it contributes to the error, at least 0, like h to the power of
    /// [`ErrorOrder`](crate::OptionKey::ErrorOrder) for edges of length h; where fronts are sharp the jump
    /// across the face will do. Each face asks for edges at which its indicator is `tolerance`, and `faces` is
    /// a limit of their number, 0: none. With a tolerance of 0 there will be as many `faces`, with equal error
    /// everywhere. Of the options `ErrorOrder`, `MinEdge`, `MaxEdge`, `Gradation` and `BufferLayers` count.
    ///
    /// Errors: `Range` (length, below 0, both 0), `Argument` (`MaxEdge` below `MinEdge`), `NotFinite`,
    /// `State` (in a callback).
    ///
    /// ```
    #[doc = include_str!("grid.txt")]
    /// let asked = mesh.size_from_indicator(&[1.0; 16], 0.0, 64, None)?;
    /// assert!((asked - 64.0).abs() < 0.1);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn size_from_indicator(
        &mut self,
        indicator: &[f64],
        tolerance: f64,
        faces: i64,
        options: Option<&Options>,
    ) -> Result<f64> {
        let (first, n) = (indicator.as_ptr(), indicator.len() as i64);
        // SAFETY: the handle is ours alone, the slice is read in the call.
        self.change(|mesh| {
            value(|asked| unsafe {
                sys::amst_mesh_size_from_indicator(
                    mesh,
                    first,
                    n,
                    tolerance,
                    faces,
                    options::raw(options),
                    asked,
                )
            })
        })
    }
}
