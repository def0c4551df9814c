//! Metrics by value.
mod grid;

use alphamst::*;

fn metrics() -> impl Iterator<Item = Metric> {
    (0..20).map(|number| Metric::try_from(number).unwrap())
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-12
}

#[test]
fn all_metrics_have_their_numbers() {
    let names: Vec<String> = metrics().map(|metric| format!("{metric:?}")).collect();
    let expected = "Area AspectRatio Condition Distortion EdgeRatio Jacobian MaxAngle MinAngle Oddy RadiusRatio \
                    RelativeSize ScaledJacobian Shape ShapeAndSize Shear ShearAndSize Skew Stretch Taper Warpage";
    assert_eq!(names.join(" "), expected);
    assert!((0..20).all(|number| i32::from(Metric::try_from(number).unwrap()) == number));
    assert!(Metric::try_from(20).is_err() && Metric::try_from(-1).is_err());
}

#[test]
fn metrics_differ_in_value() {
    // A rectangle 3 x 1, and a parallelogram of height 3 on the same base.
    let points = [[0., 0.], [3., 0.], [3., 1.], [0., 1.], [6., 4.], [3., 4.]];
    let faces = [[0, 1, 2, 3], [3, 2, 4, 5]];
    let mesh = Mesh::new(&Context::new(), &points, &faces).unwrap();
    let is = |metric, wanted: [f64; 2]| {
        let values = mesh.quality(metric);
        assert!(near(values[0], wanted[0]) && near(values[1], wanted[1]), "{metric:?}: {values:?}");
        let mut into = [0.0; 2];
        assert_eq!(mesh.quality_into(metric, &mut into), Ok(2));
        assert_eq!(into, values[..]);
    };
    let half = f64::sqrt(0.5);
    is(Metric::Area, [3.0, 9.0]);
    is(Metric::EdgeRatio, [3.0, f64::sqrt(2.0)]);
    is(Metric::Jacobian, [3.0, 9.0]);
    is(Metric::ScaledJacobian, [1.0, half]);
    is(Metric::MaxAngle, [90.0, 135.0]);
    is(Metric::MinAngle, [90.0, 45.0]);
    is(Metric::Condition, [5.0 / 3.0, 1.5]);
    is(Metric::Shape, [0.6, 2.0 / 3.0]);
    is(Metric::RelativeSize, [0.25, 4.0 / 9.0]);
    is(Metric::ShapeAndSize, [0.15, 8.0 / 27.0]);
    is(Metric::Shear, [1.0, half]);
    is(Metric::ShearAndSize, [0.25, half * 4.0 / 9.0]);
    is(Metric::AspectRatio, [2.0, 1.0 + half]);
    is(Metric::Skew, [0.0, half]);
    is(Metric::Taper, [0.0, 0.0]);
    is(Metric::Warpage, [1.0, 1.0]);
    is(Metric::Distortion, [1.0, 1.0]);
    is(Metric::Oddy, [32.0 / 9.0, 2.5]);
    is(Metric::Stretch, [0.2, 0.4].map(f64::sqrt));
    let short = &mut [0.0; 1];
    assert_eq!(mesh.quality_into(Metric::Area, short).unwrap_err().status, Status::BufferTooSmall);
}

#[test]
fn unit_squares_are_ideal() {
    let mesh = grid::mesh(&Context::new(), 3, 2);
    for metric in metrics() {
        let wanted = match metric {
            Metric::MaxAngle | Metric::MinAngle => 90.0,
            Metric::Oddy | Metric::Skew | Metric::Taper => 0.0,
            _ => 1.0,
        };
        let values = mesh.quality(metric);
        assert!(values.len() == 6 && values.iter().all(|&value| near(value, wanted)), "{metric:?}");
        let summary = mesh.summary(metric);
        assert_eq!((summary.count, summary.acceptable), (6, 6), "{metric:?}");
    }
}

#[test]
fn a_summary_is_that_of_the_values() {
    let mut mesh = grid::mesh(&Context::new(), 4, 1);
    let points: Vec<[f64; 2]> = grid::points(4, 1).iter().map(|[x, y]| [x * x, *y]).collect();
    mesh.set_points(&points).unwrap(); // columns of width 1, 3, 5, 7
    let summary = mesh.summary(Metric::Area);
    assert_eq!(summary.count, 4);
    assert!(near(summary.min, 1.0) && near(summary.max, 7.0) && near(summary.mean, 4.0));
    assert!(near(summary.stddev, f64::sqrt(5.0)));
    let summary = mesh.summary(Metric::EdgeRatio); // acceptable up to 1.3
    assert_eq!((summary.count, summary.acceptable), (4, 1));
}
