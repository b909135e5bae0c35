#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Whole projects: make -j, and CMake by each of the ways that lead to redcc-cc. CMAKE_FILES is the
# folder with the CMake package as configured for installing.
. "$(dirname "$0")/library.sh"
prefix="$work/the prefix"
make_root "$prefix"
mkdir -p "$prefix/lib/cmake/redcc"
cp "$CMAKE_FILES"/redcc-config*.cmake "$prefix/lib/cmake/redcc/"
cp "$REDCC_CC_PROGRAM" "$prefix/bin/redcc-cc"
redcc_cc="$prefix/bin/redcc-cc"
# CMake's generators do not take a compiler's path with spaces everywhere: a link has none.
ln -s "$prefix" "/tmp/redcc-prefix.$$" && trap 'rm -rf "$work" "/tmp/redcc-prefix.$$"' EXIT
plain="/tmp/redcc-prefix.$$"

# Ten modules with a marked function each, two libraries, one program that calls them all.
make_sources() {
  mkdir -p src include
  echo '#define MARK' >include/mark.h
  : >include/all.h
  local calls=""
  for i in 0 1 2 3 4 5 6 7 8 9; do
    printf '#include "mark.h"\n#include "all.h"\nvoid f%d(void) {\n\n    MARK;\n}\n' "$i" >"src/m$i.c"
    echo "void f$i(void);" >>include/all.h
    calls+="    f$i();\n"
  done
  printf "#include \"all.h\"\nint main(void) {\n$calls    return 0;\n}\n" >src/main.c
}
build_with_cmake() { # FOLDER ARGUMENTS...
  local folder=$1
  shift
  cmake -S . -B "$folder" "$@" >"$folder.log" 2>&1 &&
    cmake --build "$folder" -j 4 >>"$folder.log" 2>&1 || fail "$case_name: $* : $(tail -n 20 "$folder.log")"
}
expect_ten() { # PROGRAM
  expect_equal "$case_name: $1" 10 "$("$1" | grep -c '^translated$')"
}

