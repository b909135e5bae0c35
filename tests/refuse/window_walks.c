/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Pointers walk through a table. A loop may read elements that the iteration has not written, or a pointer may
// leave the table. tests/accept/window_walks.c has tables that may be private.
enum { N = 1000, TABLE = 40 };
static int s[N], c[N];
static double e[N], h[N], *kept;
void note(double *);
void note_pointer(double **);

void reads_from_the_second_on(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        for (p = w + 1, k = 0; k < m; k++, p++)
            h[s[t] + k] += *p;
    }
}

void reads_the_next(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        for (p = w, k = 0; k < m; k++, p++)
            h[s[t] + k] += p[1];
    }
}

void writes_every_second(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++, p += 2)
            *p = e[t];
        for (p = w, k = 0; k < m; k++, p++)
            h[s[t] + k] += *p;
    }
}

void body_writes_every_second(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++) {
            *p = e[t];
            p += 2;
        }
        for (p = w, k = 0; k < m; k++) {
            h[s[t] + k] += *p;
            p += 1;
        }
    }
}

void steps_back(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w + m, k = 0; k < m; k++) {
            *p = e[t];
            p--;
        }
        for (p = w + m, k = 0; k < m; k++) {
            h[s[t] + k] += *p;
            p++;
        }
    }
}

void writer_steps_sometimes(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++) {
            *p = e[t];
            if (c[k])
                p++;
        }
        for (p = w, k = 0; k < m; k++) {
            h[s[t] + k] += *p;
            p++;
        }
    }
}

void reader_steps_sometimes(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++) {
            *p = e[t];
            p++;
        }
        for (p = w, k = 0; k < m; k++) {
            h[s[t] + k] += *p;
            if (c[k])
                p++;
        }
    }
}

void both_step_sometimes(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++) {
            *p = e[t];
            if (c[k])
                p++;
        }
        for (q = w, k = 0; k < m; k++) {
            h[s[t] + k] += *q;
            if (c[k])
                q++;
        }
    }
}

void reader_steps_twice(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++) {
            *p = e[t];
            p++;
        }
        for (p = w, k = 0; k < m; k++) {
            p++;
            h[s[t] + k] += *p;
            p++;
        }
    }
}

void reader_steps_before(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++) {
            *p = e[t];
            p++;
        }
        for (p = w, k = 0; k < m; k++) {
            p++;
            h[s[t] + k] += *p;
        }
    }
}

void writer_steps_twice(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++, p++) {
            *p = e[t];
            p++;
        }
        for (q = w, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
    }
}

void used_after_the_step(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++)
            *p++ = e[t];
        for (q = w, k = 0; k < m; k++) {
            const double v = *q++;
            h[s[t] + k] += v * *q;
        }
    }
}

void writer_uses_it_after_the_step(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++) {
            const double v = (double)(p++ - w);
            *p = v + e[t];
        }
        for (q = w, k = 0; k < m; k++) {
            const double v = *q++;
            h[s[t] + k] += v;
        }
    }
}

void skips_its_step(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w + m, k = 0; k < m; k++)
            *p-- = e[t];
        for (q = w + m, k = 0; k < m; k++) {
            if (c[k])
                continue;
            const double v = *q--;
            h[s[t] + k] += v;
        }
    }
}

void goes_on(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        for (k = 0; k < m; k++, p++)
            h[s[t] + k] += *p;
    }
}

void goes_on_by_body(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        p = w;
        for (k = 0; k < m; k++)
            *p++ = e[t];
        for (k = 0; k < m; k++) {
            const double v = *p++;
            h[s[t] + k] += v;
        }
    }
}

void set_sometimes(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        p = w;
        for (k = 0; k < m; k++)
            *p++ = e[t];
        q = w + c[t];
        if (c[t])
            q = w;
        for (k = 0; k < m; k++) {
            const double v = *q++;
            h[s[t] + k] += v;
        }
    }
}

void moved_after_it_is_set(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        p = w;
        for (k = 0; k < m; k++)
            *p++ = e[t];
        q = w;
        q++;
        for (k = 0; k < m; k++) {
            const double v = *q++;
            h[s[t] + k] += v;
        }
    }
}

