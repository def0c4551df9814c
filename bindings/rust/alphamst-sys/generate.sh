#!/bin/sh
# Writes src/bindings.rs, or the file given, from the header. Needs the programs bindgen, 0.60 or
# later, and rustfmt; the file kept here is of bindgen 0.60.1.
#   generate.sh [OUTPUT]
set -eu
crate=$(cd "$(dirname "$0")" && pwd)
bindgen "$crate/../../../include/alphamst/alphamst.h" --allowlist-function 'amst_.*' --allowlist-var 'AMST_.*' --allowlist-type 'amst_.*' --blocklist-type '__.*' --no-prepend-enum-name --rustfmt-configuration-file "$crate/../rustfmt.toml" -o "${1:-$crate/src/bindings.rs}" -- -std=c99
