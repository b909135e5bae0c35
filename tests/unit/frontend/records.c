typedef struct { float x, y; } vec;
struct node {
    struct node *next;
    char tag;
    union {
        int i;
        struct {
            short lo, hi;
        };
    };
    unsigned bits : 3, : 0, more : 2;
    struct {
        double d;
    } named;
    vec v[2];
    volatile int flag;
    int tail[];
};
struct hidden;
void records(struct node *p, vec a, const struct node *q, struct hidden *h) {
    struct node n = *p, *r;
    p->next->tag = 'x';
    p->i = p->hi + n.lo;
    (*p).named.d += q->named.d;
    p->v[1].x = a.y;
    p->bits = p->more;
    p->tail[3]++;
    a = (vec){1, .y = 2};
    vec b = {.x = 1}, c[2] = {[1] = {2, 3}, {4}};
    r = &n;
    r->v->x = c->y + q->flag;
    struct local {
        int z;
    } l = {0};
    l.z++;
    (void)h;
    (void)b;
}
