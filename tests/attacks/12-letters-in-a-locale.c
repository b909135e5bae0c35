/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// isalpha and similar functions use tables of the calling thread: of its own locale, or of the
// global locale as it was when the thread first used them. The translated loop must use the tables
// of the thread that entered it.
#define _GNU_SOURCE
#include <ctype.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>

enum { N = 40000 };
static unsigned char text[N];
static int letters[256], lower[256];
static unsigned short same_type[256];

static void count(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        if (isalpha(text[t]))
            letters[text[t]]++;
}

/* the updated array has the type of these tables */
static void count_short(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        if (isupper(text[t]) || isdigit(text[t]) || ispunct(text[t]))
            same_type[text[t]]++;
}

/* the table determines the subscript: a plan must not be kept after the locale has changed */
static void fold(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        lower[(*__ctype_tolower_loc())[text[t]] & 255]++;
}

static void all(const char *name) {
    memset(letters, 0, sizeof letters);
    memset(lower, 0, sizeof lower);
    memset(same_type, 0, sizeof same_type);
    for (int round = 0; round < 3; round++) {
        count(N);
        count_short(N);
        fold(N);
    }
    unsigned long long hash = 0;
    for (int i = 0; i < 256; i++)
        hash = hash * 31 + (unsigned)letters[i] * 3 + (unsigned)lower[i] * 5 + same_type[i];
    printf("%s %llu\n", name, hash);
}

int main(void) {
    for (int t = 0; t < N; t++)
        text[t] = (unsigned char)(t * 7919u >> 3);
    all("C");
    /* 12-letters-in-a-locale-of-8-bits.sh creates such a locale */
    static const char *const names[] = {"de_DE", "fr_FR", "de_DE.ISO-8859-1", "en_US.ISO-8859-1",
                                        "ru_RU.KOI8-R", "C.UTF-8"};
    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) {
        locale_t own = newlocale(LC_ALL_MASK, names[i], (locale_t)0);
        if (!own)
            continue;
        uselocale(own);
        all("own");
        uselocale(LC_GLOBAL_LOCALE);
        all("global");
        if (setlocale(LC_ALL, names[i]))
            all("set");
        setlocale(LC_ALL, "C");
        all("C again");
        freelocale(own);
    }
    return 0;
}
