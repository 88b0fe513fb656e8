#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh BUILD SOURCE COMPILER: makes the Debian packages of a build and looks at them as their users would.
set -eu
build=$1 source=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "package: $*" >&2; exit 1; }

export SOURCE_DATE_EPOCH=1700000000
for round in 1 2; do
  (cd "$build" && cpack -B "$work/$round" >"$work/log" 2>&1) || { cat "$work/log"; fail "cpack failed"; }
done
for deb in "$work"/1/*.deb; do
  cmp "$deb" "$work/2/$(basename "$deb")" || fail "$(basename "$deb"): two runs differ"
  dpkg-deb -x "$deb" "$work/root"
done
for deb in "$work"/1/*.deb; do
  dpkg-deb -c "$deb" | awk '$1 !~ /^(drwxr-xr-x|-rw[-x]r-[-x]r-[-x])$/ { print; found = 1 } END { exit found }' ||
    fail "$(basename "$deb"): not for everybody to read"
done
[ "$(ls "$work"/1/*.deb | wc -l)" -eq 2 ] || fail "there are to be two packages"
if command -v lintian >/dev/null 2>&1; then
  root=
  [ "$(id -u)" -ne 0 ] || root=--allow-root
  lintian $root --fail-on error,warning "$work"/1/*.deb || fail "lintian complains"
fi

usr=$work/root/usr
[ "$("$usr/bin/shortfall" --version)" = "$("$build/shortfall" --version)" ] || fail "another version"
"$usr/bin/shortfall" jump --height 40cm --dt 0.02 >/dev/null
for command in "" -jump -identify -export; do
  gzip -t "$usr/share/man/man1/shortfall$command.1.gz" || fail "no manual page shortfall$command"
done
for shell in bash zsh fish; do
  case $shell in
    bash) file=bash-completion/completions/shortfall ;;
    zsh) file=zsh/vendor-completions/_shortfall ;;
    fish) file=fish/vendor_completions.d/shortfall.fish ;;
  esac
  [ -s "$usr/share/$file" ] || fail "no completion for $shell"
  ! command -v $shell >/dev/null 2>&1 || $shell -n "$usr/share/$file" || fail "$shell cannot read its completion"
done
for schema in "$usr"/share/shortfall/*.schema.json; do
  [ -s "$schema" ] || fail "no schemas"
done
for schema in "$source"/share/output/*.schema.json; do
  cmp "$schema" "$usr/share/shortfall/output/$(basename "$schema")" || fail "no schema of the output"
done

PKG_CONFIG_PATH=$(dirname "$(find "$usr" -name shortfall.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046 # options
"$compiler" -std=c++20 $(pkg-config --cflags shortfall) "$source/tests/consumer/main.cpp" $(pkg-config --libs shortfall) \
  -o "$work/consumer"
"$work/consumer" >/dev/null || fail "the program of a user of pkg-config fails"
echo "two packages, as they should be"
