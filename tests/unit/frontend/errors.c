int good(int n) { return n + 1; }
int bad(int n) {
    for (int i = 0; i < n; i++)
        n += undeclared;
    return n;
}
int good_too(int n) { return bad(n); }
int bad_in_line(int n) {
    n = ;
#include "broken.h"
    return n;
}
int from_broken(int n) {
#include "broken.h"
    return n;
}
