#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What is exported, read back by Blender where it is installed (apt-get install blender python3-numpy);
# else skipped (77). Arguments: PROGRAM SCENES FOLDER.
here=$(cd "$(dirname "$0")" && pwd)
source "$here/app_common.sh"
command -v blender >where && blender -b --factory-startup --python-exit-code 1 \
  --python-expr 'import numpy' >blender.log 2>&1 || { echo "no Blender with numpy: skipped"; exit 77; }
expect 0 "" "$program" run ball --set mesh.vertices=300 --set mesh.boundary=60 -o run --progress none
expect 0 "frames of 300 vertices" "$program" export run
for format in glb gltf; do
  expect 0 "frames of 300 vertices" "${program%/*}/fabric-view" gltf run -o run/cloth.$format
done
cd run
expect 0 "Blender has read all back" \
  blender -b --factory-startup --python-exit-code 1 -P "$here/read_in_blender.py"
finish
