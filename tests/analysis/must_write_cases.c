/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Cases of the must-write proof; must_write_cases.ir is made from this file by the frontend. In each
 * function whose name begins with proved_, early_ (read before written) or unknown_, the variable f
 * is analysed in the body of the outermost loop whose counter is t. If the name ends in _whole, all
 * of f is definitely assigned when an iteration ends; otherwise it is not.
 */
#include <math.h>
#include <string.h>

struct vector {
    double x, y, z;
};
struct padded {
    char tag;
    double value;
    int count;
};
struct body {
    struct vector at, speed;
    double mass[2];
};

void use(double);
void keep(const double *);
double peek(const double *) __attribute__((pure));
extern double *kept;

/* ---- scalars ------------------------------------------------------------------------------- */

void proved_scalar_whole(int n, const int *s) {
    int f;
    for (int t = 0; t < n; t++) {
        f = s[t];
        use(f);
    }
}

void early_scalar_then_written_whole(int n, const int *s) {
    int f = 0;
    for (int t = 0; t < n; t++) {
        use(f);
        f = s[t];
    }
}

void early_scalar_whole(int n, const int *s) {
    int f = 0;
    for (int t = 0; t < n; t++) {
        f += s[t];
    }
}

void early_scalar_incremented_whole(int n) {
    int f = 0;
    for (int t = 0; t < n; t++)
        f++;
}

void proved_never_used(int n) {
    double f[2];
    for (int t = 0; t < n; t++)
        use(1.0);
    use(f[0]);
}

void early_only_read(int n) {
    double f[2] = {0};
    for (int t = 0; t < n; t++)
        use(f[1]);
}

void proved_if_else_whole(int n, const int *s) {
    double f;
    for (int t = 0; t < n; t++) {
        if (s[t] > 0)
            f = 1.0;
        else
            f = 2.0;
        use(f);
    }
}

void early_if(int n, const int *s) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        if (s[t] > 0)
            f = 1.0;
        use(f);
    }
}

void proved_if_inside(int n, const int *s) {
    double f = 0;
    for (int t = 0; t < n; t++)
        if (s[t] > 0) {
            f = 1.0;
            use(f);
        }
}

void proved_continue(int n, const int *s) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        if (s[t] > 0)
            continue;
        f = 1.0;
        use(f);
    }
}

void proved_continue_after_whole(int n, const int *s) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        f = 1.0;
        if (s[t] > 0)
            continue;
        use(f);
    }
}

void early_and(int n, const int *s) {
    int f = 0;
    for (int t = 0; t < n; t++) {
        if (s[t] > 0 && (f = s[t + 1]) > 0)
            use(1.0);
        use(f);
    }
}

void proved_and_operand_whole(int n, const int *s) {
    int f = 0;
    for (int t = 0; t < n; t++)
        use((f = s[t]) > 0 && f < 7);
}

void early_or_operand(int n, const int *s) {
    int f = 0;
    for (int t = 0; t < n; t++)
        use((s[t] || (f = 1)) + f);
}

void early_conditional(int n, const int *s) {
    int f = 0;
    for (int t = 0; t < n; t++) {
        int g = s[t] ? (f = 1) : 2;
        use(f + g);
    }
}

void proved_conditional_whole(int n, const int *s) {
    int f = 0;
    for (int t = 0; t < n; t++) {
        int g = s[t] ? (f = 1) : (f = 2);
        use(f + g);
    }
}

void proved_comma_whole(int n, const int *s) {
    int f, g;
    for (int t = 0; t < n; t++)
        g = (f = s[t], f + 1), use(g);
}

/* The order in which the operands are evaluated is unspecified. */
void early_unsequenced_whole(int n, const int *s) {
    double f[1] = {0};
    for (int t = 0; t < n; t++)
        use(f[0] + (memset(f, 0, sizeof f) != 0) + s[t]);
}

void proved_sizeof_whole(int n) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        int size = (int)sizeof f;
        f = size;
        use(f);
    }
}

