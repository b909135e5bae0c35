/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "support/compiler_options.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* Sorted as by strcmp; tests/driver/test_options.c checks the order. An option that is not listed
 * has no argument, does not concern the translator, and is passed only to the compiler. Most of
 * gcc's long names (--compile) are not listed unless they stop the compiler early. Sources: the
 * option summaries of gcc 12 and clang 19. */
static const option options[] = {
    {"-###", OPTION_NO_OBJECT},
    {"--", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"--analyze", OPTION_NO_OBJECT},
    {"--assemble", OPTION_NO_LINK | OPTION_GIVE_UP},
    {"--compile", OPTION_NO_LINK | OPTION_GIVE_UP},
    {"--config", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"--coverage", OPTION_AUXILIARY | OPTION_GIVE_UP},
    {"--dependencies", OPTION_NO_OBJECT},
    {"--help", OPTION_JOINED | OPTION_NO_OBJECT},
    {"--ld-path=", OPTION_JOINED | OPTION_LINKER},
    {"--no-standard-libraries", OPTION_GIVE_UP | OPTION_NO_RUNTIME},
    {"--output", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"--output=", OPTION_JOINED | OPTION_GIVE_UP},
    {"--param", OPTION_ARGUMENT},
    {"--param=", OPTION_JOINED},
    {"--pedantic", 0},
    {"--pedantic-errors", 0},
    {"--pie", OPTION_LINKER},
    {"--precompile", OPTION_NO_OBJECT},
    {"--predefined=", OPTION_JOINED},
    {"--preprocess", OPTION_NO_OBJECT},
    {"--print-", OPTION_JOINED | OPTION_NO_OBJECT},
    {"--serialize-diagnostics", OPTION_ARGUMENT | OPTION_AUXILIARY},
    {"--shared", OPTION_LINKER},
    {"--static", 0},
    {"--sysroot", OPTION_ARGUMENT | OPTION_PARSE | OPTION_CLANG | OPTION_PATH},
    {"--sysroot=", OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_PATH},
    {"--target-help", OPTION_NO_OBJECT},
    {"--user-dependencies", OPTION_NO_OBJECT},
    {"--version", OPTION_NO_OBJECT},
    {"-A", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-B", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PATH},
    {"-C", OPTION_GIVE_UP},
    {"-CC", OPTION_GIVE_UP},
    {"-D", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_MACROS},
    {"-E", OPTION_NO_OBJECT},
    {"-F", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PATH},
    {"-G", OPTION_ARGUMENT | OPTION_JOINED},
    {"-H", 0},
    {"-I", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_PATH},
    {"-I-", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-L", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PATH | OPTION_LINKER},
    {"-M", OPTION_NO_OBJECT | OPTION_DEPENDENCY},
    {"-MD", OPTION_DEPENDENCY},
    {"-MF", OPTION_ARGUMENT | OPTION_JOINED | OPTION_DEPENDENCY},
    {"-MG", OPTION_DEPENDENCY},
    {"-MJ", OPTION_ARGUMENT | OPTION_JOINED | OPTION_GIVE_UP},
    {"-MM", OPTION_NO_OBJECT | OPTION_DEPENDENCY},
    {"-MMD", OPTION_DEPENDENCY},
    {"-MP", OPTION_DEPENDENCY},
    {"-MQ", OPTION_ARGUMENT | OPTION_JOINED | OPTION_DEPENDENCY},
    {"-MT", OPTION_ARGUMENT | OPTION_JOINED | OPTION_DEPENDENCY},
    {"-O", OPTION_JOINED | OPTION_PARSE | OPTION_CLANG},
    {"-Ofast", OPTION_PARSE | OPTION_CLANG | OPTION_INEXACT | OPTION_LIBERTY},
    {"-P", OPTION_GIVE_UP},
    {"-Q", OPTION_GIVE_UP},
    {"-R", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-S", OPTION_NO_LINK},
    {"-T", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-Tbss", OPTION_ARGUMENT | OPTION_LINKER},
    {"-Tdata", OPTION_ARGUMENT | OPTION_LINKER},
    {"-Ttext", OPTION_ARGUMENT | OPTION_LINKER},
    {"-U", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_MACROS},
    {"-Wl,", OPTION_JOINED | OPTION_LINKER},
    {"-Wp,", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-Wp,-D", OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-Wp,-M", OPTION_JOINED | OPTION_DEPENDENCY},
    {"-Wp,-U", OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-Xanalyzer", OPTION_ARGUMENT},
    {"-Xarch_device", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-Xarch_host", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-Xassembler", OPTION_ARGUMENT},
    {"-Xclang", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-Xlinker", OPTION_ARGUMENT | OPTION_LINKER},
    {"-Xopenmp-target", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-Xpreprocessor", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-ansi", OPTION_PARSE | OPTION_CLANG},
    {"-arch", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-aux-info", OPTION_ARGUMENT | OPTION_AUXILIARY},
    {"-c", OPTION_NO_LINK},
    {"-cc1", OPTION_NO_OBJECT},
    {"-cc1as", OPTION_NO_OBJECT},
    {"-ccc-print-", OPTION_JOINED | OPTION_NO_OBJECT},
    {"-dependency-dot", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-dependency-file", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-dumpbase", OPTION_ARGUMENT | OPTION_AUXILIARY},
    {"-dumpbase-ext", OPTION_ARGUMENT | OPTION_AUXILIARY},
    {"-dumpdir", OPTION_ARGUMENT | OPTION_AUXILIARY},
    {"-dumpfullversion", OPTION_NO_OBJECT},
    {"-dumpmachine", OPTION_NO_OBJECT},
    {"-dumpspecs", OPTION_NO_OBJECT},
    {"-dumpversion", OPTION_NO_OBJECT},
    {"-e", OPTION_ARGUMENT | OPTION_LINKER},
    {"-emit-ast", OPTION_NO_LINK | OPTION_GIVE_UP},
    {"-emit-llvm", OPTION_GIVE_UP},
    {"-fPIC", OPTION_PARSE},
    {"-fPIE", OPTION_PARSE},
    {"-fapprox-func", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-fassociative-math", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-fbuild-session", OPTION_JOINED | OPTION_GIVE_UP},
    {"-fcallgraph-info", OPTION_JOINED | OPTION_AUXILIARY},
    {"-fcomplex-arithmetic=", OPTION_JOINED | OPTION_PARSE | OPTION_INEXACT},
    {"-fcoverage-mapping", OPTION_GIVE_UP},
    {"-fcx-fortran-rules", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-fcx-limited-range", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-fdebug-prefix-map=", OPTION_JOINED | OPTION_PREFIX_MAP},
    {"-fdenormal-fp-math=", OPTION_JOINED | OPTION_PARSE | OPTION_INEXACT},
    {"-fdirectives-only", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fdump-", OPTION_JOINED | OPTION_AUXILIARY},
    {"-fexec-charset=", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-ffast-math", OPTION_PARSE | OPTION_CLANG | OPTION_INEXACT | OPTION_LIBERTY},
    {"-ffile-prefix-map=", OPTION_JOINED | OPTION_PREFIX_MAP},
    {"-ffinite-math-only", OPTION_PARSE | OPTION_CLANG | OPTION_INEXACT | OPTION_LIBERTY},
    {"-ffp-eval-method=", OPTION_JOINED | OPTION_PARSE | OPTION_INEXACT},
    {"-ffp-model=", OPTION_JOINED | OPTION_PARSE | OPTION_INEXACT},
    {"-ffreestanding", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fgnu-tm", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fgnu89-inline", OPTION_PARSE | OPTION_CLANG},
    {"-fgnuc-version=", OPTION_JOINED | OPTION_CLANG},
    {"-fhosted", 0},
    {"-finput-charset=", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-finstrument-functions", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fmath-errno", OPTION_PARSE},
    {"-fmodules", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fms-extensions", OPTION_PARSE | OPTION_CLANG},
    {"-fno-PIC", OPTION_PARSE},
    {"-fno-PIE", OPTION_PARSE},
    {"-fno-builtin", OPTION_JOINED | OPTION_PARSE | OPTION_CLANG},
    {"-fno-honor-infinities", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-fno-honor-nans", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-fno-hosted", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fno-math-errno", OPTION_PARSE},
    {"-fno-openmp", OPTION_GIVE_UP},
    {"-fno-pic", OPTION_PARSE},
    {"-fno-pie", OPTION_PARSE},
    {"-fno-semantic-interposition", OPTION_PARSE},
    {"-fno-short-enums", OPTION_PARSE | OPTION_CLANG},
    {"-fno-signed-bitfields", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fno-signed-char", OPTION_PARSE | OPTION_CLANG},
    {"-fno-signed-zeros", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-fno-strict-aliasing", OPTION_PARSE},
    {"-fno-strict-overflow", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fno-unsigned-char", OPTION_PARSE | OPTION_CLANG},
    {"-fno-wrapv", OPTION_PARSE | OPTION_CLANG},
    {"-fopenacc", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fopenmp", OPTION_PARSE | OPTION_OPENMP | OPTION_THREADS},
    {"-fopenmp-", OPTION_JOINED},
    {"-fopenmp-simd", OPTION_GIVE_UP},
    {"-fopenmp-targets=", OPTION_JOINED | OPTION_GIVE_UP},
    {"-fopenmp=", OPTION_JOINED | OPTION_PARSE | OPTION_OPENMP | OPTION_THREADS},
    {"-fopt-info", OPTION_JOINED | OPTION_AUXILIARY},
    {"-fpack-struct", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fpic", OPTION_PARSE},
    {"-fpie", OPTION_PARSE},
    {"-fplan9-extensions", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fpreprocessed", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fprofile-", OPTION_JOINED | OPTION_AUXILIARY},
    {"-fprofile-arcs", OPTION_AUXILIARY | OPTION_GIVE_UP},
    {"-framework", OPTION_ARGUMENT | OPTION_LINKER},
    {"-freciprocal-math", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-frounding-math", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fsanitize=", OPTION_JOINED | OPTION_PARSE},
    {"-fsave-optimization-record", OPTION_JOINED | OPTION_AUXILIARY},
    {"-fsemantic-interposition", OPTION_PARSE},
    {"-fshort-enums", OPTION_PARSE | OPTION_CLANG},
    {"-fshort-wchar", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fsigned-char", OPTION_PARSE | OPTION_CLANG},
    {"-fsingle-precision-constant", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fsso-struct=", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fstack-usage", OPTION_AUXILIARY},
    {"-fstrict-aliasing", OPTION_PARSE},
    {"-fsyntax-only", OPTION_NO_OBJECT},
    {"-ftest-coverage", OPTION_AUXILIARY | OPTION_GIVE_UP},
    {"-ftime-trace", OPTION_JOINED | OPTION_AUXILIARY},
    {"-ftrapv", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-ftree-parallelize-loops=", OPTION_JOINED | OPTION_THREADS},
    {"-funsafe-math-optimizations", OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-funsigned-bitfields", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-funsigned-char", OPTION_PARSE | OPTION_CLANG},
    {"-fuse-ld=", OPTION_JOINED | OPTION_LINKER},
    {"-fveclib=", OPTION_JOINED | OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-fvisibility=", OPTION_JOINED | OPTION_PARSE | OPTION_CLANG},
    {"-fwide-exec-charset=", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-fwrapv", OPTION_PARSE | OPTION_CLANG},
    {"-fwrapv-pointer", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-gcc-toolchain", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-gsplit-dwarf", OPTION_JOINED | OPTION_AUXILIARY},
    {"-h", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-help", OPTION_NO_OBJECT},
    {"-idirafter", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_PATH},
    {"-iframework", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-imacros",
     OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_PATH | OPTION_MACROS},
    {"-imultilib", OPTION_ARGUMENT | OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-include",
     OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_PATH | OPTION_MACROS},
    {"-include-pch", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-iplugindir=", OPTION_JOINED},
    {"-iprefix", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PATH | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-iquote", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_PATH},
    {"-isysroot", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_PATH},
    {"-isystem", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_CLANG | OPTION_PATH},
    {"-ivfsoverlay", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-iwithprefix",
     OPTION_ARGUMENT | OPTION_JOINED | OPTION_PATH | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-iwithprefixbefore",
     OPTION_ARGUMENT | OPTION_JOINED | OPTION_PATH | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-iwithsysroot", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-l", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-m", OPTION_JOINED | OPTION_PARSE | OPTION_CLANG},
    {"-m16", OPTION_REFUSE | OPTION_GIVE_UP | OPTION_CLANG},
    {"-m31", OPTION_REFUSE | OPTION_GIVE_UP | OPTION_CLANG},
    {"-m32", OPTION_REFUSE | OPTION_GIVE_UP | OPTION_CLANG},
    {"-mcmodel=kernel", OPTION_REFUSE | OPTION_GIVE_UP | OPTION_CLANG},
    {"-mfpmath=", OPTION_JOINED | OPTION_PARSE | OPTION_INEXACT | OPTION_CLANG},
    {"-mfpmath=sse", OPTION_PARSE | OPTION_CLANG},
    {"-miamcu", OPTION_REFUSE | OPTION_GIVE_UP | OPTION_CLANG},
    {"-mllvm", OPTION_ARGUMENT},
    {"-mlong-double-128", OPTION_REFUSE | OPTION_GIVE_UP | OPTION_CLANG},
    {"-mlong-double-64", OPTION_REFUSE | OPTION_GIVE_UP | OPTION_CLANG},
    {"-mno-sse", OPTION_PARSE | OPTION_INEXACT | OPTION_CLANG},
    {"-mno-sse2", OPTION_PARSE | OPTION_INEXACT | OPTION_CLANG},
    {"-mrecip", OPTION_JOINED | OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY | OPTION_CLANG},
    {"-msoft-float", OPTION_PARSE | OPTION_INEXACT | OPTION_CLANG},
    {"-mveclibabi=", OPTION_JOINED | OPTION_PARSE | OPTION_INEXACT | OPTION_LIBERTY},
    {"-mx32", OPTION_REFUSE | OPTION_GIVE_UP | OPTION_CLANG},
    {"-no-pie", OPTION_LINKER},
    {"-nodefaultlibs", OPTION_GIVE_UP | OPTION_NO_RUNTIME},
    {"-nolibc", OPTION_GIVE_UP | OPTION_NO_RUNTIME},
    {"-nostartfiles", OPTION_LINKER},
    {"-nostdinc", OPTION_PARSE | OPTION_CLANG},
    {"-nostdlib", OPTION_GIVE_UP | OPTION_NO_RUNTIME},
    {"-o", OPTION_ARGUMENT | OPTION_JOINED},
    {"-pg", 0},
    {"-pie", OPTION_LINKER},
    {"-print-", OPTION_JOINED | OPTION_NO_OBJECT},
    {"-pthread", OPTION_PARSE | OPTION_CLANG | OPTION_THREADS},
    {"-r", OPTION_NO_RUNTIME},
    {"-rdynamic", OPTION_LINKER},
    {"-resource-dir", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-resource-dir=", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-rtlib=", OPTION_JOINED | OPTION_LINKER},
    {"-s", OPTION_LINKER},
    {"-save-temps", OPTION_JOINED | OPTION_AUXILIARY},
    {"-serialize-diagnostics", OPTION_ARGUMENT | OPTION_AUXILIARY},
    {"-shared", OPTION_LINKER},
    {"-shared-libgcc", OPTION_LINKER},
    {"-specs", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-specs=", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-static-libgcc", OPTION_LINKER},
    {"-static-openmp", OPTION_LINKER},
    {"-static-pie", OPTION_LINKER},
    {"-std=", OPTION_JOINED | OPTION_PARSE | OPTION_CLANG},
    {"-stdlib=", OPTION_JOINED | OPTION_LINKER},
    {"-symbolic", OPTION_LINKER},
    {"-target", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-traditional", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-trigraphs", OPTION_PARSE | OPTION_CLANG},
    {"-u", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-undef", OPTION_REFUSE | OPTION_GIVE_UP},
    {"-unwindlib=", OPTION_JOINED | OPTION_LINKER},
    {"-working-directory", OPTION_ARGUMENT | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-working-directory=", OPTION_JOINED | OPTION_REFUSE | OPTION_GIVE_UP},
    {"-wrapper", OPTION_ARGUMENT},
    {"-x", OPTION_ARGUMENT | OPTION_JOINED},
    {"-z", OPTION_ARGUMENT | OPTION_LINKER},
};

enum { OPTION_COUNT = sizeof options / sizeof options[0] };

/* Orders the first `length` bytes of `word` against a whole name. */
static int compare(const char *word, size_t length, const char *name) {
    int order = strncmp(word, name, length);
    if (order != 0)
        return order;
    return name[length] == 0 ? 0 : -1;
}

static const option *find_exactly(const char *word, size_t length) {
    size_t first = 0, end = OPTION_COUNT;
    while (first < end) {
        size_t middle = first + (end - first) / 2;
        int order = compare(word, length, options[middle].name);
        if (order == 0)
            return &options[middle];
        if (order < 0)
            end = middle;
        else
            first = middle + 1;
    }
    return NULL;
}

/* Do the sanitizers report unsigned arithmetic that wraps around? Such arithmetic is legal. The
 * inline functions of the runtime's headers, which are compiled in the user's file, use it. */
static bool reports_wrapping(const char *sanitizers) {
    return strstr(sanitizers, "=integer") || strstr(sanitizers, ",integer") ||
           strstr(sanitizers, "unsigned-");
}

const option *option_find(const char *word) {
    static const option wrapping = {"-fsanitize=",
                                    OPTION_JOINED | OPTION_PARSE | OPTION_REFUSE | OPTION_GIVE_UP};
    if (strncmp(word, wrapping.name, strlen(wrapping.name)) == 0 && reports_wrapping(word))
        return &wrapping;
    size_t length = strlen(word);
    const option *found = find_exactly(word, length);
    while (!found && length > 2) {
        found = find_exactly(word, --length);
        if (found && !(found->meaning & OPTION_JOINED))
            found = NULL;
    }
    return found;
}

const option *option_at(unsigned index) {
    return index < OPTION_COUNT ? &options[index] : NULL;
}

const char *const *option_without_liberty(const char *word) {
    static const char *const fastest[] = {"-O3", "-fno-math-errno", "-fno-trapping-math", NULL};
    static const char *const fast[] = {"-fno-math-errno", "-fno-trapping-math", NULL};
    static const char *const unsafe[] = {"-fno-trapping-math", NULL};
    static const char *const none[] = {NULL};
    if (strcmp(word, "-Ofast") == 0)
        return fastest;
    if (strcmp(word, "-ffast-math") == 0)
        return fast;
    return strcmp(word, "-funsafe-math-optimizations") == 0 ? unsafe : none;
}
