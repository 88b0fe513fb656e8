#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh SUITE [MIRROR]: the two commands of the README, `./dev demo` and `./dev test`, on a system that has nothing
# but what debootstrap's minbase installs; then the tests again for a user who is not root. SUITE is bookworm, trixie or noble. The mirror is the one that this system's
# own apt uses, where that is a mirror of the same distribution; otherwise the distribution's own. It is an http one:
# a bare system has no certificates.
#
# FRESH_CACHE=DIR keeps the bare system as DIR/SUITE.tar and starts from it the next time. FRESH_DIR (default
# /var/tmp) is where the system is unpacked; it is removed at the end.
set -eu

suite=${1-}
case $suite in
  bookworm | trixie)
    distribution=debian
    mirror=http://deb.debian.org/debian
    components=main
    keyring=/usr/share/keyrings/debian-archive-keyring.gpg
    script=sid
    ;;
  noble)
    distribution=ubuntu
    mirror=http://archive.ubuntu.com/ubuntu
    components=main,universe
    keyring=/usr/share/keyrings/ubuntu-archive-keyring.gpg
    script=gutsy
    ;;
  *)
    echo "usage: run.sh bookworm|trixie|noble [MIRROR]" >&2
    exit 2
    ;;
esac
[ "$(id -u)" -eq 0 ] || { echo "run.sh: debootstrap and chroot take root" >&2; exit 2; }
command -v debootstrap >/dev/null 2>&1 || { echo "run.sh: needs the package debootstrap" >&2; exit 2; }
[ -r "$keyring" ] || { echo "run.sh: needs the package $distribution-keyring, for $keyring" >&2; exit 2; }

# A debootstrap that is older than the suite lacks its name, and bootstraps it as it does the others of its family.
scripts=/usr/share/debootstrap/scripts
[ ! -e "$scripts/$suite" ] || script=$suite

top=$(cd "$(dirname "$0")/../.." && pwd)

# The first address in apt's sources that ends in /debian or /ubuntu.
host_mirror() {
  cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources 2>/dev/null |
    grep -v '^[[:space:]]*#' | grep -Eo "http://[^[:space:]]+/$distribution/?([[:space:]]|\$)" | head -n 1 |
    tr -d '[:space:]'
}
found=${2-}
[ -n "$found" ] || found=$(host_mirror)
mirror=${found:-$mirror}

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
  debootstrap --variant=minbase "--components=$components" "--keyring=$keyring" "$suite" "$root" "$mirror" "$scripts/$script"
  if [ -n "$base" ]; then
    mkdir -p "$FRESH_CACHE"
    tar -cpf "$base.part" -C "$root" --numeric-owner .
    mv "$base.part" "$base"
  fi
fi
echo "fresh $suite: bare system after $(($(now) - began)) s; commit $(git -C "$top" rev-parse --short HEAD)"
[ -z "$(git -C "$top" status --porcelain)" ] || echo "run.sh: what is not committed is not tested" >&2

chmod 755 "$root" # mktemp keeps others out
mkdir "$root/shortfall"
git -C "$top" archive HEAD | tar -xf - -C "$root/shortfall"
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mount -t proc proc "$root/proc"

# as USER COMMAND...: with only what a bare system would have in its environment, and the way to the network.
as() {
  user=$1
  shift
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp ${http_proxy:+"http_proxy=$http_proxy"} \
    ${https_proxy:+"https_proxy=$https_proxy"} ${SHORTFALL_JOBS:+"SHORTFALL_JOBS=$SHORTFALL_JOBS"} \
    chroot "--userspec=$user" "$root" sh -c 'cd /shortfall && exec "$@"' sh "$@" </dev/null
}

# Who may not install packages is told which ones to ask for.
status=0
as nobody ./dev demo >"$root/tmp/told" 2>&1 || status=$?
if [ "$status" -ne 2 ] || ! grep -q 'apt-get install.* libflint-dev' "$root/tmp/told"; then
  echo "run.sh: without packages and without root, ./dev demo exits with $status and says:" >&2
  cat "$root/tmp/told" >&2
  exit 1
fi

began=$(now)
as root ./dev demo
demo=$(($(now) - began))
echo "fresh $suite: demo $demo s (packages, build, run)"
as root dpkg-query -W g++ cmake libflint-dev libboost-dev libcli11-dev libfmt-dev nlohmann-json3-dev
began=$(now)
as root ./dev test
test=$(($(now) - began))
# The same tests for somebody who is not root; all is built already.
chown -R nobody "$root/shortfall"
began=$(now)
as nobody ./dev test
echo "fresh $suite: demo $demo s (packages, build, run), test $test s, test by a user $(($(now) - began)) s"
