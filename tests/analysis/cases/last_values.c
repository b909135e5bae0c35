/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Private variables used after the loop (live-out), whose first use a search may miss. */

double written_in_one_branch(int n, int m, const int *s, const double *w, double *h) {
    double d = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    if (m)
        d = 0;
    return d;
}

double written_by_the_value_of_a_branch(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, e;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    e = m ? (d = 0) : 1;
    return d + e;
}

double written_in_both_branches(int n, int m, const int *s, const double *w, double *h) {
    double d = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) privates=1
        d = w[i];
        h[s[i]] += d;
    }
    if (m)
        d = 0;
    else
        d = 1;
    return d;
}

double written_by_a_loop_that_may_not_begin(int n, int m, const int *s, const double *w,
                                            double *h) {
    double d = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    for (int j = 0; j < m; j++)
        d = j;
    return d;
}

double written_behind_a_break(int n, int m, const int *s, const double *w, double *h) {
    double d = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    do {
        if (m)
            break;
        d = 0;
    } while (m < 0);
    return d;
}

double read_by_the_loop_around(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
    for (int j = 0; j < m; j++) {
        sum += d;
        for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
            d = w[i];
            h[s[i]] += d;
        }
    }
    return sum;
}

double read_in_a_later_case(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    switch (m) {
    case 0:
        d = 1;
        break;
    case 1:
        sum = d;
    }
    return sum;
}

double read_in_a_case_inside(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    switch (m) {
    case 0:
        if ((d = n) > 0) {
        case 1:
            sum = d;
        }
    }
    return sum;
}

double written_in_the_case_that_reads(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) privates=1
        d = w[i];
        h[s[i]] += d;
    }
    switch (m) {
    case 0:
        d = 1;
        sum = d;
        break;
    case 1:
        sum = (d = 2);
    }
    return sum;
}

double read_by_another_initialiser(int n, const int *s, const double *w, double *h) {
    double d = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    const double both[2] = {[1] = (d = 1), [0] = d};
    return both[0] + both[1];
}

double read_where_a_continue_leads_past(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) privates=1
        d = w[i];
        h[s[i]] += d;
    }
    for (int j = 0; j < m; j++) {
        if (s[j] < 0)
            continue;
        d = j;
        sum += d;
    }
    return sum;
}

double read_by_the_step_behind_a_continue(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    for (int j = 0; j < m; j++, sum += d) {
        if (s[j] < 0)
            continue;
        d = j;
    }
    return sum;
}

double written_before_each_return(int n, int m, const int *s, const double *w, double *h) {
    double d = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) privates=1
        d = w[i];
        h[s[i]] += d;
    }
    if (m)
        return m;
    d = 1;
    return d;
}

double read_in_the_next_round(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
    while (m-- > 0) {
        if (m == 3)
            sum += d;
        for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
            d = w[i];
            h[s[i]] += d;
        }
        if (m % 2)
            continue;
        d = 1;
    }
    return sum;
}

double written_in_the_next_round(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
    while (m-- > 0) {
        d = m;
        sum += d;
        for (int i = 0; i < n; i++) { // EXPECT: transform h(+) privates=1
            d = w[i];
            h[s[i]] += d;
        }
        if (m % 2)
            continue;
        sum += 1;
    }
    return sum;
}

double read_by_way_of_a_label(int n, int m, const int *s, const double *w, double *h) {
    double d = 0, sum = 0;
again:
    sum += d;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=d
        d = w[i];
        h[s[i]] += d;
    }
    if (--m > 0)
        goto again;
    return sum;
}

float kept_as_what_is_added(int n, const int *s, const double *w, const float *v, double *h) {
    float sum = 0, other = 0;
    double wide = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) sum=double other=float wide=double
        h[s[i]] += w[i];
        sum += w[i];
        other += v[i];
        wide += v[i];
    }
    return sum + other + (float)wide;
}

double added_sometimes(int n, const int *s, const double *w, double *h) {
    double sum = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) sum=double-sometimes
        h[s[i]] += w[i];
        if (w[i] > 0)
            sum += w[i];
    }
    return sum;
}
