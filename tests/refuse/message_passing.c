/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Calls of MPI: only the thread that initialised MPI may make them, even if an option declares the function pure.
// covers: row 85 of docs/constructs.md
// OPTIONS: --pure=MPI_Comm_rank
typedef struct communicator *MPI_Comm;
int MPI_Comm_rank(MPI_Comm, int *rank);
int MPI_Reduce_local(const void *in, void *inout, int count);
__attribute__((const)) double MPI_Wtick(void);
double PMPI_Wtime(void);

void sends(int n, const int *restrict s, const double *restrict e, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse message-passing
        MPI_Reduce_local(e, h, 1);
        h[s[t]] += e[t];
    }
}

void is_said_to_be_pure(int n, const int *restrict s, double *restrict h, MPI_Comm all) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse message-passing
        int rank;
        h[s[t]] += MPI_Comm_rank(all, &rank);
    }
}

void is_declared_const(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse message-passing
        h[s[t]] += MPI_Wtick();
}

static double weight(double e) {
    return e * PMPI_Wtime();
}

void within_a_function(int n, const int *restrict s, const double *restrict e,
                       double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse message-passing
        h[s[t]] += weight(e[t]);
}
