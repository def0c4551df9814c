//! Handles end in any order and on any thread; what is left still works.
mod grid;

use std::thread;

use alphamst::*;

struct World {
    context: Option<Context>,
    mesh: Option<Mesh>,
    patches: Option<Patches>,
    report: Option<Report>,
}

impl World {
    fn new() -> Self {
        let context = Context::new();
        context.set_progress(|_, _| std::ops::ControlFlow::Continue(())).unwrap();
        let (mut mesh, patches) = grid::patched(&context, 8, 2, 6);
        let report = mesh.smooth(&patches, None).unwrap();
        Self { context: Some(context), mesh: Some(mesh), patches: Some(patches), report: Some(report) }
    }

    fn end(&mut self, which: usize) {
        match which {
            0 => self.context = None,
            1 => self.mesh = None,
            2 => self.patches = None,
            _ => self.report = None,
        }
    }

    fn use_what_is_left(&mut self) {
        if let Some(context) = &self.context {
            context.set_threads(1).unwrap();
        }
        if let Some(mesh) = &mut self.mesh {
            mesh.check().unwrap();
            let _ = mesh.smooth(self.patches.as_ref(), None).unwrap();
        }
        if let Some(patches) = &self.patches {
            let patch = patches.patch(PatchId::new(0)).unwrap();
            assert!(patch.check().unwrap().0.is_empty());
            assert_eq!(patch.boundary().unwrap().len(), 16);
        }
        if let Some(report) = &self.report {
            assert_eq!(report.patch(PatchId::new(0)).unwrap().faces_after(), 16);
        }
    }
}

fn orders() -> Vec<[usize; 4]> {
    let mut orders = Vec::new();
    for code in 0..256 {
        let order = [code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6];
        if order.iter().fold(0, |seen, which| seen | 1 << which) == 15 {
            orders.push(order);
        }
    }
    orders
}

#[test]
fn in_any_order() {
    assert_eq!(orders().len(), 24);
    for order in orders() {
        let mut world = World::new();
        for which in order {
            world.end(which);
            world.use_what_is_left();
        }
    }
}

#[test]
fn on_another_thread() {
    for order in orders() {
        let mut world = World::new();
        for which in order {
            world = thread::spawn(move || {
                world.end(which);
                world
            })
            .join()
            .unwrap();
            world.use_what_is_left();
        }
    }
}

#[test]
fn at_the_same_time() {
    for _ in 0..50 {
        let World { context, mesh, patches, report } = World::new();
        let there = thread::spawn(move || drop((context, patches)));
        drop((mesh, report));
        there.join().unwrap();
    }
}

/// The function lives as long as a mesh that may call it, and no longer.
#[test]
fn a_function_outlives_its_context() {
    let alive = std::sync::Arc::new(());
    let context = Context::new();
    let held = std::sync::Arc::clone(&alive);
    context
        .set_progress(move |_, _| {
            let _ = &held;
            std::ops::ControlFlow::Break(())
        })
        .unwrap();
    let mut mesh = grid::mesh(&context, 4, 4);
    let token = context.cancel_token();
    drop(context);
    assert_eq!(mesh.smooth(None, None).unwrap_err().status, Status::Cancelled);
    drop(mesh);
    assert_eq!(std::sync::Arc::strong_count(&alive), 1);
    token.cancel();
}

/// A projection lives as long as a mesh or a copy that may call it, and no longer.
#[test]
fn a_projection_lives_with_the_copies() {
    let options = Options::new().edit_boundary(true);
    for first in 0..3 {
        let alive = std::sync::Arc::new(());
        let held = std::sync::Arc::clone(&alive);
        let mut mesh = grid::mesh(&Context::new(), 4, 4);
        mesh.set_projection(move |_, points: &[[f64; 2]], projected| {
            let _ = &held;
            projected.copy_from_slice(points);
            std::ops::ControlFlow::Continue(())
        })
        .unwrap();
        let copy = mesh.clone();
        let mut all = vec![mesh, copy.clone(), copy];
        for place in [first, 0, 0] {
            all.iter_mut().for_each(|mesh| drop(mesh.adapt(None, 4.0, &options).unwrap()));
            assert_eq!(std::sync::Arc::strong_count(&alive), 2);
            drop(all.remove(place));
        }
        assert_eq!(std::sync::Arc::strong_count(&alive), 1);
    }
}
