/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/exchange.h"

#include <stdint.h>
#include <string.h>

#include "output/fresh_file.h"

typedef enum byte_order { LITTLE, BIG } byte_order;

static void put_word(FILE *file, uint32_t word, byte_order order) {
    unsigned char bytes[4];
    for (int k = 0; k < 4; k++)
        bytes[k] = (unsigned char)(word >> (order == BIG ? 24 - 8 * k : 8 * k));
    fwrite(bytes, 1, sizeof bytes, file);
}

static void put_float(FILE *file, double number, byte_order order) {
    const float single = (float)number;
    uint32_t word;
    memcpy(&word, &single, sizeof word);
    put_word(file, word, order);
}

static int put_positions(const cloth_frames *frames, FILE *file, byte_order order) {
    for (int number = 0; number < frames->count; number++) {
        state s;
        if (frames->read(frames->context, number, &s) != 0)
            return -1;
        for (size_t k = 0; k < 3 * (size_t)frames->vertex_count; k++)
            put_float(file, s.position[k], order);
        state_free(&s);
    }
    return 0;
}

int pc2_write(const cloth_frames *frames, const char *path) {
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    fwrite("POINTCACHE2", 1, 12, f.file); /* with its 0 */
    put_word(f.file, 1, LITTLE);
    put_word(f.file, (uint32_t)frames->vertex_count, LITTLE);
    put_float(f.file, 0, LITTLE); /* the first frame */
    put_float(f.file, 1, LITTLE); /* frames a sample */
    put_word(f.file, (uint32_t)frames->count, LITTLE);
    return fresh_file_close(&f, put_positions(frames, f.file, LITTLE));
}

int mdd_write(const cloth_frames *frames, const char *path) {
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    put_word(f.file, (uint32_t)frames->count, BIG);
    put_word(f.file, (uint32_t)frames->vertex_count, BIG);
    for (int number = 0; number < frames->count; number++)
        put_float(f.file, frames->time[number], BIG);
    return fresh_file_close(&f, put_positions(frames, f.file, BIG));
}

int ply_write(const cloth_frames *frames, const state *s, const char *path) {
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    fprintf(f.file, "ply\nformat ascii 1.0\ncomment time %.9g s\n", s->time);
    fprintf(f.file, "element vertex %d\nproperty float x\nproperty float y\nproperty float z\n",
            frames->vertex_count);
    fprintf(f.file, "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
            frames->triangle_count);
    for (int v = 0; v < frames->vertex_count; v++)
        fprintf(f.file, "%.9g %.9g %.9g\n", s->position[3 * v], s->position[3 * v + 1],
                s->position[3 * v + 2]);
    for (int t = 0; t < frames->triangle_count; t++)
        fprintf(f.file, "3 %d %d %d\n", frames->triangle[3 * t], frames->triangle[3 * t + 1],
                frames->triangle[3 * t + 2]);
    return fresh_file_close(&f, 0);
}

int obj_frame_write(const cloth_frames *frames, const state *s, const char *path) {
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    for (int v = 0; v < frames->vertex_count; v++)
        fprintf(f.file, "v %.17g %.17g %.17g\n", s->position[3 * v], s->position[3 * v + 1],
                s->position[3 * v + 2]);
    for (int t = 0; t < frames->triangle_count; t++)
        fprintf(f.file, "f %d %d %d\n", frames->triangle[3 * t] + 1,
                frames->triangle[3 * t + 1] + 1, frames->triangle[3 * t + 2] + 1);
    return fresh_file_close(&f, 0);
}

static void put_cells(const cloth_frames *frames, FILE *file) {
    const int count = frames->triangle_count;
    fputs("<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n", file);
    for (int t = 0; t < count; t++)
        fprintf(file, "%d %d %d\n", frames->triangle[3 * t], frames->triangle[3 * t + 1],
                frames->triangle[3 * t + 2]);
    fputs("</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n", file);
    for (int t = 1; t <= count; t++)
        fprintf(file, "%d\n", 3 * t);
    fputs("</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n", file);
    for (int t = 0; t < count; t++)
        fputs("5\n", file); /* VTK_TRIANGLE */
    fputs("</DataArray>\n</Cells>\n", file);
}

int vtu_write(const cloth_frames *frames, const state *s, const char *path) {
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n", f.file);
    fprintf(f.file, "<UnstructuredGrid>\n<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n",
            frames->vertex_count, frames->triangle_count);
    fputs("<Points>\n<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n",
          f.file);
    for (int v = 0; v < frames->vertex_count; v++)
        fprintf(f.file, "%.9g %.9g %.9g\n", s->position[3 * v], s->position[3 * v + 1],
                s->position[3 * v + 2]);
    fputs("</DataArray>\n</Points>\n", f.file);
    put_cells(frames, f.file);
    fputs("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n", f.file);
    return fresh_file_close(&f, 0);
}

int pvd_write(const cloth_frames *frames, char (*file)[32], const char *path) {
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n",
          f.file);
    for (int k = 0; k < frames->count; k++)
        fprintf(f.file, "<DataSet timestep=\"%.9g\" part=\"0\" file=\"%s\"/>\n", frames->time[k],
                file[k]);
    fputs("</Collection>\n</VTKFile>\n", f.file);
    return fresh_file_close(&f, 0);
}
