/* An inner loop updates the elements of a row between two bounds. */
void sum_up(int n, int m, const int *cluster, float **value, float (*centre)[34], int *length) {
    for (int i = 0; i < n; i++) {
        int k = cluster[i];
        length[k]++;
        for (int c = 0; c < m; c++)
            centre[k][c] += value[i][c];
    }
}
