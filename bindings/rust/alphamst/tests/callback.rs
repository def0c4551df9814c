//! Progress, log, cancelling, and panics on the way.
mod grid;

use std::ops::ControlFlow;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use alphamst::*;

fn run(mesh: &mut Mesh, patches: &mut Patches) -> Result<Report> {
    mesh.adapt(patches, 2.0, None)
}

#[test]
fn progress_rises_on_the_calling_thread() {
    let context = Context::new();
    context.set_threads(2).unwrap();
    let (mut mesh, mut patches) = grid::patched(&context, 12, 1, 5);
    patches.add_faces(&grid::square(12, 6, 10)).unwrap();
    let seen = Arc::new(Mutex::new(Vec::new()));
    let (told, here, token) = (Arc::clone(&seen), std::thread::current().id(), context.cancel_token());
    context
        .set_progress(move |fraction, stage| {
            assert_eq!(std::thread::current().id(), here);
            assert_eq!(token.progress(), fraction);
            told.lock().unwrap().push((fraction, stage.to_owned()));
            ControlFlow::Continue(())
        })
        .unwrap();
    let _ = run(&mut mesh, &mut patches).unwrap();
    let seen = std::mem::take(&mut *seen.lock().unwrap());
    assert!(seen.len() >= 3 && seen.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    assert_eq!((seen[0].0, seen[seen.len() - 1].0), (0.0, 1.0));
    assert!(seen.iter().all(|(_, stage)| !stage.is_empty()));
    assert_eq!(context.progress(), 1.0);
    assert!(format!("{context:?}").contains("progress: 1.0"));
}

#[test]
fn cancelling_at_any_call_changes_nothing() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 10, 1, 5);
    let digest = mesh.checksum();
    let mut stops = 0;
    loop {
        let mut calls = 0;
        let stop = move |_: f64, _: &str| {
            calls += 1;
            if calls > stops {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        context.set_progress(stop).unwrap();
        match run(&mut mesh, &mut patches) {
            Ok(_) => break,
            Err(error) => assert_eq!(error.status, Status::Cancelled),
        }
        assert_eq!((mesh.checksum(), mesh.revision()), (digest, 0));
        assert_eq!(patches.patch(PatchId::new(0)).unwrap().faces().unwrap().len(), 16);
        stops += 1;
    }
    assert!(stops >= 2);
    assert_ne!(mesh.checksum(), digest);
}

#[test]
fn a_panic_at_any_call_changes_nothing() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 10, 1, 5);
    let digest = mesh.checksum();
    let mut stops = 0;
    loop {
        let mut calls = 0;
        context
            .set_progress(move |_, _| {
                calls += 1;
                if calls > stops {
                    std::panic::panic_any(stops);
                }
                ControlFlow::Continue(())
            })
            .unwrap();
        match catch_unwind(AssertUnwindSafe(|| run(&mut mesh, &mut patches))) {
            Ok(done) => break assert!(done.is_ok()),
            Err(payload) => assert_eq!(payload.downcast_ref::<usize>(), Some(&stops)),
        }
        assert_eq!((mesh.checksum(), mesh.revision()), (digest, 0));
        context.clear_progress().unwrap();
        let _ = mesh.clone().smooth(None, None).unwrap(); // the panic is over, the context is free
        stops += 1;
    }
    assert!(stops >= 2);
}

#[test]
fn a_panic_in_the_log_is_the_callers() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 10, 1, 5);
    context.set_log(LogLevel::Info, |_, message| panic!("{message}")).unwrap();
    let (before, faces) = (mesh.checksum(), mesh.n_faces());
    let payload = catch_unwind(AssertUnwindSafe(|| run(&mut mesh, &mut patches))).unwrap_err();
    assert!(payload.downcast_ref::<String>().unwrap().starts_with("adapt: 16 faces before"));
    // All or nothing, whichever the library was at.
    assert!(mesh.checksum() == before || mesh.n_faces() == faces + 16);
    mesh.check().unwrap();
    context.clear_log().unwrap();
    let _ = mesh.smooth(&patches, None).unwrap();
}

#[test]
fn the_log_speaks_up_to_its_level() {
    let context = Context::new();
    let mut mesh = grid::mesh(&context, 12, 12);
    let mut patches = Patches::new(&mesh, &Options::new().repair_patches(false));
    patches.add_faces(&[0, 2].map(FaceId::new)).unwrap();
    let heard = Arc::new(Mutex::new(Vec::new()));
    let mut listen = |level| {
        let told = Arc::clone(&heard);
        context
            .set_log(level, move |level, message| told.lock().unwrap().push((level, message.to_owned())))
            .unwrap();
        let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
        std::mem::take(&mut *heard.lock().unwrap())
    };
    assert_eq!(listen(LogLevel::Off), []);
    assert_eq!(listen(LogLevel::Error), []);
    let levels = |heard: Vec<(LogLevel, String)>| heard.iter().map(|(level, _)| *level).collect::<Vec<_>>();
    assert_eq!(levels(listen(LogLevel::Warning)), [LogLevel::Warning]);
    assert_eq!(levels(listen(LogLevel::Info)), [LogLevel::Warning, LogLevel::Info]);
}

