enum colour { RED, GREEN = 5, BLACK = -1 };
int called(int, double);
void expressions(int i, unsigned u, long l, double x, float f, char c, double *p, double (*m)[3]) {
    int *q, **qq = &q;
    i = u + l * c - (i << 2) % 3;
    x = f * i / 2. + 1e-3 + 0x1p-2 + .5f;
    i = c & u | i ^ ~c && !x || -i, +l;
    i += 2.5;
    l >>= i;
    u = sizeof(double) + sizeof x + sizeof(m[0]);
    3 [p] = p[3] + *p + *(p + i) + m[1][2] + (*m)[0] + (p + 1)[i];
    *p++ = (*p)++ + --*p;
    i = GREEN + BLACK + 'a' + '\n' + 017 + 0xffU + 10000000000 + 0b101 + 1\
2;
    x = i ? x : c ? f : l;
    i = (int)x + (char)u + (int)(long)x;
    (void)called(i = 3, (i, x));
    called(called(1, 2), i);
    (*called)(1, 2);
    **qq = (int){3};
    i = __extension__(i);
    i = __builtin_expect(i, 0);
    p = &m[i][1];
    m = (double(*)[3])p;
    q = 0;
    x = u = i = 7;
    p[i++] = p[i--], (p[0] = 1);
    "string" " in two"[i];
    x = (double)__func__[0];
}
