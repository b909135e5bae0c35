/* A generated file: redcc takes line numbers from its #line directives. */
#line 100 "grammar.y"
void made(int n, const int *restrict k, int *restrict h);
void made(int n, const int *restrict k, int *restrict h) {
    for (int t = 0; t < n; t++)
        h[k[t]]
            += __LINE__;
}
#line 8 "lines.c"
int line(void);
int line(void) {
    return __LINE__;
}
