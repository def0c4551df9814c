//! What the safe crate costs: a scalar query beside the C call, and arrays beside a copy of as many
//! bytes. The points of a mesh of dim 2 are no plain copy: the library keeps three coordinates.
//!
//!     cargo bench
use std::hint::black_box;
use std::time::Instant;

use alphamst::{sys, Context, Mesh, VertexId};

const SIDE: i32 = 1000; // vertices of a row
const ROUNDS: usize = 9;

/// The fastest of some rounds, in nanoseconds for each of n calls.
fn measure(n: u32, mut call: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        for _ in 0..n {
            call();
        }
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / f64::from(n));
    }
    best
}

fn grid<const D: usize>(context: &Context) -> Mesh {
    let points: Vec<[f64; D]> = (0..SIDE * SIDE)
        .map(|v| {
            let mut point = [0.0; D];
            point[..2].copy_from_slice(&[f64::from(v % SIDE), f64::from(v / SIDE)]);
            point
        })
        .collect();
    let corners = |v| [v, v + 1, v + SIDE + 1, v + SIDE];
    let faces: Vec<[i32; 4]> = (0..(SIDE - 1) * (SIDE - 1)).map(|f| corners(f + f / (SIDE - 1))).collect();
    Mesh::new(context, &points, &faces).expect("the grid is a mesh")
}

/// The same mesh made and asked through the raw functions.
fn raw_count_call() -> f64 {
    let points = [0., 0., 1., 0., 1., 1., 0., 1.];
    let (mut context, mut mesh, mut count) = (std::ptr::null_mut(), std::ptr::null_mut(), 0);
    // SAFETY: the arrays have the sizes given; the handles are destroyed once.
    unsafe {
        sys::amst_context_create(0, &mut context);
        sys::amst_mesh_create(
            context,
            2,
            points.as_ptr(),
            4,
            0,
            0,
            [0, 1, 2, 3].as_ptr(),
            1,
            0,
            0,
            4,
            std::ptr::null(),
            &mut mesh,
        );
        let time = measure(1_000_000, || {
            sys::amst_mesh_get_count(black_box(mesh), sys::AMST_FACE, &mut count);
            black_box(count);
        });
        sys::amst_mesh_destroy(mesh);
        sys::amst_context_destroy(context);
        time
    }
}

fn print_array(name: &str, time: f64, copy: f64) {
    println!("{name:<22} {:>8.3} ms  copy {:>8.3} ms  ratio {:.2}", time / 1e6, copy / 1e6, time / copy);
}

fn measure_arrays<const D: usize>(context: &Context) {
    let mesh = grid::<D>(context);
    let (mut points, copied) = (vec![0.0; D * mesh.n_vertices()], mesh.points::<D>().expect("dim is D"));
    let into = measure(5, || {
        mesh.points_into(black_box(&mut points)).expect("it has room");
    });
    let copied: Vec<f64> = copied.into_iter().flatten().collect();
    let copy = measure(5, || points.copy_from_slice(black_box(&copied)));
    let fresh_copy = measure(5, || drop(black_box(copied.clone())));
    let fresh = measure(5, || drop(black_box(mesh.points::<D>())));
    print_array(&format!("points_into, dim {D}"), into, copy);
    print_array(&format!("points, dim {D}"), fresh, fresh_copy);

    let mut faces = vec![[VertexId::new(0); 4]; mesh.n_faces()];
    let copied = mesh.faces();
    let into = measure(5, || {
        mesh.faces_into(black_box(&mut faces)).expect("it has room");
    });
    let copy = measure(5, || faces.copy_from_slice(black_box(&copied)));
    print_array(&format!("faces_into, dim {D}"), into, copy);
}

fn main() {
    let context = Context::new();
    let small =
        Mesh::new(&context, &[[0., 0.], [1., 0.], [1., 1.], [0., 1.]], &[[0, 1, 2, 3]]).expect("a quad");
    let safe = measure(1_000_000, || {
        black_box(black_box(&small).n_faces());
    });
    let raw = raw_count_call();
    println!("n_faces                {safe:>8.1} ns  in C {raw:>8.1} ns  more {:.1} ns", safe - raw);
    measure_arrays::<3>(&context);
    measure_arrays::<2>(&context);
}
