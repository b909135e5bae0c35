/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define OF_HEADER __COUNTER__
