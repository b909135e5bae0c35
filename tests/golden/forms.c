/* Places where a loop may be. */
int forms(int n, const int *restrict k, double *restrict h, float *restrict g);
int forms(int n, const int *restrict k, double *restrict h, float *restrict g) {
    int t, half, before = 1; for (t = 0; t < n; t++) { h[k[t]] += 1.0; } int after = 2; /* one line */
    if (n > 10)
        for (int u = 0; u < n; u++) h[k[u]] += 0.5; /* comment */ else {
        before++;
    }
    {
        {
            for (t = n - 1; t >= 0; t -= 2) // backwards
            {
                if (k[t] < 3)
                    continue;
                half = k[t] / 2;
                if (t % 2)
                    h[half] -= 2.0;
                else
                    h[k[t]] += 4.0;
            } // the end
        }
    }
    t = 0;
    while (t < n) {
        g[k[t]] *= 1.5f;
        t++; /* dropped in the copies */
    }
    switch (n) {
    case 3:
        for (unsigned char c = 0; c < 200; c++)
            h[k[c]]++;
        break;
    default:
        for (t = 1; t <= n; ++t)
            ++h[k[t - 1] + 1];
    }
    return before + after + t;
}

int labelled(int n, const int *restrict k, int *restrict h);
int labelled(int n, const int *restrict k, int *restrict h) {
    int rounds = 0;
again:
    for (int t = 0; t < n; t++)
        h[k[t]] ^= t;
    if (++rounds < 3)
        goto again;
    return rounds;
}
