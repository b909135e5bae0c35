#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# In a bare Debian 12, as root: the packages in /source are installed by apt, used by an ordinary
# user (use.sh), removed and purged. Run by script/clean-system.
set -euo pipefail
here=$(dirname "$0")
fail() { echo "FAIL: $*" >&2; exit 1; }
apt() {
  DEBIAN_FRONTEND=noninteractive apt-get -y -qq "$@" >/tmp/apt.log 2>&1 || fail "apt-get $*: $(tail -n 20 /tmp/apt.log)"
}
as_user() { runuser -u newcomer -- env HOME=/home/newcomer TMPDIR=/tmp "$@"; }
# every file that is there because of redcc, by its name
ours() { find / -xdev \( -path /source -o -path /proc -o -path /var/cache/apt \) -prune -o \( -name '*redcc*' -o -name 'fabric*' \) -print; }

apt update
[ -z "$(ours)" ] || fail "the system is not bare: $(ours)"

echo "packages: without what is only recommended"
apt install --no-install-recommends /source/redcc_*.deb /source/libredcc-rt1_*.deb /source/libredcc-rt-dev_*.deb
as_user bash "$here/use.sh" alone
echo "packages: as apt installs them, in a project"
apt purge redcc libredcc-rt1 libredcc-rt-dev
apt install /source/redcc_*.deb /source/libredcc-rt1_*.deb /source/libredcc-rt-dev_*.deb /source/redcc-examples_*.deb
apt install --no-install-recommends make cmake pkg-config jq man-db bash-completion clang-19 libomp-19-dev
as_user bash "$here/use.sh" project
as_user env PREFIX=/usr DOCUMENT=/source/redcc/docs/tutorial.md bash "$here/../driver/document.sh"
apt install --reinstall /source/redcc_*.deb

echo "packages: removed"
apt remove redcc-examples
[ ! -e /usr/bin/fabric ] || fail "fabric is still there"
apt remove libredcc-rt1 # takes with it what needs it
! ours | grep -v '^/var/lib/dpkg/info/' || fail "left after remove: $(ours)"
dpkg --purge redcc libredcc-rt1 libredcc-rt-dev redcc-examples >/tmp/apt.log 2>&1 || fail "purge: $(cat /tmp/apt.log)"
apt autoremove --purge clang-19 libomp-19-dev # what came with redcc goes with it
[ -z "$(ours)" ] || fail "left after purge: $(ours)"
! dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' | grep -E 'redcc|libclang|clang-19' || fail "packages are left"
echo "packages: passed"