void proved_declared_inside(int n, const double *v) {
    for (int t = 0; t < n; t++) {
        double f[2];
        f[0] = v[t];
        use(f[0]);
    }
}

void unknown_static(int n, const double *v) {
    static double f;
    for (int t = 0; t < n; t++) {
        f = v[t];
        use(f);
    }
}

void unknown_volatile(int n, const double *v) {
    volatile double f;
    for (int t = 0; t < n; t++) {
        f = v[t];
        use(f);
    }
}

void proved_parameter_whole(int n, const double *v, double f) {
    for (int t = 0; t < n; t++) {
        f = v[t];
        use(f);
    }
}

/* ---- arrays and loops ------------------------------------------------------------------------ */

void proved_constant_loop_whole(int n, const double *v) {
    double f[3];
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 3; c++)
            f[c] = v[3 * t + c];
        use(f[0] + f[1] + f[2]);
    }
}

void early_short_loop(int n, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 2; c++)
            f[c] = v[3 * t + c];
        use(f[0] + f[1] + f[2]);
    }
}

void proved_short_loop(int n, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 2; c++)
            f[c] = v[3 * t + c];
        use(f[0] + f[1]);
    }
    use(f[2]);
}

void proved_nested_whole(int n, const double *v) {
    double f[3][3][3][3];
    int p, q, c, d;
    for (int t = 0; t < n; t++) {
        for (p = 0; p < 3; p++)
            for (q = 2; q >= 0; q--)
                for (c = 0; c < 3; ++c)
                    for (d = 0; d != 3; d += 1)
                        f[p][q][c][d] = v[p * 27 + q * 9 + c * 3 + d];
        use(f[2][2][2][2] + f[0][1][2][0]);
    }
}

void proved_linear_whole(int n, const double *v) {
    double f[9];
    for (int t = 0; t < n; t++) {
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                f[3 * a + b] = v[a] * v[b];
        use(f[8]);
    }
}

void proved_counted_other_way_whole(int n, const double *v) {
    double f[2][2];
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 4; c++)
            f[c / 2][c % 2] = v[c];
        use(f[1][1]);
    }
}

void proved_while_whole(int n, const double *v) {
    double f[4];
    for (int t = 0; t < n; t++) {
        int c = 4;
        while (c-- > 0)
            f[c] = v[c];
        use(f[0]);
    }
}

void proved_do_whole(int n, const double *v) {
    double f[4];
    for (int t = 0; t < n; t++) {
        int c = 0;
        do {
            f[c] = v[c];
        } while (++c < 4);
        use(f[3]);
    }
}

void proved_do_once_whole(int n, const int *s) {
    double f;
    for (int t = 0; t < n; t++) {
        int c = s[t];
        do {
            f = c;
        } while (--c > 0);
        use(f);
    }
}

void early_unknown_rounds(int n, int m, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < m; c++)
            f[c] = v[c];
        use(f[0]);
    }
}

void early_unknown_start(int n, int m, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (int c = m; c < 3; c++)
            f[c] = v[c];
        use(f[2]);
    }
}

void proved_read_in_unknown_rounds_whole(int n, const int *m, const double *v) {
    double f[3];
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = f[2] = v[t];
        for (int c = 0; c < m[t]; c++)
            use(f[c % 3] + f[1]);
    }
}

void early_read_with_unknown_subscript(int n, const int *m, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = v[t];
        use(f[m[t]]);
    }
}

void early_written_with_unknown_subscript(int n, const int *m, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        f[m[t]] = v[t];
        use(f[m[t]]);
    }
}

void early_counter_changed(int n, const int *m, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 3; c++) {
            f[c] = v[t];
            if (m[t])
                c++;
        }
        use(f[1]);
    }
}

void early_break(int n, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 3; c++) {
            if (v[t] < c)
                break;
            f[c] = v[t];
        }
        use(f[0]);
    }
}

void early_inner_continue(int n, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 3; c++) {
            if (v[t] < c)
                continue;
            f[c] = v[t];
        }
        use(f[0]);
    }
}

