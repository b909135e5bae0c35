# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Prints a mesh of the scenes as an OBJ file: awk -f meshes.awk NAME. The build runs this script.
function vertex(x, y, z) { printf format, x, y, z }

# Prints a level scarf of `columns` by `rows` square cells of 24 mm, its length along y. Diagonals alternate.
function scarf(columns, rows,    i, j, v) {
  print "# A scarf, 0.24 m by 1.536 m, flat: y along it."
  format = "v %.12g %.12g %g\n"
  for (j = 0; j <= rows; j++)
    for (i = 0; i <= columns; i++)
      vertex((i - columns / 2) * 24 / 1000, (j - rows / 2) * 24 / 1000, 0)
  for (j = 0; j < rows; j++)
    for (i = 0; i < columns; i++) {
      v = j * (columns + 1) + i + 1
      if ((i + j) % 2 == 0)
        print "f", v, v + 1, v + columns + 2 "\nf", v, v + columns + 2, v + columns + 1
      else
        print "f", v, v + 1, v + columns + 1 "\nf", v + 1, v + columns + 2, v + columns + 1
    }
}

# Prints a torus of `around` sections with `sides` vertices each.
function ring(around, sides, radius, thickness,    i, j, turn, angle, next_i, next_j) {
  print "# A ring (torus) of 0.3 m and 0.06 m, counter-clockwise from outside."
  format = "v %.5f %.5f %.5f\n"
  turn = 8 * atan2(1, 1)
  for (i = 0; i < around; i++)
    for (j = 0; j < sides; j++) {
      angle = turn * j / sides
      out = radius + thickness * cos(angle)
      vertex(out * cos(turn * i / around), out * sin(turn * i / around), thickness * sin(angle))
    }
  for (i = 0; i < around; i++)
    for (j = 0; j < sides; j++) {
      next_i = (i + 1) % around * sides
      next_j = (j + 1) % sides
      print "f", i * sides + j + 1, next_i + j + 1, next_i + next_j + 1
      print "f", i * sides + j + 1, next_i + next_j + 1, i * sides + next_j + 1
    }
}

BEGIN {
  if (ARGV[1] == "scarf")
    scarf(10, 64)
  else
    ring(24, 10, 0.3, 0.06)
}
