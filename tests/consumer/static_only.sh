#!/bin/sh
# static_only.sh PREFIX DIRECTORY: in a prefix without the shared library alphamst::alphamst is the static one.
set -eu
prefix=$1 directory=$2
here=$(cd "$(dirname "$0")" && pwd)

rm -rf "$directory"
mkdir -p "$directory"
cp -R "$prefix" "$directory/prefix"
find "$directory/prefix" \( -name 'libalphamst.so*' -o -name 'libalphamst.*dylib' -o -name 'alphamst-shared*.cmake' \) \
    -exec rm -f {} +
sh "$here/cmake.sh" "$directory/prefix" C shared "$directory/build"
