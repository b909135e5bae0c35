# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# METIS and GKlib: the graphs and the mesh that come with it, partitioned and ordered.
source_package=metis
build_rounds=1
build() { make_all metis_programs; }
metis_programs() {
  local flags="-std=gnu99 -DLINUX -D_FILE_OFFSET_BITS=64 -DNDEBUG -DNDEBUG2 -DHAVE_EXECINFO_H -DHAVE_GETLINE" program
  flags+=" -IGKlib -Iinclude -Ilibmetis -Iprograms -DSVNINFO=\"none\""
  compile GKlib/{b64,blas,csr,error,evaluate,fkvkselect,fs,getopt,graph,htable,io,itemsets,mcore,memory}.c \
    GKlib/{omp,pdb,pqueue,random,rw,seq,sort,string,timers,tokenizer,util}.c || return
  mkdir gk && mv ./*.o gk && compile libmetis/*.c || return
  mkdir metis && mv ./*.o metis && compile programs/*.c || return
  "$CC" gpmetis.o cmdline_gpmetis.o io.o stat.o metis/*.o gk/*.o -lm -o gpmetis &&
    "$CC" ndmetis.o cmdline_ndmetis.o io.o smbfactor.o metis/*.o gk/*.o -lm -o ndmetis &&
    "$CC" mpmetis.o cmdline_mpmetis.o io.o stat.o metis/*.o gk/*.o -lm -o mpmetis &&
    "$CC" m2gmetis.o cmdline_m2gmetis.o io.o metis/*.o gk/*.o -lm -o m2gmetis
}
check() {
  local graph options
  cd graphs || return
  for graph in 4elt copter2; do
    for options in "" "-ptype=rb" "-objtype=vol -contig" "-minconn -ufactor=50"; do
      # shellcheck disable=SC2086
      ../gpmetis -seed=7 $options $graph.graph 12 && cksum $graph.graph.part.12 || return
    done
  done >out
  {
    ../gpmetis -seed=7 test.mgraph 5 && cksum test.mgraph.part.5 && ../ndmetis -seed=7 4elt.graph && cksum 4elt.graph.iperm &&
      ../mpmetis -seed=7 -gtype=nodal metis.mesh 9 && ../mpmetis -seed=7 metis.mesh 9 && cksum metis.mesh.?part.9 &&
      ../m2gmetis -gtype=nodal metis.mesh nodal.graph && cksum nodal.graph
  } >>out || return
  grep -viE 'time|:.*sec|I/O|memory|max |built on' out
}
work() { cd graphs && ../gpmetis copter2.graph 12; }
