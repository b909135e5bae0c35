# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# FANN's examples (neural networks, of float), run on its data, and its cascade training: the random
# numbers start from the same seed in each run, and the networks are trained for fewer epochs.
source_package=libfann
build_rounds=1
fann_examples="xor_train simple_train simple_test robot mushroom momentums steepness_train cascade_train scaling_train scaling_test"
build() {
  sed -i -E 's/max_epochs = [0-9]{3,}/max_epochs = 60/' examples/*.c || return
  sed -i -E 's/max_neurons = [0-9]+/max_neurons = 4/' examples/cascade_train.c || return
  make_all fann_programs
}
fann_programs() {
  local flags="-DFANN_NO_SEED -I../src/include" program
  cd examples && compile ../src/fann.c ../src/fann_{cascade,error,io,train,train_data}.c || return
  for program in $fann_examples; do "$CC" -O2 $flags $program.c fann*.o -lm -o $program || return; done
}
check() {
  local program
  cd examples || return
  for program in $fann_examples; do echo "$program" && ./$program || return; done
  cat ./*.net
}
work() { cd examples && ./mushroom && ./robot; }
