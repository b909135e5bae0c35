/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_NODE_H
#define REDCC_NODE_H

/** The NUMA node on which the calling thread is running; -1: unknown. */
int redcc_node(void);

#endif
