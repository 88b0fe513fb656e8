#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# reproducible.sh: compiles the last commit twice, in folders of other names, for users with other habits (time zone,
# language, umask, number of compilers), without a compiler's cache, and compares the Debian packages byte by byte. It
# is called by `./dev reproducible`, not by ctest: it takes as long as two builds.
set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
fail() { echo "reproducible: $*" >&2; exit 1; }
[ -z "$(git -C "$top" status --porcelain)" ] || echo "reproducible: what is not committed is not compared" >&2

# packages FOLDER UMASK ASSIGNMENT...: the packages of the last commit, built there.
packages() {
  folder=$1 mask=$2
  shift 2
  mkdir -p "$folder"
  git -C "$top" archive HEAD | tar -xf - -C "$folder"
  (umask "$mask" && cd "$folder" &&
    env CCACHE_DISABLE=1 "SOURCE_DATE_EPOCH=$(git -C "$top" log -1 --format=%ct)" "$@" ./dev package) ||
    fail "no packages were built in $folder"
}
packages "$work/a" 022 TZ=UTC LC_ALL=C
packages "$work/another/folder with a longer name" 077 TZ=Asia/Tokyo LC_ALL=C.UTF-8 HOME=/nonexistent SHORTFALL_JOBS=1

for deb in "$work"/a/build/package/*.deb; do
  other="$work/another/folder with a longer name/build/package/$(basename "$deb")"
  if ! cmp "$deb" "$other"; then
    for side in a b; do mkdir "$work/$side.root"; done
    dpkg-deb -R "$deb" "$work/a.root"
    dpkg-deb -R "$other" "$work/b.root"
    diff -rq "$work/a.root" "$work/b.root" >&2 || true
    fail "$(basename "$deb") differs"
  fi
  sha256sum "$deb" | sed "s|$work/a/build/package/||"
done
echo "two builds, the same bytes"
