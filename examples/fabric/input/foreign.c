/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "input/foreign.h"

#include <stdio.h>

#ifndef FABRIC_WITH_ASSIMP

int foreign_read(mesh *m, const char *path, int y_up) {
    (void)y_up;
    *m = (mesh){0};
    fprintf(stderr,
            "%s: fabric was built without assimp (libassimp-dev), which reads this; "
            "expected an .obj or .ply file\n",
            path);
    return -1;
}

#else

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mesh/mesh_parts.h"

/* What the child leaves in the file between the two: a header; then positions and triangles, or the
 * bytes of a message. */
typedef struct header {
    int vertices, triangles; /* vertices 0: there is a message */
} header;

/** Column k of a 3 by 4 matrix is where axis k (3: the origin) goes. */
typedef struct transform {
    double column[4][3];
} transform;

static transform from_assimp(const struct aiMatrix4x4 *a) {
    return (transform){{{(double)a->a1, (double)a->b1, (double)a->c1},
                        {(double)a->a2, (double)a->b2, (double)a->c2},
                        {(double)a->a3, (double)a->b3, (double)a->c3},
                        {(double)a->a4, (double)a->b4, (double)a->c4}}};
}

/** The point, or with weight 0 the direction, after the transformation. */
static void apply(const transform *t, const double p[3], double weight, double result[3]) {
    for (int i = 0; i < 3; i++)
        result[i] = t->column[0][i] * p[0] + t->column[1][i] * p[1] + t->column[2][i] * p[2] +
                    t->column[3][i] * weight;
}

static transform product(const transform *outer, const transform *inner) {
    transform result;
    for (int k = 0; k < 4; k++)
        apply(outer, inner->column[k], k == 3 ? 1 : 0, result.column[k]);
    return result;
}

/** What the child makes: a mesh that grows by node and node. */
typedef struct collector {
    const struct aiScene *from;
    int y_up;
    mesh *into; /* arrays NULL: only count */
    long vertices, triangles;
} collector;

static void collect_mesh(collector *c, const struct aiMesh *part, const transform *t) {
    const long first = c->vertices;
    for (unsigned v = 0; v < part->mNumVertices; v++, c->vertices++) {
        const struct aiVector3D *at = &part->mVertices[v];
        double p[3] = {(double)at->x, (double)at->y, (double)at->z}, moved[3];
        if (!c->into->position)
            continue;
        apply(t, p, 1, moved);
        double *to = c->into->position[c->vertices];
        to[0] = moved[0];
        to[1] = c->y_up ? -moved[2] : moved[1];
        to[2] = c->y_up ? moved[1] : moved[2];
    }
    for (unsigned f = 0; f < part->mNumFaces; f++) {
        const struct aiFace *face = &part->mFaces[f];
        if (face->mNumIndices != 3)
            continue; /* a point or a line */
        for (int p = 0; c->into->position && p < 3; p++)
            c->into->triangle[c->triangles][p] =
                face->mIndices[p] < part->mNumVertices ? (int)(first + face->mIndices[p]) : -1;
        c->triangles++;
    }
}

static void collect_node(collector *c, const struct aiNode *node, const transform *above,
                         int depth) {
    const transform own = from_assimp(&node->mTransformation), all = product(above, &own);
    if (depth > 1000)
        return; /* a ring of nodes */
    for (unsigned k = 0; k < node->mNumMeshes; k++)
        collect_mesh(c, c->from->mMeshes[node->mMeshes[k]], &all);
    for (unsigned k = 0; k < node->mNumChildren; k++)
        collect_node(c, node->mChildren[k], &all, depth + 1);
}

static void collect(collector *c) {
    static const transform identity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
    c->vertices = c->triangles = 0;
    collect_node(c, c->from->mRootNode, &identity, 0);
}

