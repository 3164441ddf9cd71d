#!/bin/sh
# SPDX-License-Identifier: MIT
# set_uid.sh PROGRAM: the layer leaves set-uid programs alone. The dynamic linker drops LD_PRELOAD for them by
# itself, so PROGRAM is linked with the layer: only the layer's own restraint keeps it out. The same copy
# without the set-uid bit must have it, or nothing is shown. Skipped (77) where no other user can be had.
set -eu
program=$1
[ "$(id -u)" -eq 0 ] && command -v setpriv >/dev/null || exit 77
nobody="setpriv --reuid=65534 --regid=65534 --clear-groups"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
cp "$program" "$folder/program"
chmod 755 "$folder/program"
cd "$folder"
export GLEXT_EMU=device=visualize-fx

EXPECT=layer ./program || { echo "failed: the layer is not under a program linked with it"; exit 1; }
chown root "$folder/program"
chmod 4755 "$folder/program"
# A mount or a container that ignores the bit cannot show anything.
if $nobody ./program --effective-user | grep -qx 0; then :; else exit 77; fi
EXPECT=nothing $nobody ./program || { echo "failed: the layer acts in a set-uid program"; exit 1; }