void proved_inner_continue_after_whole(int n, const double *v) {
    double f[3];
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 3; c++) {
            f[c] = v[t];
            if (v[t] < c)
                continue;
            use(f[c]);
        }
        use(f[0]);
    }
}

void proved_endless_with_break_whole(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        int c = 0;
        for (;;) {
            f[c] = v[t];
            if (++c == 2)
                break;
        }
        use(f[1]);
    }
}

void proved_endless_unknown_end_whole(int n, const double *v) {
    double f;
    for (int t = 0; t < n; t++) {
        int c = t;
        while (1) {
            f = v[c];
            if (v[++c] < 0)
                break;
        }
        use(f);
    }
}

void early_carried_in_inner_loop(int n, int m, const double *v) {
    double f = 0;
    for (int t = 0; t < n; t++)
        for (int c = 0; c < m; c++) {
            if (c > 0)
                use(f);
            f = v[c];
        }
}

void proved_outer_loop(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++)
        for (int c = 0; c < n; c++) {
            f[0] = v[c];
            f[1] = v[t];
            use(f[0] + f[1]);
        }
}

void unknown_out_of_bounds(int n, const double *v) {
    double f[3];
    for (int t = 0; t < n; t++) {
        for (int c = 0; c <= 3; c++)
            f[c] = v[c];
        use(f[0]);
    }
}

void unknown_too_large(int n, const double *v) {
    double f[100000];
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        use(f[0]);
    }
}

void unknown_too_many_rounds(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        for (int a = 0; a < 30000; a++)
            for (int b = 0; b < 30000; b++)
                f[b % 2] = v[a];
        use(f[0]);
    }
}

void early_as_much_as_it_takes(int n, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        for (int a = 0; a < 300000000; a++)
            if (v[a] > v[t])
                f[0] = v[a];
        use(f[0]);
    }
}

void proved_large_whole(int n, const double *v) {
    double f[1024];
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 1024; c++)
            f[c] = v[c];
        for (int c = 1023; c >= 0; c--)
            use(f[c]);
    }
}

void unknown_variable_length(int n, int m, const double *v) {
    double f[m];
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        use(f[0]);
    }
}

/* ---- switch -------------------------------------------------------------------------------- */

void proved_switch_whole(int n, const int *s) {
    double f;
    for (int t = 0; t < n; t++) {
        switch (s[t] % 3) {
        case 0:
            f = 1.0;
            break;
        case 1:
        case 2:
            f = 2.0;
            break;
        default:
            f = 3.0;
        }
        use(f);
    }
}

void early_switch_without_default(int n, const int *s) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        switch (s[t]) {
        case 0:
            f = 1.0;
            break;
        case 1:
            f = 2.0;
            break;
        }
        use(f);
    }
}

void early_switch_fall_through(int n, const int *s) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        switch (s[t]) {
        case 0:
            f[0] = 1.0;
            /* fall through */
        default:
            f[1] = 2.0;
        }
        use(f[0]);
    }
}

void proved_switch_fall_through_whole(int n, const int *s) {
    double f[2];
    for (int t = 0; t < n; t++) {
        switch (s[t]) {
        case 0:
            f[0] = 1.0;
            f[1] = 2.0;
            break;
        case 1:
            f[0] = 1.0;
        default:
            f[0] = f[1] = 2.0;
        }
        use(f[0] + f[1]);
    }
}

void proved_switch_continue(int n, const int *s) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        switch (s[t]) {
        case 0:
            continue;
        default:
            f = 1.0;
        }
        use(f);
    }
}

void unknown_jump_into_loop(int n, const int *s) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        switch (s[t]) {
            for (int c = 0; c < 3; c++) {
            case 0:
                f = 1.0;
            case 1:
                use(f);
            }
        }
    }
}

void unknown_goto(int n, const int *s) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        if (s[t])
            goto skip;
        f = 1.0;
    skip:
        use(f);
    }
}

/* ---- records ------------------------------------------------------------------------------- */

