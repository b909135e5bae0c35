#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# newcomer.sh demo|test: in a bare Debian 12 with a clone of the repository in /source/redcc, what
# README.md says of script/demo and script/test. Run as root by script/clean-system.
set -euo pipefail
fail() { echo "FAIL: $*" >&2; exit 1; }
cd /source/redcc
export LC_ALL=C # whatever else is set, the bare system has no other

# one who is not root, and cannot become it, is told what is missing
! runuser -u newcomer -- script/setup >/tmp/output 2>/tmp/messages || fail "setup without root's right"
grep -q 'setup: run as root, or install:.* cmake' /tmp/messages || fail "setup: $(cat /tmp/messages)"

# one who may use sudo need not be root
apt-get update -qq
DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends sudo >/dev/null
echo 'newcomer ALL=(ALL) NOPASSWD: ALL' >/etc/sudoers.d/newcomer
chown -R newcomer: .
runuser -u newcomer -- script/setup >/tmp/setup.log 2>&1 || fail "setup: $(tail -n 20 /tmp/setup.log)"
[ -z "$(script/setup)" ] || fail "setup finds something missing the second time"

show_demo() { # runs it and keeps what it prints
  runuser -u newcomer -- script/demo >/tmp/demo 2>/tmp/messages || fail "demo: $(tail -n 20 /tmp/demo /tmp/messages)"
}
if [ "$1" = demo ]; then
  start=$SECONDS
  show_demo
  first=$((SECONDS - start)) start=$SECONDS
  show_demo
  cat /tmp/demo
  [ "$(grep -c 'remark: loop in' /tmp/demo)" -ge 4 ] || fail "demo: no remarks"
  grep -q 'equal, every bit' /tmp/demo || fail "demo: nothing about equal bits"
  [ "$(head -c 4 demo/parallel/contact-sheet.png | tail -c 3)" = PNG ] || fail "demo: no picture"
  [ -z "$(git -c safe.directory='*' status --porcelain)" ] || fail "demo leaves files in the tree"
  echo "newcomer: script/demo: the first time $first s, the second $((SECONDS - start)) s"
else
  runuser -u newcomer -- script/test release
fi