void start_has_changed(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        int low = s[t];
        for (p = w + low, k = 0; k < m; k++, p++)
            *p = e[t];
        low = c[t];
        for (q = w + low, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
    }
}

void start_changes_before_the_writer(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        int low = s[t];
        p = w + low;
        low = c[t];
        for (k = 0; k < m; k++)
            *p++ = e[t];
        q = w + low;
        for (k = 0; k < m; k++) {
            const double v = *q++;
            h[s[t] + k] += v;
        }
    }
}

void start_by_the_counter(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        k = c[t];
        p = w + k;
        for (k = 0; k < m; k++)
            *p++ = e[t];
        q = w + k;
        for (k = 0; k < m; k++) {
            const double v = *q++;
            h[s[t] + k] += v;
        }
    }
}

void end_has_changed(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        double *end = w + s[t];
        for (p = w; p < end; p++)
            *p = e[t];
        end = w + c[t];
        for (q = w; q < end; q++)
            h[s[t]] += *q;
    }
}

void past_a_label(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        int low = 0;
        p = w;
        for (k = 0; k < m; k++)
            *p++ = e[t];
        q = w + c[t];
        switch (c[t]) {
        case 0:
            low = 2;
            q = w;
        case 1:
            low = 1;
            for (k = 0; k < m; k++) {
                const double v = *q++ * low;
                h[s[t] + k] += v;
            }
        }
    }
}

void in_another_table(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        double other[TABLE];
        for (p = other, k = 0; k < m; k++, p++)
            *p = e[t];
        for (q = w, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
        w[0] = 1;
    }
}

void in_two_tables(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        double other[TABLE];
        for (p = other, k = 0; k < m; k++, p++)
            *p = e[t];
        for (p = w, k = 0; k < m; k++, p++)
            h[s[t] + k] += *p;
        w[0] = other[0];
    }
}

void address_given_away(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        note_pointer(&q);
        for (q = w, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
    }
}

void value_given_away(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        note(p);
        for (q = w, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
    }
}

void value_kept(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse escapes
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        kept = p;
        for (q = w, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
    }
}

void step_kept(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse escapes
        for (p = w, k = 0; k < m; k++)
            *p++ = e[t];
        kept = p--;
        for (q = w, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
    }
}

void start_of_the_reader_changes(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        int low = s[t];
        q = w + low;
        low = c[t];
        p = w + low;
        for (k = 0; k < m; k++)
            *p++ = e[t];
        for (k = 0; k < m; k++) {
            const double v = *q++;
            h[s[t] + k] += v;
        }
    }
}

void begins_at_another_element(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = &w[0], k = 0; k < m; k++, p++)
            *p = e[t];
        for (p = &w[1], k = 0; k < m; k++, p++)
            h[s[t] + k] += *p;
    }
}

void moved_in_its_declaration(int n, int m) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        p = w;
        for (k = 0; k < m; k++)
            *p++ = e[t];
        double *r = w, *other = r++;
        for (k = 0; k < m; k++) {
            const double v = *r++;
            h[s[t] + k] += v + (other == p);
        }
        q = w;
    }
}

void in_the_callers_table(int n, int m, double *from) {
    double w[TABLE], *p, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        for (p = from, k = 0; k < m; k++, p++)
            h[s[t] + k] += *p;
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        for (q = w, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
    }
}

double left_behind(int n, int m) {
    double w[TABLE], *p = w, *q;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        for (q = w, k = 0; k < m; k++, q++)
            h[s[t] + k] += *q;
    }
    return p[-1];
}

void set_outside(int n, int m) {
    double w[TABLE], *p = w, *q = w;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        for (k = 0; k < 3; k++)
            h[s[t] + k] += q[k];
    }
}

void of_the_iteration_before(int n, int m) {
    double w[TABLE], *p, *q = 0;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        if (t > 0)
            for (k = 0; k < m; k++)
                h[s[t] + k] += q[k];
        for (p = w, k = 0; k < m; k++, p++)
            *p = e[t];
        q = w;
    }
}
