/* No loop to transform: the output equals the input. */
#define redcc__ 1
int dot(int n, const int *a, const int *b);
int dot(int n, const int *a, const int *b) {
    int sum = 0;
    for (int i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}