void proved_members_whole(int n, const double *v) {
    struct vector f, g;
    for (int t = 0; t < n; t++) {
        f.x = v[t];
        f.y = f.x;
        f.z = f.y;
        g = f;
        use(g.x);
    }
}

void early_members(int n, const double *v) {
    struct vector f = {0}, g;
    for (int t = 0; t < n; t++) {
        f.x = v[t];
        f.z = f.x;
        g = f;
        use(g.x);
    }
}

void proved_padding_whole(int n, const double *v) {
    struct padded f, g;
    for (int t = 0; t < n; t++) {
        f.tag = 'a';
        f.value = v[t];
        f.count = t;
        g = f;
        use(g.value);
    }
}

void early_padding_by_bytes_whole(int n, const double *v) {
    struct padded f, g;
    for (int t = 0; t < n; t++) {
        f.tag = 'a';
        f.value = v[t];
        f.count = t;
        memcpy(&g, &f, sizeof g);
        use(g.value);
    }
}

void proved_assigned_record_whole(int n, const struct body *b) {
    struct body f;
    for (int t = 0; t < n; t++) {
        f = b[t];
        use(f.at.x + f.speed.z + f.mass[t % 2]);
    }
}

void proved_member_array(int n, const double *v) {
    struct body f;
    for (int t = 0; t < n; t++) {
        f.mass[0] = f.mass[1] = v[t];
        use(f.mass[t % 2]);
    }
    use(f.at.x);
}

void early_member_array(int n, const double *v) {
    struct body f = {0};
    for (int t = 0; t < n; t++) {
        f.mass[0] = v[t];
        use(f.mass[t % 2]);
    }
}

static struct vector make(double v) {
    struct vector made = {v, v, v};
    return made;
}

void proved_returned_record_whole(int n, const double *v) {
    struct vector f;
    for (int t = 0; t < n; t++) {
        f = make(v[t]);
        use(f.x * f.y);
    }
}

static double length(struct vector a) {
    return a.x + a.y + a.z;
}

void early_record_argument(int n, const double *v) {
    struct vector f = {0};
    for (int t = 0; t < n; t++) {
        f.x = f.y = v[t];
        use(length(f));
    }
}

void proved_compound_literal_whole(int n, const double *v) {
    struct vector f;
    for (int t = 0; t < n; t++) {
        f = (struct vector){v[t], 0, 1};
        use(f.x);
    }
}

void early_initialiser_of_another_whole(int n, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        double g[2] = {v[t], f[1]};
        f[0] = g[0];
        f[1] = g[1];
    }
}

/* ---- pointers ------------------------------------------------------------------------------ */

void proved_row_pointer_whole(int n, const double *v) {
    double f[3][3];
    for (int t = 0; t < n; t++) {
        for (int a = 0; a < 3; a++) {
            double *p = f[a];
            for (int c = 0; c < 3; c++)
                p[c] = v[c];
        }
        use(f[2][2]);
    }
}

void proved_walking_pointer_whole(int n, const double *v) {
    double f[4];
    for (int t = 0; t < n; t++) {
        double *p = f;
        for (int c = 0; c < 4; c++)
            *p++ = v[c];
        use(f[3]);
    }
}

void proved_pointer_to_end_whole(int n, const double *v) {
    double f[4];
    for (int t = 0; t < n; t++) {
        for (double *p = f; p < f + 4; p++)
            *p = v[t];
        use(f[3]);
    }
}

void early_pointer_chosen(int n, const int *s) {
    double f[2] = {0}, g[2];
    for (int t = 0; t < n; t++) {
        double *p = s[t] ? f : g;
        p[0] = p[1] = 1.0;
        use(f[0]);
    }
}

void early_pointer_moved_in_loop(int n, const int *s) {
    double f[4] = {0};
    for (int t = 0; t < n; t++) {
        double *p = f;
        for (int c = 0; c < s[t]; c++)
            p++;
        *p = 1.0;
        use(f[0]);
    }
}

void unknown_pointer_stored(int n, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = v[t];
        kept = f;
    }
}

