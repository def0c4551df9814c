#!/bin/sh
# julia.sh PREFIX BINDING DIRECTORY: run finer.jl with a copy of the package and the installed library.
set -eu
prefix=$1 binding=$2 directory=$3
here=$(cd "$(dirname "$0")" && pwd)

rm -rf "$directory"
mkdir -p "$directory/depot"
cp -r "$binding" "$directory/AlphaMST"
AMST_LIBRARY=$(find "$prefix" -name libalphamst.so)
JULIA_DEPOT_PATH=$directory/depot
export AMST_LIBRARY JULIA_DEPOT_PATH
cd "$directory"
julia --startup-file=no --project=AlphaMST "$here/finer.jl"
