/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "mesh_parts.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/arrays.h"
#include "base/random.h"

enum { RELAXATIONS = 16 };
static const double BORDER_JITTER = 0.2; /* in either direction, relative to the border's spacing */
static const double ROW_JITTER = 0.45;   /* relative to the inner points' spacing, before they
                                          * repel */
static const double REACH = 1.3; /* distance up to which points repel each other, in spacings */
static const double REPULSION = 0.25; /* share of the push applied at once; above about 0.6 points
                                       * would oscillate */
static const double MARGIN = 0.5;     /* least distance of inner points from the border, in
                                       * spacings */

/** Points sorted into square cells: cell c has the points item[start[c]] .. item[start[c + 1] -
 *  1]. */
typedef struct cell_grid {
    int side; /* number of cells along each side of the square */
    int *start;
    int *item;
} cell_grid;

static void place_border(double (*points)[2], int boundary, random_source *source) {
    int next = 0;
    for (int side = 0; side < 4; side++) {
        const int intervals = boundary / 4 + (side < boundary % 4);
        for (int k = 0; k < intervals; k++) {
            const double shift = k == 0 ? 0.0 : BORDER_JITTER * random_signed(source);
            const double along = ((double)k + shift) / (double)intervals - 0.5;
            points[next][0] = side == 0 ? along : side == 1 ? 0.5 : side == 2 ? -along : -0.5;
            points[next][1] = side == 0 ? -0.5 : side == 1 ? along : side == 2 ? 0.5 : -along;
            next++;
        }
    }
    assert(next == boundary);
}

static double clamp(double value, double limit) {
    return value < -limit ? -limit : value > limit ? limit : value;
}

/** Places the inner points on a triangular lattice (every second row shifted by half a spacing),
 * then jitters them. */
static void place_inside(double (*points)[2], int count, double spacing, random_source *source) {
    const double width = 1.0 - spacing;
    const int wished = (int)(sqrt((double)count * 1.1547005383792515) + 0.5); /* 2 / sqrt(3) */
    const int rows = wished < 1 ? 1 : wished;
    int next = 0;
    for (int row = 0; row < rows; row++) {
        const int end = (int)((long)(row + 1) * count / rows);
        const int in_row = end - next;
        const double offset = row % 2 == 0 ? 0.25 : 0.75;
        for (int k = 0; next < end; next++, k++) {
            const double x = ((double)k + offset) / (double)in_row - 0.5;
            const double y = ((double)row + 0.5) / (double)rows - 0.5;
            points[next][0] = x * width + ROW_JITTER * spacing * random_signed(source);
            points[next][1] = y * width + ROW_JITTER * spacing * random_signed(source);
        }
    }
    assert(next == count);
}

static int cell_of(const cell_grid *grid, double coordinate) {
    const int cell = (int)((coordinate + 0.5) * grid->side);
    return cell < 0 ? 0 : cell >= grid->side ? grid->side - 1 : cell;
}

static void fill_grid(cell_grid *grid, double (*points)[2], int count) {
    const int cells = grid->side * grid->side;
    memset(grid->start, 0, ((size_t)cells + 1) * sizeof *grid->start);
    for (int i = 0; i < count; i++)
        grid->start[cell_of(grid, points[i][1]) * grid->side + cell_of(grid, points[i][0])]++;
    for (int c = 0, sum = 0; c <= cells; c++) {
        sum += grid->start[c];
        grid->start[c] = sum;
    }
    for (int i = count - 1; i >= 0; i--) {
        const int c = cell_of(grid, points[i][1]) * grid->side + cell_of(grid, points[i][0]);
        grid->item[--grid->start[c]] = i;
    }
    assert(grid->start[0] == 0 && grid->start[cells] == count);
}

/** Adds to `push` the repulsion of `point` by the points in one row of neighbouring cells. A point
 *  at a distance d below `reach` repels by `reach` - d. */
static void repel(const cell_grid *grid, double (*points)[2], int point, int row, double reach,
                  double push[2]) {
    const int column = cell_of(grid, points[point][0]);
    const int first = row * grid->side + (column > 0 ? column - 1 : 0);
    const int last = row * grid->side + (column + 1 < grid->side ? column + 1 : column);
    for (int k = grid->start[first]; k < grid->start[last + 1]; k++) {
        const int other = grid->item[k];
        const double dx = points[point][0] - points[other][0];
        const double dy = points[point][1] - points[other][1];
        const double square = dx * dx + dy * dy;
        if (square >= reach * reach || square == 0.0)
            continue;
        const double distance = sqrt(square);
        const double strength = reach / distance - 1.0;
        push[0] += strength * dx;
        push[1] += strength * dy;
    }
}

static void relax(cell_grid *grid, double (*points)[2], double (*moved)[2], int count, int boundary,
                  double spacing) {
    const double reach = REACH * spacing, limit = 0.5 - MARGIN * spacing;
    fill_grid(grid, points, count);
    for (int i = boundary; i < count; i++) {
        const int row = cell_of(grid, points[i][1]);
        double push[2] = {0.0, 0.0};
        for (int r = row > 0 ? row - 1 : 0; r <= row + 1 && r < grid->side; r++)
            repel(grid, points, i, r, reach, push);
        moved[i][0] = clamp(points[i][0] + REPULSION * push[0], limit);
        moved[i][1] = clamp(points[i][1] + REPULSION * push[1], limit);
    }
    memcpy(points + boundary, moved + boundary, (size_t)(count - boundary) * sizeof *points);
}

int mesh_points(double (*points)[2], int count, int boundary, unsigned seed) {
    assert(boundary >= 4 && count > boundary);
    random_source source = {seed};
    arrays own = {0};
    /* A border point occupies half the area of an inner one. */
    const double area = 1.0 / (count - boundary + 0.5 * boundary - 1.0);
    const double spacing = sqrt(1.1547005383792515 * area); /* triangular lattice: 2 / sqrt(3) */
    cell_grid grid = {(int)(1.0 / (REACH * spacing)), NULL, NULL};
    if (grid.side < 1)
        grid.side = 1;
    place_border(points, boundary, &source);
    place_inside(points + boundary, count - boundary, spacing, &source);
    grid.start = arrays_add(&own, (size_t)grid.side * (size_t)grid.side + 1, sizeof *grid.start);
    grid.item = arrays_add(&own, (size_t)count, sizeof *grid.item);
    double(*moved)[2] = arrays_add(&own, (size_t)count, sizeof *moved);
    for (int k = 0; !own.failed && k < RELAXATIONS; k++)
        relax(&grid, points, moved, count, boundary, spacing);
    arrays_free(&own);
    return own.failed ? -1 : 0;
}
