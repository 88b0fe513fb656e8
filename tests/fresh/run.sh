#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh SUITE [MIRROR]: the two commands of the README, `./dev demo` and `./dev test`, on a system that has nothing
# but what debootstrap's minbase installs. SUITE is bookworm, trixie or noble. The mirror is the one that this system's
# own apt uses, where that is a mirror of the same distribution; otherwise debootstrap's default.
#
# FRESH_CACHE=DIR keeps the bare system as DIR/SUITE.tar and starts from it the next time. FRESH_DIR (default
# /var/tmp) is where the system is unpacked; it is removed at the end.
set -eu

suite=${1-}
case $suite in
  bookworm | trixie) distribution=debian components=main ;;
  noble) distribution=ubuntu components=main,universe ;;
  *)
    echo "usage: run.sh bookworm|trixie|noble [MIRROR]" >&2
    exit 2
    ;;
esac
[ "$(id -u)" -eq 0 ] || { echo "run.sh: debootstrap and chroot take root" >&2; exit 2; }
command -v debootstrap >/dev/null 2>&1 || { echo "run.sh: needs the package debootstrap" >&2; exit 2; }

top=$(cd "$(dirname "$0")/../.." && pwd)

# The first address in apt's sources that ends in /debian or /ubuntu.
host_mirror() {
  cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources 2>/dev/null |
    grep -v '^[[:space:]]*#' | grep -Eo "https?://[^[:space:]]+/$distribution/?([[:space:]]|\$)" | head -n 1 |
    tr -d '[:space:]'
}
mirror=${2-}
[ -n "$mirror" ] || mirror=$(host_mirror)

root=$(mktemp -d "${FRESH_DIR:-/var/tmp}/fresh-$suite-XXXXXX")
cleanup() {
  umount "$root/proc" 2>/dev/null || true
  if mountpoint -q "$root/proc" 2>/dev/null; then
    echo "run.sh: $root/proc is still mounted; $root stays" >&2
  else
    rm -rf --one-file-system "$root"
  fi
}
trap cleanup EXIT
trap 'exit 130' INT TERM

now() { date +%s; }
base=${FRESH_CACHE:+$FRESH_CACHE/$suite.tar}
began=$(now)
if [ -n "$base" ] && [ -f "$base" ]; then
  tar -xpf "$base" -C "$root" --numeric-owner
else
  debootstrap --variant=minbase "--components=$components" "$suite" "$root" ${mirror:+"$mirror"}
  if [ -n "$base" ]; then
    mkdir -p "$FRESH_CACHE"
    tar -cpf "$base.part" -C "$root" --numeric-owner .
    mv "$base.part" "$base"
  fi
fi
echo "fresh $suite: bare system after $(($(now) - began)) s"

mkdir "$root/shortfall"
git -C "$top" archive HEAD | tar -xf - -C "$root/shortfall"
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mount -t proc proc "$root/proc"

# Only what a bare system would have in its environment, and the way to the network.
inside() {
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root ${http_proxy:+"http_proxy=$http_proxy"} \
    ${https_proxy:+"https_proxy=$https_proxy"} ${SHORTFALL_JOBS:+"SHORTFALL_JOBS=$SHORTFALL_JOBS"} \
    chroot "$root" sh -c 'cd /shortfall && exec "$@"' sh "$@" </dev/null
}
began=$(now)
inside ./dev demo
demo=$(($(now) - began))
began=$(now)
inside ./dev test
echo "fresh $suite: demo $demo s (packages, build, run), test $(($(now) - began)) s"
