#!/bin/sh
# pkg-config.sh PREFIX LANGUAGE LINKAGE DIRECTORY: build and run version.* through pkg-config, or
# finer.f90 with the Fortran binding.
set -eu
prefix=$1 language=$2 linkage=$3 directory=$4
here=$(cd "$(dirname "$0")" && pwd)

pc=$(find "$prefix" -name alphamst.pc)
PKG_CONFIG_PATH=$(dirname "$pc")
export PKG_CONFIG_PATH
libdir=$(pkg-config --variable=libdir alphamst)

if [ "$linkage" = static ]; then
    cflags=$(pkg-config --static --cflags alphamst)
    # Both libraries are installed, and the linker would take the shared one.
    libs=$(pkg-config --static --libs alphamst | sed 's/-lalphamst/-l:libalphamst.a/')
elif [ "$linkage" = binding ]; then
    cflags=$(pkg-config --cflags alphamst-fortran)
    libs="$(pkg-config --libs alphamst-fortran) -Wl,-rpath,$libdir"
else
    cflags=$(pkg-config --cflags alphamst)
    libs="$(pkg-config --libs alphamst) -Wl,-rpath,$libdir"
fi
# Link the parts of the library with the most dependencies, too.
libs="-Wl,-u,amst_adapt,-u,amst_patches_decompose,-u,amst_mesh_read $libs"

case $language in
C) compile="${CC:-cc} $cflags $here/version.c" ;;
CXX) compile="${CXX:-c++} $cflags $here/version.cpp" ;;
Fortran) compile="${FC:-gfortran} $here/version.f90" ;;
esac
if [ "$linkage" = binding ]; then
    compile="${FC:-gfortran} $cflags $here/finer.f90"
fi

rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"
echo "$compile -o program $libs"
# shellcheck disable=SC2086 # flags are words
$compile -o program $libs
./program
