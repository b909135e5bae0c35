/* Loops in inline functions, with internal and with external linkage. */
static inline void fine(int n, const int *restrict k, int *restrict h) {
    for (int t = 0; t < n; t++)
        h[k[t]]++;
}

inline void shared(int n, const int *restrict k, int *restrict h) {
    for (int t = 0; t < n; t++)
        h[k[t]]++;
}

void both(int n, const int *restrict k, int *restrict h);
void both(int n, const int *restrict k, int *restrict h) {
    fine(n, k, h);
    shared(n, k, h);
}
extern inline void shared(int n, const int *restrict k, int *restrict h);
