static inline double weight(double v) { return 0.25 * v * v + v; }