begin "make -j4"
make_sources
cat >Makefile <<'END'
CFLAGS = -O1 -Wall -Iinclude
objects = $(patsubst src/%.c,obj/%.o,$(wildcard src/*.c))
program: $(objects)
	$(CC) $(objects) -o $@
obj/%.o: src/%.c | obj
	$(CC) $(CFLAGS) -MMD -MP -c $< -o $@
obj:
	mkdir obj
-include $(objects:.o=.d)
END
make -s -j4 CC="'$redcc_cc'" >log 2>&1 || fail "$case_name: $(cat log)"
expect_ten ./program
expect_empty log
make -s -q CC="'$redcc_cc'" || fail "$case_name: not up to date after a build"
sleep 0.01
touch include/all.h
make -n CC="'$redcc_cc'" | grep -c -- '-c src' | grep -qx 11 || fail "$case_name: headers are no dependencies"
grep -q 'redcc-' obj/*.d && fail "$case_name: temporaries in dependency files"
end

cmake_lists='cmake_minimum_required(VERSION 3.23)
project(ten C)
add_library(half STATIC src/m0.c src/m1.c src/m2.c src/m3.c src/m4.c)
target_include_directories(half PUBLIC include)
add_executable(program src/main.c src/m5.c src/m6.c src/m7.c src/m8.c src/m9.c)
target_link_libraries(program PRIVATE half)
'

begin "C++ that calls C: whoever links goes through redcc-cc"
if command -v g++ >/dev/null; then
  make_sources
  mv src/main.c src/main.cpp
  sed -i 's/void f/extern "C" void f/' include/all.h
  sed -i 's/.*all\.h.*//' src/m*.c
  cat >Makefile <<'END'
program: $(patsubst %.c,%.o,$(wildcard src/*.c)) src/main.o
	$(CXX) $^ -o $@
src/%.o: src/%.c
	$(CC) -Iinclude -c $< -o $@
src/%.o: src/%.cpp
	$(CXX) -Iinclude -c $< -o $@
END
  make -s CC="'$redcc_cc'" CXX="'$redcc_cc' g++" >log 2>&1 || fail "$case_name: $(cat log)"
  expect_ten ./program
  echo 'cmake_minimum_required(VERSION 3.23)
project(ten C CXX)
include_directories(include)
file(GLOB sources src/*.c)
add_executable(program src/main.cpp ${sources})' >CMakeLists.txt
  build_with_cmake build "-DCMAKE_C_COMPILER=$plain/bin/redcc-cc" "-DCMAKE_CXX_LINKER_LAUNCHER=$plain/bin/redcc-cc"
  expect_ten build/program
  # a target of redcc_target needs nothing of the kind
  echo 'cmake_minimum_required(VERSION 3.23)
project(ten C CXX)
find_package(redcc REQUIRED)
include_directories(include)
file(GLOB sources src/*.c)
add_library(ten STATIC ${sources})
redcc_target(ten)
add_executable(program src/main.cpp)
target_link_libraries(program ten)' >CMakeLists.txt
  build_with_cmake with-target "-DCMAKE_PREFIX_PATH=$plain"
  expect_ten with-target/program
fi
end

begin "CMake: redcc-cc as the compiler"
make_sources
echo "$cmake_lists" >CMakeLists.txt
build_with_cmake build "-DCMAKE_C_COMPILER=$plain/bin/redcc-cc"
expect_ten build/program
expect_no_match "$RECORD" 'CMakeCCompiler|testCCompiler'
build_with_cmake build # a second run finds nothing to do
expect_no_match build.log 'Building'
end

begin "CMake: launchers"
make_sources
echo "$cmake_lists" >CMakeLists.txt
build_with_cmake build "-DCMAKE_C_COMPILER_LAUNCHER=$plain/bin/redcc-cc" "-DCMAKE_C_LINKER_LAUNCHER=$plain/bin/redcc-cc"
expect_ten build/program
if command -v ninja >/dev/null; then
  build_with_cmake ninja -G Ninja "-DCMAKE_C_COMPILER_LAUNCHER=$plain/bin/redcc-cc" "-DCMAKE_C_LINKER_LAUNCHER=$plain/bin/redcc-cc"
  expect_ten ninja/program
fi
end

begin "CMake: find_package and redcc_target"
make_sources
{
  echo "$cmake_lists"
  echo 'find_package(redcc 0.1 REQUIRED)
redcc_target(half)
redcc_target(program ORDER fixed REPORT report.jsonl)'
} >CMakeLists.txt
build_with_cmake build "-DCMAKE_PREFIX_PATH=$plain"
expect_ten build/program
expect_equal "$case_name: reports" 6 "$(wc -l <build/report.jsonl)"
expect_equal "$case_name: order" 6 "$(grep -c -- '--order=fixed' "$RECORD")"
expect_equal "$case_name: all" 11 "$(grep -c '^redcc ' "$RECORD")"
{
  echo "$cmake_lists"
  echo 'target_link_libraries(half PUBLIC m) # the keyword form, and the plain one
add_executable(other src/main.c src/m5.c src/m6.c src/m7.c src/m8.c src/m9.c)
target_link_libraries(other half)
find_package(redcc REQUIRED)
redcc_target(half)
redcc_target(other)'
} >CMakeLists.txt
build_with_cmake mixed "-DCMAKE_PREFIX_PATH=$plain"
expect_ten mixed/other
expect_equal "$case_name: only the target" 5 "$(mixed/program | grep -c '^translated$')"
for wrong in 'redcc_target(half ORDER sometimes)' 'redcc_target(nothing)' 'redcc_target(half WHAT)'; do
  { echo "$cmake_lists"; echo 'find_package(redcc REQUIRED)'; echo "$wrong"; } >CMakeLists.txt
  cmake -S . -B wrong "-DCMAKE_PREFIX_PATH=$plain" >log 2>&1 && fail "$case_name: accepted $wrong"
  expect_match log 'redcc_target'
done
end

begin "CMake: a launcher that is there already"
make_sources
mkdir bin
printf '#!/bin/bash\necho "ccache $1" >>"$RECORD"\nexec "$@"\n' >bin/ccache
chmod +x bin/ccache
{ echo "$cmake_lists"; echo 'find_package(redcc REQUIRED)
redcc_target(half)
redcc_target(program)'; } >CMakeLists.txt
PATH="$PWD/bin:$PATH" build_with_cmake build "-DCMAKE_PREFIX_PATH=$plain" -DCMAKE_C_COMPILER_LAUNCHER=ccache
expect_ten build/program
expect_match "$RECORD" '^ccache .*cc'
end

finish
