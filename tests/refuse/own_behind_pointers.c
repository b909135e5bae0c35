/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/own_behind_pointers.c: the records are not an iteration's own.

struct part {
    int cell;
    float x;
    struct part *next;
};
struct species {
    int n;
    struct part *part;
    float *grid;
};

/* The pointer to the records changes. */
void moves(struct species *s, int n, float *to) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse element-type
        s->part[i].cell += 1;
        to[s->part[i].cell] += 1;
        s->part++;
    }
}

/* The value stored is a pointer and may overwrite the pointer to the records. */
void stores_pointers(struct species *s, int n, float *to) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        s->part[i].next = s->part;
        s->part[i].cell += 1;
        to[s->part[i].cell] += 1;
    }
}

/* The structure differs from iteration to iteration. */
void other_structure(struct species *s, int n, float *to) {
    for (int i = 0; i < n; i++) { // EXPECT: nothing
        s->part[i].cell += 1;
        to[s->part[i].cell] += 1;
        s = s + (i & 1);
    }
}

/* The loop reads another iteration's record. */
void neighbour(struct species *s, int n, float *to) {
    for (int i = 1; i < n; i++) { // EXPECT: nothing
        s->part[i].cell = s->part[i - 1].cell + 1;
        to[s->part[i].cell] += 1;
    }
}

void half(struct species *s, int n, float *to) {
    for (int i = 0; i < n; i++) { // EXPECT: nothing
        s->part[i / 2].cell += 1;
        to[s->part[i / 2].cell] += 1;
    }
}

/* A function of another file may change the pointer. */
void sort(struct species *s);
void calls(struct species *s, int n, float *to) {
    for (int i = 0; i < n; i++) { // EXPECT: nothing
        s->part[i].cell += 1;
        to[s->part[i].cell] += 1;
        if (i % 100 == 99)
            sort(s);
    }
}
