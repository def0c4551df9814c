//! What may be on several threads.
mod grid;

use std::ops::ControlFlow;
use std::sync::mpsc;
use std::thread;

use alphamst::*;

#[test]
fn handles_are_send_and_sync() {
    fn shared<T: Send + Sync>() {}
    shared::<Context>();
    shared::<CancelToken>();
    shared::<Options>();
    shared::<Mesh>();
    shared::<Patches>();
    shared::<Patch<'_>>();
    shared::<Report>();
    shared::<Outcome<'_>>();
    shared::<Error>();
}

#[test]
fn one_mesh_is_read_by_many() {
    let context = Context::new();
    let (mesh, patches) = grid::patched(&context, 20, 2, 18);
    let digest = mesh.checksum();
    thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                for _ in 0..20 {
                    assert_eq!(mesh.checksum(), digest);
                    assert_eq!(mesh.faces().len(), 400);
                    assert_eq!(patches.patch(PatchId::new(0)).unwrap().boundary().unwrap().len(), 64);
                }
            });
        }
    });
}

/// Patches read their mesh, which another thread changes meanwhile: they wait or are stale.
#[test]
fn patches_wait_for_their_mesh() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 12, 2, 8);
    let mut others = Patches::new(&mesh, None);
    others.add_faces(&grid::square(12, 2, 8)).unwrap();
    let start = mesh.mark().unwrap();
    thread::scope(|scope| {
        let reader = scope.spawn(|| {
            let mut answers = 0;
            while answers < 200 {
                match others.patch(PatchId::new(0)).and_then(|patch| patch.boundary()) {
                    Ok(boundary) => assert_eq!(boundary.len(), 24),
                    Err(error) => assert_eq!(error.status, Status::Stale),
                }
                answers += 1;
            }
        });
        while !reader.is_finished() {
            let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
            mesh.rollback(start).unwrap();
            patches = Patches::new(&mesh, None);
            patches.add_faces(&grid::square(12, 2, 8)).unwrap();
        }
    });
}

/// Two meshes of one context take turns, and none is refused.
#[test]
fn operations_of_one_context_take_turns() {
    let context = Context::new();
    thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                let (mut mesh, mut patches) = grid::patched(&context, 8, 1, 5);
                for alpha in [2.0, 0.5, 1.5] {
                    context.set_threads(2).unwrap();
                    let _ = mesh.adapt(&mut patches, alpha, None).unwrap();
                }
                mesh.check().unwrap();
            });
        }
    });
}

#[test]
fn contexts_share_nothing() {
    let digests: Vec<i64> = (0..4)
        .map(|_| {
            thread::spawn(|| {
                let (mut mesh, mut patches) = grid::patched(&Context::new(), 10, 1, 7);
                let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
                mesh.checksum()
            })
        })
        .collect::<Vec<_>>()
        .into_iter()
        .map(|thread| thread.join().unwrap())
        .collect();
    assert!(digests.iter().all(|digest| *digest == digests[0]));
}

#[test]
fn cancelling_from_another_thread() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 10, 1, 5);
    let digest = mesh.checksum();
    let (started, wait_for_start) = mpsc::channel();
    let (pulled, wait_for_pull) = mpsc::channel();
    let token = context.cancel_token();
    context
        .set_progress(move |_, _| {
            // Once: the operation is under way, and goes on when the flag is up.
            if started.send(()).is_ok() {
                let _ = wait_for_pull.recv();
            }
            ControlFlow::Continue(())
        })
        .unwrap();
    let canceller = thread::spawn(move || {
        wait_for_start.recv().unwrap();
        token.cancel();
        pulled.send(()).unwrap();
        token.progress()
    });
    assert_eq!(mesh.adapt(&mut patches, 2.0, None).unwrap_err().status, Status::Cancelled);
    assert_eq!(canceller.join().unwrap(), 0.0);
    assert_eq!(mesh.checksum(), digest);
}
