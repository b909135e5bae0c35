/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An inner loop fills a table, and a later loop may read elements that the iteration has not written.
// tests/accept/window_tables.c has tables that may be private.
enum { N = 1000, TABLE = 40 };
static int s[N], c[N], some;
static double e[N], h[N];
int order_of_all;
void note(int *);

void bound_changes(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        int high = s[t];
        for (int k = 0; k < high; k++)
            w[k] = e[t];
        high += c[t];
        for (int k = 0; k < high; k++)
            h[s[t] + k] += w[k];
    }
}

void one_more(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 0; k < m; k++)
            w[k] = e[t];
        for (int k = 0; k <= m; k++)
            h[s[t] + k] += w[k];
    }
}

void another_start(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 1; k < m; k++)
            w[k] = e[t];
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
}

void another_step(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 0; k < m; k += 2)
            w[k] = e[t];
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
}

void another_element(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 0; k < m; k++)
            w[k] = e[t];
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k + 1];
    }
}

void sometimes_written(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 0; k < m; k++)
            if (c[k])
                w[k] = e[t];
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
}

void skipped(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 0; k < m; k++) {
            if (c[k])
                continue;
            w[k] = e[t];
        }
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
}

void ended(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 0; k < m; k++) {
            w[k] = e[t];
            if (c[k])
                break;
        }
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
}

void under_a_condition(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        if (c[t])
            for (int k = 0; k < m; k++)
                w[k] = e[t];
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
}

void in_a_switch(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        switch (c[t]) {
            for (int k = 0; k < m; k++)
                w[k] = e[t];
        case 1:
            for (int k = 0; k < m; k++)
                h[s[t] + k] += w[k];
        }
    }
}

void from_a_label_of_a_switch(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        double f = 0;
        switch (c[t]) {
        case 0:
            f = 1;
            for (int k = 0; k < m; k++)
                w[k] = e[t];
        case 1:
            f += 2;
            for (int k = 0; k < m; k++)
                h[s[t] + k] += w[k] * f;
        }
    }
}

void written_later(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
        for (int k = 0; k < m; k++)
            w[k] = e[t];
    }
}

void counter_in_the_reader(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        for (int k = 0; k < m; k++)
            w[k] = e[t];
        for (int k = 0; k < m; k++) {
            if (c[k])
                k++;
            h[s[t] + k] += w[k];
        }
    }
}

void counter_in_the_writer(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        for (int k = 0; k < m; k++) {
            if (c[k])
                k++;
            w[k] = e[t];
        }
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
}

void operand_of_the_subscript(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        int low = s[t];
        for (int k = low; k < low + m; k++)
            w[k - low] = e[t];
        for (int k = low; k < low + m; k++) {
            low = k & 1;
            h[s[t] + k] += w[k - low];
        }
    }
}

void other_counter(int n, int m) {
    double w[TABLE];
    int i = 0, k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (i = 0; i < m; i++)
            w[i] = e[t];
        for (k = 0; k < m; k++)
            h[s[t] + k] += w[i];
    }
}

void exchanged_counters(int n, int m) {
    double w[TABLE];
    int i, k;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        for (i = 0, k = m; i < m; i++, k += 2)
            w[i] = e[t];
        for (k = 0, i = m; k < m; k++, i += 2)
            h[s[t] + k] += w[i];
    }
}

void bound_of_all(int n) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int k = 0; k < order_of_all; k++)
            w[k] = e[t];
        for (int k = 0; k < order_of_all; k++)
            h[s[t] + k] += w[k];
    }
}

void bound_by_address(int n, int m) {
    double w[TABLE];
    note(&m);
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        for (int k = 0; k < m; k++)
            w[k] = e[t];
        note(0);
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
}

void not_started(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int k = 0;
        for (; k < m; k++)
            w[k] = e[t];
        for (; k < 2 * m; k++)
            h[s[t] + k] += w[k];
    }
}

void after_the_loop(int n, int m) {
    double w[TABLE];
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (k = 0; k < m; k++)
            w[k] = e[t];
        for (k = 0; k < m; k++)
            h[s[t] + k] += 1;
        h[s[t]] += w[k];
    }
}

double read_after_all(int n, int m) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: refuse last-value
        for (int k = 0; k < m; k++)
            w[k] = e[t];
        for (int k = 0; k < m; k++)
            h[s[t] + k] += w[k];
    }
    return w[some];
}