#[test]
fn cleared_functions_are_called_no_more() {
    let context = Context::new();
    let (mut mesh, _) = grid::patched(&context, 6, 1, 5);
    let calls = Arc::new(AtomicUsize::new(0));
    let (progress, log) = (Arc::clone(&calls), Arc::clone(&calls));
    context
        .set_progress(move |_, _| {
            progress.fetch_add(1, Ordering::Relaxed);
            ControlFlow::Continue(())
        })
        .unwrap();
    context
        .set_log(LogLevel::Debug, move |_, _| {
            log.fetch_add(100, Ordering::Relaxed);
        })
        .unwrap();
    let _ = mesh.smooth(None, None).unwrap();
    assert!(calls.load(Ordering::Relaxed) > 100);
    context.clear_progress().unwrap();
    context.clear_log().unwrap();
    assert_eq!(Arc::strong_count(&calls), 1); // both functions are gone
    let _ = mesh.smooth(None, None).unwrap();
}

#[test]
fn a_token_stops_until_it_is_reset() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 6, 1, 5);
    let token = context.cancel_token();
    token.clone().cancel();
    let digest = mesh.checksum();
    assert_eq!(mesh.adapt(&mut patches, 2.0, None).unwrap_err().status, Status::Cancelled);
    assert_eq!(mesh.reduce_singularities(&mut patches, None).unwrap_err().status, Status::Cancelled);
    assert_eq!(mesh.smooth(None, None).unwrap_err().status, Status::Cancelled);
    assert_eq!(mesh.clean(None).unwrap_err().status, Status::Cancelled);
    assert_eq!(mesh.checksum(), digest);
    token.reset();
    let _ = mesh.clean(None).unwrap();
    drop(context);
    token.cancel(); // outlives its context
    assert_eq!(mesh.clean(None).unwrap_err().status, Status::Cancelled);
    assert!(format!("{token:?}").contains("CancelToken"));
}

#[test]
fn a_token_may_be_pulled_in_a_callback() {
    let context = Context::new();
    let (mut mesh, _) = grid::patched(&context, 6, 1, 5);
    let token = context.cancel_token();
    context
        .set_progress(move |_, _| {
            token.cancel();
            ControlFlow::Continue(())
        })
        .unwrap();
    assert_eq!(mesh.smooth(None, None).unwrap_err().status, Status::Cancelled);
}

#[test]
fn callbacks_may_ask_and_drop_but_not_change() {
    let context = Arc::new(Context::new());
    let (mut mesh, mut patches) = grid::patched(&context, 10, 1, 5);
    let mut other = mesh.clone();
    let mut set = Patches::new(&other, None);
    set.add_faces(&grid::square(10, 1, 5)).unwrap();
    let mut mine = Some((Arc::clone(&context), Patches::new(&mesh, None)));
    let calls = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&calls);
    context
        .set_progress(move |_, _| {
            count.fetch_add(1, Ordering::Relaxed);
            let Some((context, empty)) = &mine else { return ControlFlow::Continue(()) };
            assert_eq!((other.n_faces(), set.len(), empty.len()), (100, 1, 0));
            assert_eq!(other.clone().checksum(), other.checksum());
            let refused = [
                other.adapt(&mut set, 2.0, None).map(drop),
                other.smooth(&set, None).map(drop),
                other.clean(None).map(drop),
                other.mark().map(drop),
                other.rollback(0),
                other.forget(0),
                other.set_points(&grid::points(10, 10)),
                other.set_all_flags(Entity::Face, Flags::FIXED, Flags::FIXED),
                set.add_rings(VertexId::new(0), 1).map(drop),
                set.set_all_alphas(1.0),
                context.set_threads(1),
                context.clear_progress(),
                context.set_progress(|_, _| ControlFlow::Break(())),
                context.clear_log(),
                context.set_log(LogLevel::Info, |_, _| ()),
            ];
            assert!(refused.iter().all(|result| result.as_ref().unwrap_err().status == Status::State));
            mine = None;
            ControlFlow::Continue(())
        })
        .unwrap();
    let _ = run(&mut mesh, &mut patches).unwrap();
    assert!(calls.load(Ordering::Relaxed) > 1);
    context.clear_progress().unwrap(); // ends the circle of context, function and mesh
}
