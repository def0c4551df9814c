#!/bin/sh
# same.sh C_PROGRAM MESH COMMAND...: whether COMMAND MESH prints what C_PROGRAM MESH prints.
set -eu
program=$1 mesh=$2
shift 2
expected=$("$program" "$mesh")
printed=$("$@" "$mesh")
printf '%s\n' "$printed"
if [ "$printed" != "$expected" ]; then
    printf '\nThe program in C prints:\n%s\n' "$expected"
    exit 1
fi