void unknown_pointer_in_record(int n, const double *v) {
    double f[2] = {0};
    struct holder {
        double *p;
    } h;
    for (int t = 0; t < n; t++) {
        h.p = f;
        h.p[0] = v[t];
        use(f[0]);
    }
}

void unknown_pointer_before_loop(int n, const double *v) {
    double f[2] = {0};
    double *p = f;
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        use(p[0] + f[0]);
    }
}

void unknown_pointer_left_behind(int n, const double *v) {
    double f[2], *p = 0;
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = v[t];
        p = f;
        use(p[0]);
    }
    use(p[0]);
}

void proved_pointer_not_left_behind_whole(int n, const double *v) {
    double f[2], *p;
    for (int t = 0; t < n; t++) {
        p = f;
        p[0] = p[1] = v[t];
        use(f[0]);
    }
}

void early_pointer_from_last_iteration(int n, const double *v) {
    double f[2] = {0}, *p;
    for (int t = 0; t < n; t++) {
        if (t > 0)
            use(p[0]);
        f[0] = v[t];
        p = f;
    }
}

void unknown_pointer_as_number(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        unsigned long address = (unsigned long)f;
        f[0] = f[1] = v[t];
        use((double)address);
    }
}

void unknown_pointer_address(int n, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        double *p = f, **q = &p;
        (*q)[0] = v[t];
        use(f[0]);
    }
}

void proved_address_after_loop_whole(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = v[t];
        use(f[0]);
    }
    keep(f);
}

void unknown_address_after_inner_loop(int n, const double *v) {
    double f[2];
    for (int round = 0; round < 3; round++) {
        for (int t = 0; t < n; t++) {
            f[0] = f[1] = v[t];
            use(f[0]);
        }
        keep(f);
    }
}

/* ---- calls --------------------------------------------------------------------------------- */

static void fill(const double *v, double *to) {
    for (int c = 0; c < 3; c++)
        to[c] = v[c];
}

static void fill_n(int count, double value, double *to) {
    for (int c = 0; c < count; c++)
        to[c] = value;
}

static void fill_rows(double to[3][3], const double *v) {
    for (int a = 0; a < 3; a++)
        fill(v, to[a]);
}

static void fill_if(const double *v, double *to) {
    if (v[0] < 0)
        return;
    to[0] = v[0];
}

static void fill_or(const double *v, double *to) {
    if (v[0] < 0) {
        to[0] = 0;
        return;
    }
    to[0] = v[0];
}

static void twice(double *to) {
    to[0] = 2 * to[0];
}

static void hide(double *p) {
    kept = p;
}

static void deep(int level, double *p) {
    if (level > 0)
        deep(level - 1, p);
    else
        p[0] = 1.0;
}

static double *second(double *p) {
    return p + 1;
}

static void swap(double *a, double *b) {
    double c = *a;
    *a = *b;
    *b = c;
}

void proved_callee_whole(int n, const double *v) {
    double f[3];
    for (int t = 0; t < n; t++) {
        fill(v + t, f);
        use(f[2]);
    }
}

void early_callee(int n, const double *v) {
    double f[4] = {0};
    for (int t = 0; t < n; t++) {
        fill(v + t, f);
        use(f[3]);
    }
}

void proved_callee_by_parts_whole(int n, const double *v) {
    double f[6];
    for (int t = 0; t < n; t++) {
        fill(v + t, f);
        fill(v + t, &f[3]);
        use(f[5]);
    }
}

void unknown_callee_beyond(int n, const double *v) {
    double f[5];
    for (int t = 0; t < n; t++) {
        fill(v + t, f);
        fill(v + t, &f[3]);
        use(f[4]);
    }
}

void proved_callee_constant_count_whole(int n, const double *v) {
    double f[5];
    for (int t = 0; t < n; t++) {
        fill_n(5, v[t], f);
        use(f[4]);
    }
}

