#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what packages.txt lists and the machine lacks. Says nothing when nothing is missing.
set -eu
list=$(dirname "$0")/../packages.txt
missing=
for package in $(sed 's/#.*//' "$list"); do
    dpkg-query -W -f='${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || missing="$missing $package"
done
[ -n "$missing" ] || exit 0
sudo=
if [ "$(id -u)" -ne 0 ]; then sudo=sudo; fi
echo "installing:$missing"
export DEBIAN_FRONTEND=noninteractive
$sudo apt-get -q update
# shellcheck disable=SC2086
$sudo env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install $missing
