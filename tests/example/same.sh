#!/bin/sh
# same.sh C_PROGRAM ARGUMENT COMMAND...: whether COMMAND ARGUMENT prints what C_PROGRAM ARGUMENT prints.
set -eu
program=$1 argument=$2
shift 2
expected=$("$program" "$argument")
printed=$("$@" "$argument")
printf '%s\n' "$printed"
if [ "$printed" != "$expected" ]; then
    printf '\nThe program in C prints:\n%s\n' "$expected"
    exit 1
fi
