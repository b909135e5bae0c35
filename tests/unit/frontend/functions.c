#include "functions.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
__attribute__((pure)) int pure_one(int);
int const_one(int) __attribute__((const));
_Noreturn void stop(void);
static inline int twice(int x) { return 2 * x; }
int old_style(a, b) int a;
double *b;
{ return a + (int)b[0]; }
int sum(int n, ...) {
    va_list ap;
    va_start(ap, n);
    int r = va_arg(ap, int);
    va_end(ap);
    return r;
}
void functions(double *h, int (*fp)(int), double (*const table[])(double)) {
    h[0] = from_header(3) + pure_one(1) + const_one(2) + twice(3) + old_style(1, h) + sum(1, 2);
    h[1] = sqrt(h[2]) + fmax(h[3], 1) + fp(1) + (*fp)(2) + table[0](1.0);
    if (h[0] < 0)
        exit(1);
    else if (h[0] > 1)
        stop();
    implicit(h);
    functions(h, twice, table);
}
