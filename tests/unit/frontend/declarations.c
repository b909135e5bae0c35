extern double outer[];
static int counter;
_Thread_local int per_thread;
volatile int device;
_Atomic long atomic;
const double table[2][3] = {{1, 2, 3}};
double outer[20];
int unused;
void declarations(int n, double a[static n], double b[n][n + 1], int f(int), char *restrict s) {
    int i = n, *p = &i, arr[4] = {1, 2}, (*q)[4] = &arr;
    static int calls;
    static _Thread_local int mine = 3;
    extern int elsewhere;
    register int fast = 1;
    double vla[n], (*view)[n] = b, fixed[2][2];
    typedef int number;
    number x = i;
    int prototype(int), y;
    __int128 big = 0;
    float four __attribute__((vector_size(16)));
    enum { INNER = 3 } e = INNER;
    _Static_assert(INNER == 3, "");
    for (int i = 0, j = 1; i < j; i++) {
        int i = 2;
        calls += i;
    }
    a[calls++] = b[1][2] + vla[0] + view[1][2] + sizeof vla + counter + per_thread + device;
    p = arr + 1;
    mine = f(x) + elsewhere + fast + atomic + table[1][2] + outer[3] + fixed[0][1];
    four[0] = big + e + (*q)[0] + s[0] + y;
    counter = ((int(*)[n])p)[0][1];
}
