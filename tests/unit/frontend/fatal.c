#include "is-not-there.h"
int after(int n) { return n; }
