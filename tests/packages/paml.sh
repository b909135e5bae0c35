# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# PAML's yn00, pamp and chi2 on the data that come with it (baseml and codeml take minutes to compile and run).
source_package=paml
build_rounds=1
build() { make_all paml_programs; }
paml_programs() {
  local program
  cd src && compile yn00.c pamp.c chi2.c tools.c || return
  "$CC" chi2.o -lm -o ../chi2 || return
  for program in yn00 pamp; do "$CC" $program.o tools.o -lm -o ../$program || return; done
}
check() {
  local file
  for file in examples/abglobin.nuc examples/lysin/lysin.nuc examples/HIVNSsites/HIVenvSweden.txt; do
    sed "s#seqfile = [^ ]*#seqfile = $file#" yn00.ctl >y.ctl && ./yn00 y.ctl && cat yn 2YN.* rst* || return
  done | grep -vi time
  ./pamp pamp.ctl </dev/null && cat mp
  ./chi2 3 7.5
}
work() { # one set of data takes a millisecond
  yes examples/abglobin.nuc | head -n 200 | xargs cat >many.txt
  sed 's#seqfile = [^ ]*#seqfile = many.txt#; s/^\* *ndata = 1/ndata = 200/' yn00.ctl >many.ctl && ./yn00 many.ctl
}
