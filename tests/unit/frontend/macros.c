#define N 100
#define UPDATE(h, i, w) h[i] += (w)
#define FOR(i, n) for (int i = 0; i < (n); i++)
#define FOREVER for (;;)
#define TWO(a, b) a++; b++
#define HEADER i = 0; i < n; i++
#define PARTS(x) i = 0; i < x;
#define PI 3.14159265358979
#define LETTER 'q'
#define PASTE(a, b) a##b
#define STRING(x) #x
#define PLUS +
void macros(int n, double *h, const int *k) {
    int i, x1 = 0;
    for (i = 0; i < N; i++)
        h[k[i]] += PI;
    for (i = 0; i < n; i++)
        UPDATE(h, k[i], 1.0);
    FOR (t, n)
        UPDATE(h, k[t], PASTE(1, 0));
    FOR (t, n) {
        h[t] = LETTER;
    }
    FOREVER { break; }
    for (HEADER)
        x1 PLUS n;
    for (PARTS(n))
        i++;
    TWO(i, n);
    PASTE(x, 1) = __LINE__;
    h[N - 1] = N PLUS x1;
    k = (const int *)STRING(a b);
    if (n)
        UPDATE(h, 0, FROM_COMMAND_LINE);
    else
        UPDATE(h, 1, 2);
}
#define DEFINE(name) int name(int a) { return a + N; }
DEFINE(made)