static const char *collect_all(const char *path, int y_up, mesh *m) {
    collector c = {aiImportFile(path, aiProcess_Triangulate), y_up, m, 0, 0};
    if (!c.from)
        return aiGetErrorString();
    if (!c.from->mRootNode)
        return "it has no nodes";
    collect(&c);
    if (c.triangles == 0 || c.vertices > INT_MAX / 3 || c.triangles > INT_MAX / 3)
        return c.triangles == 0 ? "it has no triangles, expected some" : "it is too large";
    if (mesh_allocate(m, (int)c.vertices, (int)c.triangles) != 0)
        return "out of memory";
    collect(&c);
    return NULL;
}

/** A damaged file may ask for any memory and time: half of the machine's, and a minute and more
 *  for large ones. An address space that is larger already (a sanitizer's) is left alone. */
static void limit_resources(const char *path) {
    struct stat status = {0};
    unsigned long pages = 0;
    const rlim_t page = (rlim_t)sysconf(_SC_PAGESIZE);
    FILE *used = fopen("/proc/self/statm", "r");
    const rlim_t half = (rlim_t)sysconf(_SC_PHYS_PAGES) / 2 * page;
    if (used && fscanf(used, "%lu", &pages) == 1 && pages * page < half)
        setrlimit(RLIMIT_AS, &(struct rlimit){half, half});
    if (used)
        fclose(used);
    stat(path, &status);
    const rlim_t seconds = 60 + (rlim_t)status.st_size / 1000000;
    setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds});
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
}

/** The child: does not return. What libraries say on standard error is not for the user. */
static void read_in_child(const char *path, int y_up, FILE *between) {
    mesh m = {0};
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
    limit_resources(path);
    const char *message = collect_all(path, y_up, &m);
    const header h = {message ? 0 : m.vertex_count, message ? 0 : m.triangle_count};
    fwrite(&h, sizeof h, 1, between);
    if (message)
        fputs(message, between);
    else {
        fwrite(m.position, sizeof *m.position, (size_t)m.vertex_count, between);
        fwrite(m.triangle, sizeof *m.triangle, (size_t)m.triangle_count, between);
    }
    _exit(fflush(between) == 0 ? EXIT_SUCCESS : EXIT_FAILURE);
}

static int complain(const char *path, const char *problem) {
    fprintf(stderr, "%s: %s\n", path, problem);
    return -1;
}

/** What the child said, without the line ends that such messages may have. */
static int complain_as_child(const char *path, FILE *between) {
    char message[256];
    message[fread(message, 1, sizeof message - 1, between)] = '\0';
    message[strcspn(message, "\r\n")] = '\0';
    return complain(path, message);
}

static int take_over(mesh *m, const char *path, FILE *between) {
    header h;
    rewind(between);
    if (fread(&h, sizeof h, 1, between) != 1)
        return complain(path, "it cannot be read: it is damaged");
    if (h.vertices == 0)
        return complain_as_child(path, between);
    if (mesh_allocate(m, h.vertices, h.triangles) != 0)
        return complain(path, "out of memory");
    const size_t vertices = (size_t)h.vertices, triangles = (size_t)h.triangles;
    if (fread(m->position, sizeof *m->position, vertices, between) != vertices ||
        fread(m->triangle, sizeof *m->triangle, triangles, between) != triangles) {
        mesh_free(m);
        return complain(path, "it cannot be read: out of space for temporary files");
    }
    for (int v = 0; v < m->vertex_count; v++)
        memcpy(m->material[v], m->position[v], sizeof *m->material);
    return 0;
}

static int wait_for(pid_t child) {
    int status;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return -1;
    return status;
}

int foreign_read(mesh *m, const char *path, int y_up) {
    *m = (mesh){0};
    if (access(path, R_OK) != 0)
        return complain(path, strerror(errno));
    FILE *between = tmpfile();
    const pid_t child = between ? fork() : -1;
    int result = -1;
    if (child == 0)
        read_in_child(path, y_up, between);
    if (child < 0)
        complain(path, strerror(errno));
    else {
        const int status = wait_for(child);
        if (status == 0)
            result = take_over(m, path, between);
        else if (status > 0 && WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
            complain(path, "reading it takes too long: it is damaged");
        else
            complain(path, "it cannot be read: it is damaged");
    }
    if (between)
        fclose(between);
    return result;
}

#endif
