/* Iterations are short or long by the trip counts of their inner loops, whatever these loops set. */
void sites(int n, const int *code, const int *kind, const int (*fold)[4], double *count) {
    for (int t = 0; t < n; t++) {
        int base, same;
        for (base = 0, same = 0; base < 4; base++)
            if (fold[t][base] == code[t])
                same++;
        count[kind[same]] += .5;
    }
}

void lines(int n, const int *code, const int *kind, const int (*fold)[400], double *count) {
    for (int t = 0; t < n; t++) {
        int base, same;
        for (base = 0, same = 0; base < 400; base++)
            if (fold[t][base] == code[t])
                same++;
        count[kind[same]] += .5;
    }
}
