/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/condition.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* An operator's text and precedence: larger binds tighter. */
typedef struct binary_operator {
    const char *text;
    int strength;
} binary_operator;

/* Longer operators precede their prefixes. */
static const binary_operator binary_operators[] = {
    {"||", 1}, {"&&", 2}, {"==", 6}, {"!=", 6}, {"<<", 8}, {">>", 8},
    {"<=", 7}, {">=", 7}, {"<", 7},  {">", 7},  {"|", 3},  {"^", 4},
    {"&", 5},  {"+", 9},  {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10},
};
enum { OPERATOR_COUNT = sizeof binary_operators / sizeof binary_operators[0], DEPTH_MAX = 200 };

typedef struct reader {
    const char *at;
    condition_version version;
    int depth;
} reader;

static condition_value read_conditional(reader *r);

static const condition_value wrong = {.is_wrong = true};

static condition_value known(int64_t value) {
    return (condition_value){.is_known = true, .value = value};
}

/* FNV-1a. */
static uint64_t mix(uint64_t form, const void *bytes, size_t count) {
    for (size_t i = 0; i < count; i++)
        form = (form ^ ((const unsigned char *)bytes)[i]) * 1099511628211u;
    return form;
}

static condition_value unknown(const char *text, size_t length) {
    return (condition_value){.form = mix(14695981039346656037u, text, length)};
}

/* The value of the operator `text` for two operands, at least one of which is unknown. */
static condition_value combined(const char *text, const condition_value *left,
                                const condition_value *right) {
    condition_value made = unknown(text, strlen(text));
    const condition_value *parts[] = {left, right};
    for (int i = 0; i < 2; i++) {
        const unsigned char is_known = parts[i]->is_known;
        made.form = mix(made.form, &is_known, 1);
        made.form = is_known ? mix(made.form, &parts[i]->value, sizeof parts[i]->value)
                             : mix(made.form, &parts[i]->form, sizeof parts[i]->form);
    }
    return made;
}

static void skip_blanks(reader *r) {
    for (;;) {
        while (isspace((unsigned char)*r->at))
            r->at++;
        if (r->at[0] == '/' && r->at[1] == '/')
            r->at += strlen(r->at);
        const char *end = r->at[0] == '/' && r->at[1] == '*' ? strstr(r->at + 2, "*/") : NULL;
        if (!end)
            return;
        r->at = end + 2;
    }
}

static bool take(reader *r, const char *text) {
    skip_blanks(r);
    size_t length = strlen(text);
    if (strncmp(r->at, text, length) != 0)
        return false;
    r->at += length;
    return true;
}

static size_t name_length(const char *text) {
    size_t length = 0;
    while (isalnum((unsigned char)text[length]) || text[length] == '_')
        length++;
    return length;
}

static bool is_name(const char *text, size_t length, const char *name) {
    return strlen(name) == length && strncmp(text, name, length) == 0;
}

static condition_value read_defined(reader *r) {
    bool has_parenthesis = take(r, "(");
    skip_blanks(r);
    const char *name = r->at;
    size_t length = name_length(name);
    r->at += length;
    if (length == 0 || (has_parenthesis && !take(r, ")")))
        return wrong;
    if (is_name(name, length, "__GNUC__") || is_name(name, length, "__GNUC_MINOR__"))
        return known(1);
    if (is_name(name, length, "__clang__") || is_name(name, length, "__clang_major__"))
        return known(r->version.clang_major != 0);
    const condition_value nothing = known(0), of = unknown(name, length);
    return combined("defined", &of, &nothing);
}

/* Reads a name, or a call of a macro, whose arguments must not name the version. */
static condition_value read_name(reader *r) {
    const char *name = r->at;
    size_t length = name_length(name);
    r->at += length;
    if (is_name(name, length, "defined"))
        return read_defined(r);
    if (is_name(name, length, "__GNUC__"))
        return known(r->version.major);
    if (is_name(name, length, "__GNUC_MINOR__"))
        return known(r->version.minor);
    if (is_name(name, length, "__clang__"))
        return known(r->version.clang_major != 0);
    if (is_name(name, length, "__clang_major__"))
        return known(r->version.clang_major);
    skip_blanks(r);
    if (*r->at != '(')
        return unknown(name, length);
    size_t arguments = strcspn(r->at, ")");
    const char *end = r->at + arguments;
    if (!*end || memchr(r->at + 1, '(', arguments - 1) || memmem(r->at, arguments, "__", 2))
        return wrong;
    r->at = end + 1;
    return unknown(name, (size_t)(r->at - name));
}

static condition_value read_number(reader *r) {
    char *end;
    const unsigned long long value = strtoull(r->at, &end, 0);
    end += strspn(end, "uUlL");
    if (name_length(end) > 0 || *end == '.')
        return wrong;
    r->at = end;
    return known((int64_t)value);
}

