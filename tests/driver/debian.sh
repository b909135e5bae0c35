#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The Debian packages: dpkg-buildpackage makes them, lintian finds no error, and unpacked below a
# prefix they give a redcc-cc that works. SOURCE is the source folder.
for tool in dpkg-buildpackage dh git; do
  command -v $tool >/dev/null || { echo "SKIPPED: needs $tool"; exit 77; }
done
(cd "$SOURCE" && dpkg-checkbuilddeps -P nocheck) || { echo "SKIPPED: build dependencies"; exit 77; }
. "$(dirname "$0")/library.sh"
packages=$(mktemp -d) # dpkg-buildpackage takes no folder with spaces in its name
begin "Debian packages"
trap 'rm -rf "$work" "$packages"' EXIT
tree=$packages/redcc
root=$packages/root
mkdir "$tree" "$root"
(cd "$SOURCE" && git ls-files -z | tar cf - --null -T -) | tar xf - -C "$tree"
(cd "$tree" && DEB_BUILD_OPTIONS="nocheck parallel=2" dpkg-buildpackage -us -uc -b -Pnocheck) >log 2>&1 ||
  { tail -n 20 log >&2; fail "dpkg-buildpackage"; finish; }
if command -v lintian >/dev/null; then
  TMPDIR=$packages lintian --fail-on error "$packages"/redcc_*.changes >tags 2>&1 || fail "lintian: $(head -n 20 tags)"
  expect_no_match tags '^[EW]:'
fi

for package in redcc libredcc-rt1 libredcc-rt-dev redcc-examples; do
  dpkg -x "$packages/$package"_[0-9]*.deb "$root" || fail "no package $package"
done
library=$(echo "$root"/usr/lib/*/libredcc_rt.so.1)
readelf -d "$library" >dynamic
expect_match dynamic 'SONAME.*\[libredcc_rt\.so\.1\]'
expect_equal "the development link" libredcc_rt.so.1 "$(readlink "${library%.1}")"
for page in redcc redcc-cc fabric fabric-serial; do expect_file "$root/usr/share/man/man1/$page.1.gz"; done
# what each package needs at run time is named
dpkg-deb -f "$packages"/redcc_[0-9]*_*.deb Depends >depends
expect_match depends 'libclang1-[0-9]+.*'
dpkg-deb -f "$packages"/libredcc-rt-dev_*.deb Depends >depends
expect_match depends 'libredcc-rt1 \(= '

export PATH="$root/usr/bin:$PATH" LD_LIBRARY_PATH="${library%/*}"
write_histogram count.c
cc -O2 -ffp-contract=off count.c -o serial && ./serial >expected
REDCC_BUILD_REPORT=$PWD/report redcc-cc -O2 count.c -o parallel || fail "redcc-cc"
expect_match report '"verdict":"transformed"'
OMP_NUM_THREADS=2 ./parallel | expect_same expected /dev/stdin
# by hand, with the shared library
export PKG_CONFIG_PATH="${library%/*}/pkgconfig"
redcc count.c -o count.redcc.c 2>/dev/null || fail redcc
eval "cc -O2 -ffp-contract=off count.redcc.c $(pkg-config --cflags redcc) -L'${library%/*}' -Wl,--no-as-needed -lredcc_rt -o shared" || fail "the shared library"
readelf -d shared >dynamic && expect_match dynamic 'NEEDED.*libredcc_rt\.so\.1'
OMP_NUM_THREADS=2 ./shared | expect_same expected /dev/stdin
# with CMake
cat >CMakeLists.txt <<'EOF'
cmake_minimum_required(VERSION 3.23)
project(count C)
find_package(redcc REQUIRED)
add_executable(count count.c)
redcc_target(count)
EOF
{ cmake -S . -B "$packages/cmake" -DCMAKE_PREFIX_PATH="$root/usr" -DCMAKE_BUILD_TYPE=Release &&
  cmake --build "$packages/cmake"; } >log 2>&1 || fail "CMake: $(tail -n 5 log)"
OMP_NUM_THREADS=2 "$packages/cmake/count" | expect_same expected /dev/stdin
fabric --version >version && fabric-serial --version >>version || fail fabric
expect_match version '[0-9]+\.[0-9]+\.[0-9]+'
end
finish
