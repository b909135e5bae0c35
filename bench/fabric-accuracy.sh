# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What accuracy costs in time: fabric's own experiments (docs/accuracy.md says what they show), whole
# for `flap`, errors against time for the paper's scenes and the flag with 300 vertices, the orders of
# reduction by the parallel program, and whole runs by preconditioner. CPU seconds of one core, the
# least of REPEAT; whole runs interleaved. PICTURES=docs/pictures replaces that page's pictures.
#   REPEAT=3 ROUNDS=3 PICTURES=
. bench/common.sh
repeat=${REPEAT:-3}
rounds=${ROUNDS:-3}
pictures=${PICTURES:-}
export FABRIC_SCENES=$PWD/examples/fabric/scenes
serial=$build/examples/fabric/fabric-serial
parallel=$build/examples/fabric/fabric
csv=$results/fabric-accuracy.csv
whole=$results/fabric-preconditioners.csv
load_note

small=(--set mesh.boundary=60 --set mesh.vertices=300 --set time.step=0.02)
"$serial" accuracy all -o "$work/flap" --most-steps 128 --repeat "$repeat" 2>"$work/log" >/dev/null
for scene in hanging tablecloth flag; do
  steps=40 # of 20 ms; on the table differences grow by themselves after 0.4 s
  [ "$scene" != tablecloth ] || steps=20
  "$serial" accuracy dt --scene "$scene" -o "$work/$scene" --most-steps 128 --repeat "$repeat" \
    "${small[@]}" --set time.steps=$steps 2>>"$work/log" >/dev/null
done
awk 'FNR > 1 || NR == 1' "$work"/{flap,hanging,tablecloth,flag}/dt.csv >"$csv"
"$parallel" accuracy sum --scene hanging -o "$work/sum" --repeat "$repeat" 2>"$work/sums" >/dev/null

# A row for each scene and integrator: millimetres and milliseconds by number of steps.
awk -F, 'NR > 1 {
    row = $2 " | " $4
    if (!(row in text)) order[++rows] = row
    text[row] = text[row] sprintf(" %d: %.2g mm, %.0f ms;", $7, 1000 * $12, 1000 * $11)
  }
  END {for (r = 1; r <= rows; r++) print order[r] " |" text[order[r]]}' "$csv"
awk -F, 'NR > 1 {printf "%s to %g: %d iterations, error %.2g m, %.1f ms\n", $4, $6, $9, $14, 1000 * $11}' \
  "$work/flap/preconditioner.csv"
cat "$work/sums"

echo "scene,tolerance,preconditioner,round,cpu_seconds" >"$whole"
for round in $(seq "$rounds"); do
  for scene in tablecloth hanging; do
    for tolerance in 1e-2 1e-6; do
      for way in block-jacobi gauss-seidel; do
        "$serial" run "$scene" --set solution.tolerance=$tolerance \
          --set solution.preconditioner=$way -o "$work/run" --progress none >/dev/null
        echo "$scene,$tolerance,$way,$round,$(jq .step_seconds "$work/run/summary.json")" >>"$whole"
      done
    done
  done
done
awk -F, 'NR > 1 {k = $1 " " $2 " " $3; if (!(k in least) || $5 < least[k]) least[k] = $5}
  END {for (k in least) printf "%s: %.2f s\n", k, least[k]}' "$whole" | sort

if [ -n "$pictures" ]; then
  for name in dt-step dt-time cg preconditioner energy robustness; do
    cp "$work/flap/$name.png" "$pictures/accuracy-$name.png"
  done
  for scene in hanging tablecloth flag; do
    cp "$work/$scene/dt-time.png" "$pictures/accuracy-dt-time-$scene.png"
  done
fi
echo "kept: $csv, $whole"
