#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Pictures of the small scene. Arguments: PROGRAM SCENES FOLDER.
source "$(dirname "$0")/app_common.sh"
export ASAN_OPTIONS=detect_leaks=0 # Mesa keeps memory of its own until the end
export TSAN_OPTIONS=ignore_noninstrumented_modules=1 # and has threads of its own

expect 0 "" "$program" run patch -o a --steps 4 --frames 3 --progress none
expect 0 "3 pictures" "$program" render a --width 160 --height 120
for picture in a/frames/0000.png a/frames/0002.png a/frames/0004.png a/contact-sheet.png; do
  holds "$picture is a PNG" test "$(head -c 8 $picture | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a
  # A picture of one colour alone would take a few hundred bytes.
  holds "$picture shows something" test "$(stat -c %s $picture)" -gt 2000
done
holds "frames differ" test "$(cmp -s a/frames/0000.png a/frames/0004.png; echo $?)" -eq 1

# Every kind of solid can be drawn.
expect 0 "" "$program" run patch -o b --steps 1 --frames 2 --progress none --set \
  'colliders=[{kind: box, half_edges: [0.1, 0.1, 0.1]}, {kind: cylinder, axis: [1, 0, 0], radius: 0.1, half_length: 0.2, position: [1, 0, 0]}, {kind: plane, normal: [0, 1, 1], position: [0, 0, -1]}]'
expect 0 "2 pictures" "$program" render b --width 160 --height 120

expect 0 "" "$program" run patch -o none --steps 1 --frames 0 --progress none
expect 1 "none/frames: no frames" "$program" render none
head -c 1000 a/frames/0002.state >torn && mv torn a/frames/0002.state
expect 1 "a/frames/0002.state: torn" "$program" render a
finish
