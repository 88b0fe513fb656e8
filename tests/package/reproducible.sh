#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# reproducible.sh: the Debian packages of this tree, as it was built, and of a fresh copy of the last commit, compiled
# without a compiler's cache in a folder of another name for a user with other habits (time zone, home, umask, one
# compiler more or less), byte by byte. It is called by `./dev reproducible`, not by ctest: it takes as long as a build.
set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
fail() { echo "reproducible: $*" >&2; exit 1; }
[ -z "$(git -C "$top" status --porcelain)" ] || fail "what is not committed would differ: commit it first"
SOURCE_DATE_EPOCH=$(git -C "$top" log -1 --format=%ct)
export SOURCE_DATE_EPOCH

rm -rf "$top/build/package"
(cd "$top" && ./dev package) || fail "no packages were built here"
copy="$work/a folder with a longer name/shortfall"
mkdir -p "$copy"
git -C "$top" archive HEAD | tar -xf - -C "$copy"
(umask 077 && cd "$copy" && env CCACHE_DISABLE=1 TZ=Asia/Tokyo LC_ALL=C.UTF-8 HOME=/nonexistent ./dev package) ||
  fail "no packages were built in $copy"

for deb in "$top"/build/package/*.deb; do
  other="$copy/build/package/$(basename "$deb")"
  if ! cmp "$deb" "$other"; then
    dpkg-deb -R "$deb" "$work/here"
    dpkg-deb -R "$other" "$work/there"
    diff -rq "$work/here" "$work/there" >&2 || true
    dpkg-deb -c "$deb" >"$work/here.list"
    dpkg-deb -c "$other" >"$work/there.list"
    diff "$work/here.list" "$work/there.list" | head -n 20 >&2 || true
    fail "$(basename "$deb") differs"
  fi
  sha256sum "$deb" | sed "s|$top/build/package/||"
done
echo "two builds, the same bytes"
