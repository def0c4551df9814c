//! Vertices that come and go on the boundary of a square whose sides are arcs of one circle.
mod grid;

use std::ops::ControlFlow;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::Arc;

use alphamst::*;

/// 8 x 8 faces on the disk of radius 1, 32 edges on its rim, without a corner.
fn disk(context: &Context) -> Mesh {
    let bend = |[x, y]: [f64; 2]| {
        let ([x, y], most) = ([x / 4.0 - 1.0, y / 4.0 - 1.0], (x - 4.0).abs().max((y - 4.0).abs()) / 4.0);
        let round = most / x.hypot(y).max(1e-300);
        [x, y].map(|part| part * (most * round + (1.0 - most) * 0.7))
    };
    let points: Vec<[f64; 2]> = grid::points(8, 8).into_iter().map(bend).collect();
    Mesh::new(context, &points, &grid::faces(8, 8)).unwrap()
}

fn to_circle(points: &[[f64; 2]], projected: &mut [[f64; 2]]) -> ControlFlow<()> {
    for (&[x, y], to) in points.iter().zip(projected) {
        *to = [x / x.hypot(y), y / x.hypot(y)];
    }
    ControlFlow::Continue(())
}

/// A projection to the circle that counts its calls.
fn counted(mesh: &mut Mesh) -> Arc<AtomicUsize> {
    let calls = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&calls);
    mesh.set_projection(move |markers, points: &[[f64; 2]], projected| {
        count.fetch_add(1, Ordering::Relaxed);
        assert!(markers.len() == points.len() && markers.iter().all(|&marker| marker == 0));
        to_circle(points, projected)
    })
    .unwrap();
    calls
}

fn radii(mesh: &Mesh) -> Vec<f64> {
    let (points, edges, sides) = (mesh.points::<2>().unwrap(), mesh.edges(), mesh.edge_faces());
    let rim = edges.iter().zip(&sides).filter(|(_, sides)| sides.iter().any(Option::is_none));
    rim.map(|(edge, _)| points[edge[0].index()]).map(|[x, y]| x.hypot(y)).collect()
}

fn refine(mesh: &mut Mesh) -> Result<Report> {
    mesh.adapt(None, 4.0, &Options::new().edit_boundary(true))
}

#[test]
fn new_vertices_lie_on_the_circle() {
    let mut mesh = disk(&Context::new());
    let calls = counted(&mut mesh);
    let report = refine(&mut mesh).unwrap();
    let gained = report.all().get_real(ResultKey::AreaGained).unwrap();
    assert!(gained > 0.01 && gained < 0.1, "{gained}"); // what the chords had cut off the disk
    mesh.check().unwrap();
    let radii = radii(&mesh);
    assert!(mesh.n_faces() == 256 && radii.len() > 48, "{} edges", radii.len());
    assert!(radii.iter().all(|radius| (radius - 1.0).abs() <= 1e-12));
    assert_eq!(calls.load(Ordering::Relaxed), 2);
    mesh.clear_projection().unwrap();
    assert_eq!(Arc::strong_count(&calls), 1);
}

#[test]
fn without_the_option_nobody_asks() {
    let mut mesh = disk(&Context::new());
    let calls = counted(&mut mesh);
    let _ = mesh.adapt(None, 4.0, None).unwrap();
    assert_eq!((radii(&mesh).len(), calls.load(Ordering::Relaxed)), (32, 0));
}

#[test]
fn copies_keep_the_projection() {
    let context = Context::new();
    let mut mesh = disk(&context);
    let calls = counted(&mut mesh);
    let mut copy = mesh.clone();
    drop((mesh, context));
    let _ = refine(&mut copy).unwrap();
    assert!(radii(&copy).iter().all(|radius| (radius - 1.0).abs() <= 1e-12));
    assert_eq!((calls.load(Ordering::Relaxed), Arc::strong_count(&calls)), (2, 2));
    drop(copy);
    assert_eq!(Arc::strong_count(&calls), 1);
}

#[test]
fn a_failing_projection_changes_nothing() {
    let mut mesh = disk(&Context::new());
    let digest = mesh.checksum();
    let far = |_: &[i32], points: &[[f64; 2]], projected: &mut [[f64; 2]]| {
        projected.copy_from_slice(points);
        projected[0] = [3.0, 0.0];
        ControlFlow::Continue(())
    };
    type Fails = fn(&[i32], &[[f64; 2]], &mut [[f64; 2]]) -> ControlFlow<()>;
    let cases: [Fails; 3] = [far, |_, _, _| ControlFlow::Break(()), |_, _, _| ControlFlow::Continue(())];
    for fails in cases {
        mesh.set_projection(fails).unwrap();
        let error = refine(&mut mesh).unwrap_err();
        assert_eq!(error.status, Status::Projection);
        assert!(error.message.contains("projection"), "{error}");
        assert_eq!((mesh.checksum(), mesh.revision()), (digest, 0));
    }
    counted(&mut mesh);
    let _ = refine(&mut mesh).unwrap();
}

#[test]
fn a_panic_at_either_call_changes_nothing() {
    let mut mesh = disk(&Context::new());
    let digest = mesh.checksum();
    for last in 1..=2 {
        let mut calls = 0;
        mesh.set_projection(move |_, points: &[[f64; 2]], projected| {
            calls += 1;
            if calls == last {
                std::panic::panic_any(last);
            }
            to_circle(points, projected)
        })
        .unwrap();
        let payload = catch_unwind(AssertUnwindSafe(|| refine(&mut mesh))).unwrap_err();
        assert_eq!(payload.downcast_ref::<i32>(), Some(&last));
        assert_eq!((mesh.checksum(), mesh.revision()), (digest, 0));
    }
    counted(&mut mesh);
    let _ = refine(&mut mesh).unwrap(); // the panic is over
}

#[test]
fn it_may_ask_but_not_change() {
    let context = Context::new();
    let mut mesh = disk(&context);
    let mut other = mesh.clone();
    mesh.set_projection(move |_, points: &[[f64; 2]], projected| {
        assert_eq!((other.n_faces(), other.clone().n_faces()), (64, 64));
        let refused = [
            other.set_projection(|_, _: &[[f64; 2]], _| ControlFlow::Break(())),
            other.clear_projection(),
            other.clean(None).map(drop),
        ];
        assert!(refused.iter().all(|result| result.as_ref().unwrap_err().status == Status::State));
        to_circle(points, projected)
    })
    .unwrap();
    let _ = refine(&mut mesh).unwrap();
}

#[test]
fn another_dim_is_refused() {
    let mut mesh = disk(&Context::new());
    let error = mesh.set_projection(|_, _: &[[f64; 3]], _| ControlFlow::Continue(())).unwrap_err();
    assert_eq!(error.status, Status::Argument);
}
