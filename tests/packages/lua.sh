# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# Lua's own tests are not in Debian's source; lua.lua runs what a program in Lua can ask of it.
source_package=lua5.4
lua_program=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/lua.lua
build() {
  local patch
  for patch in 0003 0002 0001; do # Debian's build makes a C++ library too; this is Lua's own
    patch -R -s -p1 <"$(echo debian/patches/$patch-*)" || return
  done
  make_all make -C src -j "$jobs" linux CC="$CC -std=gnu99"
}
check() { ./src/lua "$lua_program" && ./src/luac -l -l -o /dev/null "$lua_program" | sed 's/0x[0-9a-f]*//g' | cksum; }
work() { ./src/lua "$lua_program" 20; }
