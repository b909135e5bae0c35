/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* OpenMP directives with effects beyond parallel execution: they remain, and their loops are refused. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
enum { N = 1000 };
static double h[N], w[N], of_file;
static int s[N];
double total;

int omp_get_thread_num(void);

void orphaned(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#pragma omp atomic
        h[s[t]] += w[t];
    }
#pragma omp taskloop
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic
        h[s[t]] += w[t];
#pragma omp critical
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[s[t]] += w[t];
}

void clauses(int n) {
#pragma omp parallel for ordered
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#pragma omp ordered
        h[s[t]] += w[t];
    }
#pragma omp parallel for proc_bind(close)
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic
        h[s[t]] += w[t];
#pragma omp parallel for collapse(2)
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int t = 0; t < n; t++) // EXPECT: nothing
#pragma omp atomic
            h[s[t]] += w[i];
#pragma omp parallel for simd reduction(+ : h)
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[s[t]] += w[t];
    int at = 0;
#pragma omp parallel for linear(at : 1)
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#pragma omp atomic
        h[s[t]] += w[t];
        at++;
    }
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        if (t == n / 2) {
#pragma omp cancel for
        }
#pragma omp atomic
        h[s[t]] += w[t];
    }
}

void locks(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#pragma omp atomic seq_cst
        h[s[t]] += w[t];
    }
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double old;
#pragma omp atomic capture
        old = h[s[t]]++;
        w[t] = old;
    }
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
        double now;
#pragma omp atomic read
        now = w[t];
#pragma omp atomic
        h[s[t]] += now;
    }
    /* the existing directive makes the loop parallel */
#pragma omp parallel for
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[s[t]] += w[t];
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
        double v = 0;
#pragma omp critical
        {
            v = w[t];
        }
        h[s[t]] += v;
    }
}

/* What `critical` protects may be read by its name: the loop must keep its order, and cannot. */
void limited(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
#pragma omp critical
        {
            if (h[s[n - 1 - t]] < 5)
                h[s[t]] += 1;
        }
    }
}

void team(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#pragma omp atomic
        h[s[t]] += omp_get_thread_num();
    }
}

struct sum {
    double v;
};
#pragma omp declare reduction(add : double : omp_out += omp_in)

void reductions(int n) {
#pragma omp parallel for reduction(add : h)
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[s[t]] += w[t];
    /* each private copy begins with 0, so products are 0 */
#pragma omp parallel for reduction(+ : h)
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[s[t]] *= w[t];
    /* the loop reads an element of the private copy */
#pragma omp parallel for reduction(+ : h)
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[s[t]] += h[n];
#pragma omp parallel for reduction(* : total) reduction(+ : h)
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
        h[s[t]] += w[t];
        total += w[t];
    }
}

void privates(int n) {
    double sum = 0, kept = 0, *const to = &kept;
#pragma omp parallel for firstprivate(sum) reduction(+ : h)
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
        h[s[t]] += w[t];
        sum += w[t];
    }
#pragma omp parallel for private(of_file) reduction(+ : h)
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        of_file = w[t];
        h[s[t]] += of_file;
    }
    /* `to` points to the original `kept`, not to the private copy */
#pragma omp parallel for private(kept) reduction(+ : h)
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        kept = w[t];
        h[s[t]] += kept + *to;
    }
    total += sum + kept;
}

#define LIST(name) private(name)
#define MANY private(x)
#define LOOP _Pragma("omp parallel for")

void macros(int n) {
    double x;
#pragma omp parallel for MANY reduction(+ : h)
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
        x = w[t];
        h[s[t]] += x;
    }
    LOOP
    for (int t = 0; t < n; t++) { // EXPECT: nothing
#pragma omp atomic
        h[s[t]] += w[t];
    }
}
