/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Tables of functions with effects other than their results: those of C17 7.11 to 7.14, 7.21, 7.22,
 * 7.24, 7.27 and 7.29, and POSIX functions of the same kinds. A parallel loop may repeat calls of
 * functions without such effects. If it repeated a call that prints, the output would appear
 * twice. */
#include "analysis/base/stateful.h"

#include <stddef.h>
#include <string.h>

typedef struct effect {
    const char *what;
    const char *names; /* the names, each with a blank before and after it */
} effect;

static const effect effects[] = {
    {"writes output",
     " printf fprintf vprintf vfprintf puts fputs putchar putc fputc fwrite perror "
     "fflush write dprintf putwchar fputwc fputws wprintf fwprintf syslog "},
    {"reads input", " scanf fscanf vscanf vfscanf getchar getc fgetc fgets fread ungetc getline "
                    "getdelim read getwchar fgetwc "},
    {"opens, closes or positions a file",
     " fopen freopen fclose fseek ftell rewind setvbuf remove rename tmpfile open close lseek "},
    {"allocates or frees memory",
     " malloc calloc realloc reallocarray free aligned_alloc posix_memalign memalign valloc strdup "
     "strndup alloca "},
    {"keeps state between its calls",
     " rand srand rand_r random srandom drand48 erand48 lrand48 nrand48 mrand48 jrand48 srand48 "
     "strtok strtok_r setlocale signal atexit time clock gettimeofday clock_gettime getenv setenv "
     "putenv usleep nanosleep sleep system raise "},
    {"writes memory that it is given",
     " memcpy memmove memset strcpy strncpy strcat strncat sprintf snprintf vsprintf vsnprintf "
     "sscanf qsort frexp modf remquo strtol strtod strtoul "},
    {"ends the program", " exit _Exit abort quick_exit longjmp "},
};

static int has_name(const char *names, const char *name) {
    const size_t length = strlen(name);
    for (const char *at = strstr(names, name); length && at; at = strstr(at + 1, name))
        if (at[-1] == ' ' && at[length] == ' ')
            return 1;
    return 0;
}

bool stateful_is_lock(const char *name) {
    static const char names[] =
        " omp_set_lock omp_unset_lock omp_test_lock omp_set_nest_lock omp_unset_nest_lock "
        "omp_test_nest_lock pthread_mutex_lock pthread_mutex_trylock pthread_mutex_unlock "
        "pthread_spin_lock pthread_spin_trylock pthread_spin_unlock pthread_rwlock_wrlock "
        "pthread_rwlock_unlock mtx_lock mtx_trylock mtx_unlock ";
    return has_name(names, name);
}

const char *stateful_effect(const char *name) {
    for (size_t i = 0; i < sizeof effects / sizeof *effects; i++)
        if (has_name(effects[i].names, name))
            return effects[i].what;
    return NULL;
}
