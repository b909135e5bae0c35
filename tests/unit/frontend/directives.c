/* #define not a directive */
#if 0
don't read "this
#pragma omp parallel for
#else // comment \
  goes on
#endif
#define M(x) x \
    + 1 /* a comment
    over lines */ + 2
  #  pragma omp simd
%:define DIGRAPH 1
char *s = "#define in a string\
#define still";
#\
pragma spliced
void directives(int n) {
    _Pragma("omp parallel for") for (int i = 0; i < n; i++)
        ;
    int x = '#'; /*
#include "no" */
    /* */ # /* yes */ ifdef M
    x++;
# endif
}
#include <stddef.h>
