#!/usr/bin/env bash
# readme.sh DIRECTORY: the line of README.md that builds and installs the library works for someone who has the
# packages for building alone: what only tests, examples and benchmarks need is not found, and a program uses
# what was installed. Builds the whole library, so it is run by scripts/test and not by ctest.
set -euo pipefail
directory=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

rm -rf "$directory"
mkdir -p "$directory/source" "$directory/home"
directory=$(cd "$directory" && pwd)
cd "$here/../.."
git ls-files -z | xargs -0 tar -cf - | tar -xf - -C "$directory/source"

line=$(grep -m 1 '^cmake --preset library' README.md)
hidden='-D CMAKE_DISABLE_FIND_PACKAGE_GTest=ON -D CMAKE_DISABLE_FIND_PACKAGE_cmocka=ON
    -D CMAKE_DISABLE_FIND_PACKAGE_benchmark=ON -D CMAKE_DISABLE_FIND_PACKAGE_Python3=ON
    -D GMSH=GMSH-NOTFOUND -D CARGO=CARGO-NOTFOUND -D JULIA=JULIA-NOTFOUND'
# shellcheck disable=SC2086 # they are words
hidden=$(echo $hidden)
cd "$directory/source"
HOME="$directory/home" bash -euxc "${line/--preset library/--preset library $hidden}"
sh "$here/cmake.sh" "$directory/home/alphamst" C shared "$directory/program"
