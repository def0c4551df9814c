#!/bin/sh
# rust.sh PREFIX BINDING DIRECTORY: a crate of its own with finer.rs, which depends on a copy of the
# binding, built and run with the library that pkg-config finds.
set -eu
prefix=$1 binding=$2 directory=$3
here=$(cd "$(dirname "$0")" && pwd)

rm -rf "$directory/finer" "$directory/rust"
mkdir -p "$directory/finer/src" "$directory/rust"
cp -r "$binding/Cargo.toml" "$binding/Cargo.lock" "$binding/alphamst-sys" "$binding/alphamst" "$directory/rust"
cp "$here/finer.rs" "$directory/finer/src/main.rs"
cat >"$directory/finer/Cargo.toml" <<'TOML'
[package]
name = "finer"
version = "0.1.0"
edition = "2021"

[dependencies]
alphamst = { path = "../rust/alphamst" }
TOML
unset AMST_LIB_DIR
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name alphamst.pc)")
CARGO_TARGET_DIR=$directory/target
export PKG_CONFIG_PATH CARGO_TARGET_DIR
cd "$directory/finer"
cargo run --quiet