void early_callee_other_count(int n, const double *v) {
    double f[5] = {0};
    for (int t = 0; t < n; t++) {
        fill_n(4, v[t], f);
        use(f[4]);
    }
}

void early_callee_unknown_count(int n, const double *v) {
    double f[5] = {0};
    for (int t = 0; t < n; t++) {
        fill_n(n % 6, v[t], f);
        use(f[0]);
    }
}

void proved_callee_nested_whole(int n, const double *v) {
    double f[3][3];
    for (int t = 0; t < n; t++) {
        fill_rows(f, v + t);
        use(f[2][2]);
    }
}

void early_callee_returns_early(int n, const double *v) {
    double f[1] = {0};
    for (int t = 0; t < n; t++) {
        fill_if(v + t, f);
        use(f[0]);
    }
}

void proved_callee_both_returns_whole(int n, const double *v) {
    double f;
    for (int t = 0; t < n; t++) {
        fill_or(v + t, &f);
        use(f);
    }
}

void early_callee_reads_whole(int n) {
    double f = 1;
    for (int t = 0; t < n; t++)
        twice(&f);
}

void proved_callee_reads_whole(int n, const double *v) {
    double f;
    for (int t = 0; t < n; t++) {
        f = v[t];
        twice(&f);
        use(f);
    }
}

void unknown_callee_keeps(int n, const double *v) {
    double f[1];
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        hide(f);
    }
}

void unknown_callee_without_body(int n, const double *v) {
    double f[1];
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        keep(f);
    }
}

void unknown_callee_kept_before(int n, const double *v) {
    double f[1];
    keep(f);
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        use(f[0]);
    }
}

void proved_callee_before_whole(int n, const double *v) {
    double f[3];
    fill(v, f);
    memset(f, 0, sizeof f);
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = f[2] = v[t];
        use(f[0]);
    }
}

void proved_pure_callee_whole(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = v[t];
        use(peek(f));
    }
}

void early_pure_callee(int n, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        use(peek(f));
    }
}

void unknown_recursive_callee(int n) {
    double f[1];
    for (int t = 0; t < n; t++) {
        deep(n, f);
        use(f[0]);
    }
}

void proved_returned_pointer_whole(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        *second(f) = v[t];
        f[0] = f[1];
        use(f[0]);
    }
}

void early_two_pointers_whole(int n, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        swap(&f[0], &f[1]);
        use(f[1]);
    }
}

void proved_two_pointers_whole(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        f[0] = v[t];
        f[1] = v[t + 1];
        swap(&f[0], f + 1);
        use(f[1]);
    }
}

void unknown_function_pointer(int n, void (*g)(double *)) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        g(f);
        use(f[0]);
    }
}

/* ---- library functions ---------------------------------------------------------------------- */

void proved_memset_whole(int n) {
    double f[4];
    for (int t = 0; t < n; t++) {
        memset(f, 0, sizeof f);
        f[t % 4] += 1.0;
        use(f[0]);
    }
}

void early_memset(int n) {
    double f[4] = {0};
    for (int t = 0; t < n; t++) {
        memset(f, 0, 3 * sizeof f[0]);
        use(f[3]);
    }
}

void early_memset_unknown_length(int n) {
    double f[4] = {0};
    for (int t = 0; t < n; t++) {
        memset(f, 0, (unsigned long)n);
        use(f[0]);
    }
}

void proved_memcpy_whole(int n, const double *v) {
    double f[4], g[4];
    for (int t = 0; t < n; t++) {
        memcpy(f, v + t, sizeof f);
        memcpy(g, f, sizeof g);
        use(g[3]);
    }
}

void early_memcpy_from(int n) {
    double f[4] = {0}, g[4];
    for (int t = 0; t < n; t++) {
        memcpy(g, f, sizeof g);
        use(g[0]);
        memcpy(f, g, n % 32);
    }
}

void unknown_memcpy_result_kept(int n, const double *v) {
    double f[1];
    for (int t = 0; t < n; t++)
        kept = memcpy(f, v + t, sizeof f);
}

