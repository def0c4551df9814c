//! The C interface of AlphaMST as it is: one item for each function, constant and type of
//! `alphamst.h`, whose comments hold here too. The crate `alphamst` is the safe side of it.
//!
//! # Which library is linked
//!
//! The first of these that applies:
//!
//! 1. the one in the folder named by the environment variable `AMST_LIB_DIR`: an installed `lib` or a
//!    build folder. The shared library if there is one, else the static one;
//! 2. the one that `pkg-config` finds, of version 0.1 (`PKG_CONFIG_PATH` says where to look,
//!    `ALPHAMST_NO_PKG_CONFIG=1` skips this step, `ALPHAMST_STATIC=1` asks for the static library);
//! 3. with the feature `vendored`, one built by cmake from the repository that this crate lies in.
//!
//! `cargo run` and `cargo test` find a shared library where it was linked. A program started otherwise
//! needs its folder in `LD_LIBRARY_PATH`, unless the system looks there anyway.
//!
//! # The bindings
//!
//! `src/bindings.rs` is written by `generate.sh`; with the feature `generate` the build runs that
//! script and takes what it writes instead.

#![no_std]
#![allow(non_camel_case_types)]

extern crate std; // for the names that bindgen writes

#[cfg(not(feature = "generate"))]
include!("bindings.rs");
#[cfg(feature = "generate")]
include!(concat!(env!("OUT_DIR"), "/bindings.rs"));
