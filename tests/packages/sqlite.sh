# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# The amalgamation (made here from Debian's source, by tclsh) and the shell, with a smoke run.
source_package=sqlite3
build_rounds=1
sqlite_program=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/sqlite.sql
build() {
  command -v tclsh >/dev/null || skip "the amalgamation is made by tclsh"
  CC=gcc ./configure -q && make sqlite3.c shell.c || return
  make_all "$CC" -O2 -DSQLITE_THREADSAFE=1 -c sqlite3.c
  make_all "$CC" -O2 shell.c sqlite3.o -o shell -lpthread -ldl -lm
}
check() { ./shell :memory: <"$sqlite_program"; }
work() { ./shell :memory: <"$sqlite_program"; }
