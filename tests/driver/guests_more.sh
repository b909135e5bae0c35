#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# redcc-cc as a guest of tools that few systems have: Python extensions by setuptools and by Meson, gdb, perf,
# a cross compiler. What is not installed is named and skipped. BUILD is the build folder. Slow.
. "$(dirname "$0")/library.sh"
install_tree "$BUILD" "$work/prefix"
export PATH="$work/prefix/bin:/usr/bin:$PATH" OMP_NUM_THREADS=3 OMP_WAIT_POLICY=passive
unset CMAKE_C_COMPILER_LAUNCHER CC
has() { command -v "$1" >/dev/null || { echo "SKIPPED: $1"; return 1; }; }
python=/usr/bin/python3

write_extension() {
  cat >m.c <<'END'
#include <Python.h>
static double h[1000];
static PyObject *go(PyObject *self, PyObject *args) {
    Py_buffer keys;
    double sum = 0;
    (void)self;
    if (!PyArg_ParseTuple(args, "y*", &keys))
        return NULL;
    const int *s = keys.buf;
    const int n = (int)(keys.len / 4);
    for (int t = 0; t < n; t++)
        h[s[t]] += 1.0 / (1 + t);
    for (int e = 0; e < 1000; e++)
        sum = 0.5 * sum + h[e];
    PyBuffer_Release(&keys);
    return PyFloat_FromDouble(sum);
}
static PyMethodDef methods[] = {{"go", go, METH_VARARGS, ""}, {NULL, NULL, 0, NULL}};
static struct PyModuleDef module = {PyModuleDef_HEAD_INIT, "m", NULL, -1, methods, NULL, NULL, NULL, NULL};
PyMODINIT_FUNC PyInit_m(void) { return PyModule_Create(&module); }
END
  cat >setup.py <<'END'
from setuptools import setup, Extension
setup(name='m', version='1', ext_modules=[Extension('m', ['m.c'])])
END
  cat >meson.build <<'END'
project('m', 'c', default_options: ['buildtype=release'])
py = import('python').find_installation('python3')
py.extension_module('m', 'm.c', dependencies: py.dependency())
END
}
use_extension() { # FOLDER: what it computes
  PYTHONPATH=$1 $python -c 'import m, struct
for call in range(20):
    r = m.go(struct.pack("200000i", *[(t * 7919 + t // 3) % 1000 for t in range(200000)]))
print(r.hex())'
}

if [ -e "$(ls -d /usr/include/python3.*/Python.h 2>/dev/null | head -n 1)" ] && $python -c 'import setuptools' 2>/dev/null; then
  begin "a Python extension by setuptools, with -fwrapv"
  write_extension
  CFLAGS="-ffp-contract=off" $python setup.py -q build_ext --build-lib plain >log 2>&1 || fail "$case_name: $(tail -n 3 log)"
  use_extension plain >expected
  REDCC_BUILD_REPORT=$PWD/report CC=redcc-cc $python setup.py build_ext --force --build-lib parallel >log 2>&1 || fail "$case_name: $(tail -n 3 log)"
  expect_match log ' -fwrapv '
  expect_match report '"verdict":"transformed"'
  REDCC_METHOD=localwrite REDCC_REPORT=$PWD/run use_extension parallel | expect_same expected /dev/stdin
  expect_match run 'localwrite'
  end
  if has meson; then
    begin "a Python extension by Meson"
    write_extension
    CC=gcc CFLAGS=-ffp-contract=off meson setup plain >log 2>&1 && ninja -C plain >log 2>&1 || fail "$case_name: $(tail -n 3 log)"
    use_extension plain >expected
    CC=redcc-cc meson setup b >log 2>&1 && REDCC_BUILD_REPORT=$PWD/report ninja -C b >log 2>&1 || fail "$case_name: $(tail -n 3 log)"
    expect_match report '"verdict":"transformed"'
    REDCC_METHOD=localwrite use_extension b | expect_same expected /dev/stdin
    end
  fi
else
  echo "SKIPPED: python3-dev, python3-setuptools"
fi

if has gdb; then
  begin "gdb: a breakpoint on a line of the loop stops there, in the user's file"
  write_histogram count.c
  redcc-cc -g -O0 count.c -o p || fail "$case_name"
  REDCC_METHOD=serial gdb -q -batch -ex 'break count.c:8' -ex run -ex 'info line' ./p >log 2>&1
  expect_match log 'at .*count\.c:8|count\.c:8'
  expect_no_match log 'redcc-cc-[A-Za-z0-9]{6}'
  end
fi

if has perf; then
  begin "perf: the samples are named after the user's functions"
  write_histogram count.c
  sed -i 's/^int main(void) {/int main(void) { for (int again = 0; again < 100; again++)/' count.c
  redcc-cc -g -O1 count.c -o p || fail "$case_name"
  if perf record -q -o data ./p >/dev/null 2>&1; then
    perf report -i data --stdio 2>/dev/null >log
    expect_match log 'main'
  else
    echo "SKIPPED: perf record is not allowed here"
  fi
  end
fi

if has aarch64-linux-gnu-gcc; then
  begin "a cross compiler: passed through, and said"
  write_histogram count.c
  REDCC_BUILD_REPORT=$PWD/report redcc-cc aarch64-linux-gnu-gcc -O2 -c count.c || fail "$case_name"
  expect_match report '"left_alone":"the compiler is for another machine"'
  REDCC_STRICT=1 redcc-cc aarch64-linux-gnu-gcc -O2 -c count.c 2>messages && fail "$case_name: REDCC_STRICT"
  aarch64-linux-gnu-gcc -O2 -c count.c -o expected.o && expect_same expected.o count.o
  end
fi
finish
