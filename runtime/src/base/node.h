/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_NODE_H
#define REDCC_NODE_H

/** The NUMA node that the calling thread runs on now; -1: not known here. */
int redcc_node(void);

#endif
