static int second(int x) { return x - 1; }
static inline int from_header(int x) {
    return second(x) + 1;
}
static inline int not_called(int x) {
    return x;
}