void proved_frexp_whole(int n, const double *v) {
    int f;
    for (int t = 0; t < n; t++) {
        double m = frexp(v[t], &f);
        use(m + f);
    }
}

/* ---- text that the syntax tree does not show -------------------------------------------------- */

void unknown_size_of_inner_array(int n, const int *s) {
    int f = 1;
    for (int t = 0; t < n; t++) {
        double g[f];
        g[0] = s[t];
        f = s[t];
        use(g[0]);
    }
}

void proved_other_inner_array_whole(int n, int m, const double *v) {
    double f;
    for (int t = 0; t < n; t++) {
        double g[m];
        g[0] = v[t];
        f = g[0];
        use(f);
    }
}

/* ---- orders of evaluation, and forms of expressions -------------------------------------------- */

static double filled(double *p) {
    p[0] = 1.0;
    return 1.0;
}

static double first(const double *p) {
    return p[0];
}

static double both(double a, double b) {
    return a + b;
}

static void reset(struct body *b, double v) {
    b->at.x = b->at.y = b->at.z = v;
    b->speed = b->at;
    for (int c = 0; c < 2; c++)
        b->mass[c] = v;
}

static void reset_but_one(struct body *b, double v) {
    b->at.x = b->at.z = v;
    b->speed = make(v);
    b->mass[0] = b->mass[1] = v;
}

void early_two_calls_whole(int n) {
    double f[1] = {0};
    for (int t = 0; t < n; t++)
        use(filled(f) + first(f));
}

void early_two_calls_other_order_whole(int n) {
    double f[1] = {0};
    for (int t = 0; t < n; t++)
        use(first(f) * filled(f));
}

void early_call_arguments_whole(int n) {
    double f[1] = {0};
    for (int t = 0; t < n; t++)
        use(both(filled(f), first(f)));
}

void early_assigned_by_its_own_call_whole(int n) {
    double f[1] = {0};
    for (int t = 0; t < n; t++)
        f[0] += filled(f);
}

void early_initialisers_whole(int n) {
    double f[1] = {0};
    for (int t = 0; t < n; t++) {
        double g[2] = {filled(f), f[0]};
        use(g[1]);
    }
}

void early_subscript_order_whole(int n, double *out) {
    double f[1] = {0};
    for (int t = 0; t < n; t++)
        out[(int)filled(f)] = f[0];
}

void proved_comma_calls_whole(int n) {
    double f[1];
    for (int t = 0; t < n; t++)
        filled(f), use(first(f));
}

void proved_record_callee_whole(int n, const double *v) {
    struct body f, copy;
    for (int t = 0; t < n; t++) {
        reset(&f, v[t]);
        copy = f;
        use(copy.mass[0]);
    }
}

void early_record_callee(int n, const double *v) {
    struct body f = {0};
    for (int t = 0; t < n; t++) {
        reset_but_one(&f, v[t]);
        use(f.at.y);
    }
}

void proved_record_pointer_whole(int n, const double *v) {
    struct vector f;
    for (int t = 0; t < n; t++) {
        struct vector *p = &f;
        p->x = v[t];
        (*p).y = p->x;
        (&f)->z = -p->y;
        use(f.z);
    }
}

void proved_constant_condition_whole(int n, const double *v) {
    double f;
    const int on = 1;
    for (int t = 0; t < n; t++) {
        const int dimension = 3, off = !dimension;
        if (dimension == 3 && !off)
            f = v[t];
        use(f + (off ? f : on));
    }
}

void proved_constant_before_the_loop_whole(int n, const double *v) {
    double f[3];
    const int dimension = 3;
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < dimension; c++)
            f[c] = v[t];
        use(f[2]);
    }
}

void early_variable_before_the_loop(int n, const double *v) {
    double f[3] = {0};
    int dimension = 3;
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < dimension; c++)
            f[c] = v[t];
        use(f[2]);
        dimension = 2;
    }
}

void early_constant_condition_not_taken(int n, const double *v) {
    double f = 0;
    for (int t = 0; t < n; t++) {
        const int dimension = 2;
        if (dimension > 2)
            f = v[t];
        use(f);
    }
}

