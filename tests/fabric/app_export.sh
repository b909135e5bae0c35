#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The frames of a run in formats of other programs, read back by od and awk. Arguments: PROGRAM SCENES
# FOLDER.
source "$(dirname "$0")/app_common.sh"
expect 0 "" "$program" run patch --steps 4 --frames 3 -o run --progress none
for format in pc2 mdd obj ply vtu; do
  expect 0 "3 frames of " "$program" export run --format $format
done
vertices=$(awk '/^element vertex/ {print $3}' run/ply/0000.ply)
triangles=$(awk '/^element face/ {print $3}' run/ply/0000.ply)
frames=$((3 * vertices * 3))
# floats ORDER FROM FILE: all that follow byte FROM, one a line
floats() { od --endian="$1" -An -v -w4 -t f4 -j "$2" "$3" | awk '{printf "%.9g\n", $1}'; }
# whole ORDER FROM FILE: the number of 4 bytes there
whole() { od --endian="$1" -An -t d4 -j "$2" -N 4 "$3" | tr -d ' '; }

holds "a cloth" test "$vertices" -gt 10 -a "$triangles" -gt 10
holds "PC2: its name" test "$(head -c 11 run/cloth.pc2)" = POINTCACHE2
holds "PC2: version" test "$(whole little 12 run/cloth.pc2)" = 1
holds "PC2: vertices" test "$(whole little 16 run/cloth.pc2)" = "$vertices"
holds "PC2: frames" test "$(whole little 28 run/cloth.pc2)" = 3
holds "PC2: size" test "$(stat -c %s run/cloth.pc2)" = $((32 + 4 * frames))
holds "MDD: frames" test "$(whole big 0 run/cloth.mdd)" = 3
holds "MDD: vertices" test "$(whole big 4 run/cloth.mdd)" = "$vertices"
holds "MDD: size" test "$(stat -c %s run/cloth.mdd)" = $((8 + 12 + 4 * frames))
floats little 32 run/cloth.pc2 >pc2.floats
floats big 20 run/cloth.mdd >mdd.floats
holds "both caches hold the same positions" cmp pc2.floats mdd.floats
# What is in the files of one frame is what the caches hold, in the same order.
points() { # points FILE BEGIN: the vertices after the line that BEGIN matches
  awk -v begin="$2" -v n="$vertices" 'on && n-- > 0 {for (k = 1; k <= 3; k++) printf "%.9g\n", $k} $0 ~ begin {on = 1}' "$1"
}
for step in 0000 0002 0004; do points run/ply/$step.ply '^end_header'; done >ply.floats
for step in 0000 0002 0004; do points run/vtu/$step.vtu 'NumberOfComponents'; done >vtu.floats
# near FILE FILE: the same numbers, but for the digits that od leaves out.
near() {
  [ "$(wc -l <"$1")" = "$(wc -l <"$2")" ] &&
    paste "$1" "$2" | awk '{d = $1 - $2} d * d > 1e-13 * (1e-6 + $1 * $1) {exit 1}'
}
holds "the PLY files' positions" near pc2.floats ply.floats
awk '$1 == "v" {for (k = 2; k <= 4; k++) printf "%.9g\n", $k}' run/obj/000[024].obj >obj.floats
holds "the OBJ files' positions" cmp ply.floats obj.floats
expect 0 "triangles: $triangles" "$program" mesh info run/obj/0004.obj
expect 0 "extent:    x -0.25 to 0.25 m, y -0.25 to 0.25 m, z 0.62 to 0.62 m (z is up)" \
  "$program" mesh info run/ply/0000.ply
holds "the VTU files' positions" near pc2.floats vtu.floats
holds "the cloth moves" test "$(head -n $((3 * vertices)) pc2.floats | md5sum)" != "$(tail -n $((3 * vertices)) pc2.floats | md5sum)"
holds "PLY: triangles" test "$(grep -c '^3 ' run/ply/0004.ply)" = "$triangles"
holds "VTU: triangles" grep -q "NumberOfCells=\"$triangles\"" run/vtu/0004.vtu
holds "VTU: their types" test "$(grep -c '^5$' run/vtu/0004.vtu)" = "$triangles"
holds "PVD: the frames" test "$(grep -o 'file="[0-9]*.vtu"' run/vtu/cloth.pvd | tr -d '\n')" = \
  'file="0000.vtu"file="0002.vtu"file="0004.vtu"'

for format in gltf glb; do
  expect 0 "3 frames of $vertices vertices in run/cloth.$format" "$program" export run --format $format
done
# Read back as a mesh it is the cloth of the first frame.
if [[ $("$program" mesh info run/cloth.glb 2>&1) != *"built without assimp"* ]]; then
  expect 0 "" "$program" run patch --steps 0 -o bare --frames 1 --progress none --set 'colliders=[]'
  expect 0 "" "$program" export bare --format glb
  expect 0 "" "$program" export bare --format ply
  for format in glb ply; do
    file=bare/cloth.glb
    [ $format = glb ] || file=bare/ply/0000.ply
    expect 0 "" "$program" mesh reorder $file -o $format.obj
  done
  holds "the floats of glTF are those of PLY" cmp glb.obj ply.obj
fi

expect 0 "in elsewhere.pc2" "$program" export run -o elsewhere.pc2
holds "the path given" cmp run/cloth.pc2 elsewhere.pc2
expect 1 "no/where.mdd.partial" "$program" export run --format mdd -o no/where.mdd.partial
expect 1 "cannot be written" "$program" export run --format mdd -o no/where.mdd
expect 2 "--format is 'pc3', expected one of 'pc2', 'mdd', 'obj', 'ply', 'vtu', 'gltf', 'glb', 'mp4'; did you mean 'pc2'?" \
  "$program" export run --format pc3
expect 2 "which folder?" "$program" export
expect 2 "one folder at a time, not 'b' as well" "$program" export run b
expect 1 "cannot be read" "$program" export nowhere
cp -r run torn
head -c 100 run/frames/0002.state >torn/frames/0002.state
expect 1 "0002.state" "$program" export torn --format mdd -o torn.mdd
holds "nothing half-written" test ! -e torn.mdd -a ! -e torn.mdd.partial
finish
