#include <stddef.h>
struct s {
    int a, b;
};
void opaque(int i, int *p, double x) {
    i = i ?: 3;
    i = offsetof(struct s, b);
    i = ({ int k = i; k + 1; });
    i = _Generic(x, double: i + 1, float: x);
    i = _Generic(i, int: 1, double: 2);
    __atomic_fetch_add(p, 1, __ATOMIC_RELAXED);
    __sync_fetch_and_add(p, 1);
    __asm__ volatile("nop" : "+r"(i));
    double _Complex z = x + 2.0i;
    x = __real__ z + __imag__(z);
    i = __builtin_choose_expr(1, i, 2);
    i = __builtin_types_compatible_p(int, long);
    __attribute__((unused)) int u;
    switch (i) {
    case 0:
        i++;
        __attribute__((fallthrough));
    default:;
    }
}