void early_counter_starts_beyond(int n, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (unsigned char c = 254; c < 3; c++)
            f[c] = v[t];
        use(f[0]);
    }
}

void early_unsigned_comparison(int n, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) {
        for (int c = -1; c < 3u; c++) /* -1 is converted to unsigned and not less than 3u */
            f[c + 1] = v[t];
        use(f[0]);
    }
}

void early_halves_of_complex(int n, const double *v) {
    _Complex double f = 0;
    for (int t = 0; t < n; t++) {
        __real__ f = v[t];
        __imag__ f = v[t];
        use(__real__ f);
    }
}

void proved_voided_whole(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        (void)f;
        (void)f[1];
        f[0] = f[1] = v[t];
    }
}

void unknown_cast_to_bytes_beyond(int n, const double *v) {
    double f[2];
    for (int t = 0; t < n; t++) {
        char *p = (char *)f;
        p[16] = 0;
        f[0] = v[t];
        use(f[0]);
    }
}

void early_bytes(int n, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) {
        char *p = (char *)f;
        for (int c = 0; c < 8; c++)
            use(p[c]);
        f[t % 2] = v[t];
    }
}

void unknown_address_returned_before(int n, const double *v) {
    double f[2] = {0};
    double *p = second(f);
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = v[t];
        use(p[0]);
    }
}

void proved_address_cast_before_whole(int n, const double *v) {
    double f[2];
    memset((char *)&f[0], 0, 8);
    filled(&f[1]);
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = v[t];
        use(f[1]);
    }
}

void unknown_returns_in_iteration(int n, const double *v, int *found) {
    double f[2], *g = f;
    for (int t = 0; t < n; t++) {
        f[0] = f[1] = v[t];
        if (v[t] < 0)
            return;
    }
    *found = g[0] > 0;
}

void proved_break_of_the_loop(int n, const double *v) {
    double f;
    for (int t = 0; t < n; t++) {
        if (v[t] < 0)
            break;
        f = v[t];
        use(f);
    }
}

/* ---- loops with the same header ------------------------------------------------------------- */

void proved_read_by_the_same_header(int n, int m, const double *v) {
    double f[9];
    for (int t = 0; t < n; t++) {
        for (int i = 0; i < m; i++)
            f[i] = v[t];
        for (int j = 0; j < m; j++)
            use(f[j]);
    }
}

void proved_read_by_two_counters(int n, unsigned low, unsigned high, const double *v) {
    double f[9];
    int i, k;
    for (int t = 0; t < n; t++) {
        for (k = 0, i = low; i <= high; ++i, ++k)
            f[k] = v[t];
        for (k = 0, i = low; i <= high; ++i, ++k)
            f[k] += v[i];
    }
}

void early_bound_of_the_header_changes(int n, const int *s, const double *v) {
    double f[9];
    for (int t = 0; t < n; t++) {
        int m = s[t];
        for (int i = 0; i < m; i++)
            f[i] = v[t];
        m++;
        for (int i = 0; i < m; i++)
            use(f[i]);
    }
}

void early_other_condition(int n, int m, const double *v) {
    double f[9];
    for (int t = 0; t < n; t++) {
        for (int i = 0; i < m; i++)
            f[i] = v[t];
        for (int i = 0; i <= m; i++)
            use(f[i]);
    }
}

void early_written_in_one_branch(int n, int m, const double *v) {
    double f[9];
    for (int t = 0; t < n; t++) {
        if (v[t] > 0)
            for (int i = 0; i < m; i++)
                f[i] = v[t];
        for (int i = 0; i < m; i++)
            use(f[i]);
    }
}

void early_element_behind_its_own(int n, int m, const double *v) {
    double f[9] = {0};
    for (int t = 0; t < n; t++) {
        for (int i = 1; i < m; i++)
            f[i] = v[t] + f[i - 1];
        for (int i = 1; i < m; i++)
            use(f[i]);
    }
}
