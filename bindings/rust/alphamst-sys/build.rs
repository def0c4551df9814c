// Finds the library and tells cargo how to link it; lib.rs documents the order.
use std::env;
use std::path::{Path, PathBuf};

// What the static library needs of others, as in alphamst.pc.
const PRIVATE_LIBRARIES: [&str; 6] = ["OpenMeshCore", "tbb", "expat", "z", "stdc++", "m"];

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=AMST_LIB_DIR");
    #[cfg(feature = "generate")]
    generate();
    if env::var_os("DOCS_RS").is_some() {
        return; // nothing is linked there
    }
    let folders = match env::var_os("AMST_LIB_DIR") {
        Some(folder) => link_from(Path::new(&folder)),
        None => link_found_or_vendored(),
    };
    for folder in &folders {
        lend_to_cargo(folder);
        println!("cargo:libdir={}", folder.display());
    }
}

fn link_from(folder: &Path) -> Vec<PathBuf> {
    let folder =
        folder.canonicalize().unwrap_or_else(|error| panic!("AMST_LIB_DIR={}: {error}", folder.display()));
    println!("cargo:rustc-link-search=native={}", folder.display());
    let has = |name: &str| folder.join(name).exists();
    if has("libalphamst.so") || has("libalphamst.dylib") || has("alphamst.lib") {
        println!("cargo:rustc-link-lib=dylib=alphamst");
    } else if has("libalphamst.a") {
        link_static();
    } else {
        panic!("AMST_LIB_DIR={} holds no alphamst library", folder.display());
    }
    vec![folder]
}

fn link_static() {
    println!("cargo:rustc-link-lib=static=alphamst");
    for library in PRIVATE_LIBRARIES {
        println!("cargo:rustc-link-lib=dylib={library}");
    }
}

fn link_found_or_vendored() -> Vec<PathBuf> {
    let found = pkg_config::Config::new().range_version("0.1".."0.2").probe("alphamst");
    match found {
        Ok(library) => library.link_paths,
        #[cfg(feature = "vendored")]
        Err(_) => vendored(),
        #[cfg(not(feature = "vendored"))]
        Err(error) => panic!(
            "no alphamst library: set AMST_LIB_DIR to the folder that holds it, or PKG_CONFIG_PATH to that \
             of alphamst.pc, or build with the feature `vendored`\n{error}"
        ),
    }
}

#[cfg(feature = "vendored")]
fn vendored() -> Vec<PathBuf> {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    for part in ["CMakeLists.txt", "cmake", "include", "src"] {
        println!("cargo:rerun-if-changed={}", repository.join(part).display());
    }
    let prefix = cmake::Config::new(&repository)
        .profile("Release")
        .define("ALPHAMST_BUILD_TESTS", "OFF")
        .define("ALPHAMST_BUILD_EXAMPLES", "OFF")
        .define("ALPHAMST_BUILD_BENCHMARKS", "OFF")
        .define("CMAKE_INSTALL_LIBDIR", "lib")
        .build();
    println!("cargo:rustc-link-search=native={}", prefix.join("lib").display());
    link_static();
    Vec::new()
}

// Cargo puts a folder into the loader's path only if it lies below the target folder: so the shared
// library gets links there, and `cargo run` and `cargo test` need no LD_LIBRARY_PATH.
fn lend_to_cargo(folder: &Path) {
    let lent = PathBuf::from(env::var_os("OUT_DIR").unwrap()).join("lib");
    let _ = std::fs::remove_dir_all(&lent);
    #[cfg(unix)]
    if std::fs::create_dir_all(&lent).is_ok() {
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            let name = entry.file_name();
            let text = name.to_string_lossy();
            if text.starts_with("libalphamst.so")
                || text.starts_with("libalphamst.") && text.ends_with(".dylib")
            {
                let _ = std::os::unix::fs::symlink(entry.path(), lent.join(&name));
            }
        }
        println!("cargo:rustc-link-search=native={}", lent.display());
    }
}

#[cfg(feature = "generate")]
fn generate() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let script = here.join("generate.sh");
    let header = here.join("../../../include/alphamst/alphamst.h");
    let output = PathBuf::from(env::var_os("OUT_DIR").unwrap()).join("bindings.rs");
    println!("cargo:rerun-if-changed={}", script.display());
    println!("cargo:rerun-if-changed={}", header.display());
    let status = std::process::Command::new("sh").arg(&script).arg(&output).status();
    assert!(matches!(status, Ok(status) if status.success()), "generate.sh failed: is bindgen installed?");
}
