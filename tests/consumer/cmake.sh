#!/bin/sh
# cmake.sh PREFIX LANGUAGE LINKAGE DIRECTORY: build and run version.* through the CMake package, or
# finer.f90 with the Fortran binding.
set -eu
prefix=$1 language=$2 linkage=$3 directory=$4
here=$(cd "$(dirname "$0")" && pwd)

case $language in
C) source=version.c ;;
CXX) source=version.cpp ;;
Fortran) source=version.f90 ;;
esac
if [ "$linkage" = binding ]; then
    source=finer.f90
fi

rm -rf "$directory"
cmake -S "$here" -B "$directory" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" \
    -DLANGUAGE="$language" -DLINKAGE="$linkage" -DSOURCE="$source"
cmake --build "$directory"
"$directory/program"
