/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/vtu.h"

#include "output/fresh_file.h"

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
