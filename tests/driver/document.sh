#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Does what a document says, with an installed redcc: writes its files (```c NAME), runs its commands
# (```sh) in an empty folder, and compares what they print with the ```text that follows.
# BUILD is the build folder to install from, or PREFIX where redcc is installed; DOCUMENT the document.
. "$(dirname "$0")/library.sh"
if [ -z "${PREFIX:-}" ]; then
  PREFIX=$(mktemp -d) # $(pkg-config ...) in a command cannot have spaces in it
  trap 'rm -rf "$work" "$PREFIX"' EXIT
  install_tree "$BUILD" "$PREFIX"
  export PKG_CONFIG_PATH="$PREFIX/$(sed -n 's/^CMAKE_INSTALL_LIBDIR:[A-Z]*=//p' "$BUILD/CMakeCache.txt")/pkgconfig"
fi
export PATH="$PREFIX/bin:$PATH"
begin "$(basename "$DOCUMENT")"

kind='' name='' text='' printed='' command=''
finish_block() {
  case "$kind" in
    c | make | cmake)
      mkdir -p "$(dirname "$name")"
      printf '%s' "$text" >"$name" ;;
    sh)
      command=$text
      printed=$(bash -euo pipefail -c "$command" </dev/null 2>"$work/errors") ||
        fail "status $? of: $command$printed $(cat "$work/errors")" ;;
    text)
      expect_equal "$command" "${text%$'\n'}" "$printed" ;;
    yaml) ;; # for another program
    *) fail "a block of unknown kind '$kind'" ;;
  esac
}
blocks=0
while IFS= read -r line; do
  if [ -z "$kind" ]; then
    case "$line" in '```'*) read -r kind name <<<"${line#\`\`\`}"; text='' ;; esac
  elif [ "$line" = '```' ]; then
    finish_block
    kind=''
    blocks=$((blocks + 1))
  else
    text+=$line$'\n'
  fi
done <"$DOCUMENT"
[ "$blocks" -gt 0 ] && [ "$blocks" -eq "$(grep -c '^```[a-z]' "$DOCUMENT")" ] || fail "$blocks blocks were found"
end
finish
