# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# Graphviz's sparse matrices, clusterings and layout by forces (lib/sparse, parts of lib/sfdpgen), run
# by graphviz.c: the tests of the whole compare drawings with those of another version.
source_package=graphviz
build_rounds=1
graphviz_program=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/graphviz.c
build() { make_all graphviz_parts; }
graphviz_parts() {
  local flags="-ffunction-sections" folder
  for folder in . common cgraph cdt sparse neatogen pathplan gvc sfdpgen rbtree; do flags+=" -I../$folder"; done
  cd lib/sfdpgen && : >../config.h || return
  compile ../sparse/{BinaryHeap,IntStack,LinkedList,QuadTree,SparseMatrix,clustering,general,mq,vector}.c \
    {Multilevel,PriorityQueue,spring_electrical,post_process,uniform_stress}.c ../common/memory.c "$graphviz_program" || return
  "$CC" ./*.o -Wl,--gc-sections -lm -o ../../sfdp_parts
}
check() { ./sfdp_parts 2 && ./sfdp_parts 25 && ./sfdp_parts 40; }
work() { ./sfdp_parts 40; }