static condition_value read_unary(reader *r) {
    skip_blanks(r);
    const char operator[2] = {*r->at, 0};
    if (operator[0] && strchr("!-+~", operator[0])) {
        r->at++;
        if (++r->depth > DEPTH_MAX)
            return wrong;
        const condition_value nothing = known(0), operand = read_unary(r);
        r->depth--;
        if (operand.is_wrong || !operand.is_known)
            return operand.is_wrong ? wrong : combined(operator, & operand, &nothing);
        switch (operator[0]) {
        case '!':
            return known(!operand.value);
        case '-':
            return known((int64_t)(0 - (uint64_t)operand.value));
        case '~':
            return known(~operand.value);
        default:
            return operand;
        }
    }
    if (take(r, "(")) {
        const condition_value inner = read_conditional(r);
        return take(r, ")") ? inner : wrong;
    }
    if (isdigit((unsigned char)*r->at))
        return read_number(r);
    return name_length(r->at) > 0 ? read_name(r) : wrong;
}

static const binary_operator *peek_operator(reader *r) {
    skip_blanks(r);
    for (unsigned i = 0; i < OPERATOR_COUNT; i++)
        if (strncmp(r->at, binary_operators[i].text, strlen(binary_operators[i].text)) == 0)
            return &binary_operators[i];
    return NULL;
}

static condition_value compute(const char *operator, int64_t left, int64_t right) {
    const uint64_t x = (uint64_t)left, y = (uint64_t)right;
    const bool is_double = operator[1] != 0;
    switch (operator[0]) {
    case '|':
        return known(is_double ? left || right : (int64_t)(x | y));
    case '&':
        return known(is_double ? left && right : (int64_t)(x & y));
    case '=':
        return known(left == right);
    case '!':
        return known(left != right);
    case '<':
        if (operator[1] == '<')
            return y < 63 ? known((int64_t)(x << y)) : wrong;
        return known(is_double ? left <= right : left < right);
    case '>':
        if (operator[1] == '>')
            return left >= 0 && y < 63 ? known((int64_t)(x >> y)) : wrong;
        return known(is_double ? left >= right : left > right);
    case '^':
        return known((int64_t)(x ^ y));
    case '+':
        return known((int64_t)(x + y));
    case '-':
        return known((int64_t)(x - y));
    case '*':
        return known((int64_t)(x * y));
    default:
        if (left < 0 || right <= 0)
            return wrong;
        return known(operator[0] == '/' ? left / right : left % right);
    }
}

static condition_value apply(const char *operator, const condition_value * left,
                             const condition_value *right) {
    if (left->is_wrong || right->is_wrong)
        return wrong;
    if (left->is_known && right->is_known)
        return compute(operator, left->value, right->value);
    /* 0 && u and u && 0 are 0, 1 || u and u || 1 are 1, for any u */
    const bool is_and = strcmp(operator, "&&") == 0, is_or = strcmp(operator, "||") == 0;
    const condition_value *one = left->is_known ? left : right;
    if (one->is_known && ((is_and && !one->value) || (is_or && one->value)))
        return known(is_or);
    return combined(operator, left, right);
}

/* Reads operands and left-associative operators with a precedence of at least `least`. */
static condition_value read_binary(reader *r, int least) {
    condition_value left = read_unary(r);
    const binary_operator *next;
    while ((next = peek_operator(r)) && next->strength >= least) {
        r->at += strlen(next->text);
        const condition_value right = read_binary(r, next->strength + 1);
        left = apply(next->text, &left, &right);
    }
    return left;
}

static condition_value read_conditional(reader *r) {
    if (++r->depth > DEPTH_MAX)
        return wrong;
    const condition_value condition = read_binary(r, 1);
    condition_value result = condition;
    if (take(r, "?")) {
        const condition_value first = read_conditional(r);
        const condition_value second = take(r, ":") ? read_conditional(r) : wrong;
        if (condition.is_wrong || first.is_wrong || second.is_wrong)
            result = wrong;
        else if (condition.is_known)
            result = condition.value ? first : second;
        else {
            const condition_value branches = combined(":", &first, &second);
            result = combined("?", &condition, &branches);
        }
    }
    r->depth--;
    return result;
}

condition_value condition_evaluate(const char *expression, condition_version version) {
    reader r = {expression, version, 0};
    const condition_value result = read_conditional(&r);
    skip_blanks(&r);
    return *r.at ? wrong : result;
}

bool condition_equal(const condition_value *left, const condition_value *right) {
    if (left->is_wrong || right->is_wrong || left->is_known != right->is_known)
        return false;
    return left->is_known ? left->value == right->value : left->form == right->form;
}
