/* All kinds of loops, clauses left out, jumps. */
void loops(int n, double *h, const int *k) {
    int i, j;
    for (i = 0; i < n; i++)
        h[k[i]] += 1.0;
    for (int t = n - 1; t >= 0; t -= 2) {
        if (k[t] < 0)
            continue;
        else if (k[t] > n)
            break;
        h[k[t]]--;
    }
    for (;;)
        break;
    for (; i < n;)
        i++;
    for (i = 0, j = n; /* ; ( */; j--, i++)
        if (j < i)
            break;
    for (;; i--) {
        if (h[i] > ";)("[0])
            goto out;
    }
    for (i = 0;;) {
        break;
    }
    while (n-- > 0)
        h[n] = 0;
    do
        ++n;
    while (n < 3);
out:
    switch (n) {
    case 1:
    case 2 ... 4:
        h[0] = 1;
        break;
    default:;
    }
}
int jump(int n) {
    void *where = &&here;
    goto *where;
here:
    return n ? 1 : 2;
}
