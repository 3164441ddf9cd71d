#!/bin/sh
# SPDX-License-Identifier: MIT
# What ./check and ./evaluate do first: install what is missing, configure and build the preset `release`.
# On a terminal ninja shows one moving line; in a pipe only what went wrong is said.
set -eu
cd "$(dirname "$0")/.."

# Software drivers only, so that every machine draws the same; and nothing of ours inherited by the build.
export LIBGL_ALWAYS_SOFTWARE=1
unset GLEXT_EMU LD_PRELOAD || true

cmake/install_packages.sh

mkdir -p build
echo "configuring (log: build/configure.log)"
if ! cmake --preset release >build/configure.log 2>&1; then
    cat build/configure.log >&2
    exit 1
fi

echo "building the preset release"
if [ -t 1 ]; then
    cmake --build --preset release "$@"
else
    cmake --build --preset release "$@" -- --quiet
fi
