/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/options.h"

#include <stddef.h>
#include <string.h>

/* In the order of strcmp; tests/driver/test_options.c walks it. What is not listed has no argument
 * and goes to the compiler alone. Of gcc's long names (--compile) only those stand here that say
 * how far the compiler goes. Sources: the option summaries of gcc 12 and clang 19. */
static const option options[] = {
    {"-###", OPTION_NO_OBJECT},
    {"--", OPTION_JOINED | OPTION_GIVE_UP},
    {"--analyze", OPTION_NO_OBJECT},
    {"--assemble", OPTION_NO_LINK | OPTION_GIVE_UP},
    {"--compile", OPTION_NO_LINK | OPTION_GIVE_UP},
    {"--config", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"--coverage", OPTION_AUXILIARY},
    {"--dependencies", OPTION_NO_OBJECT},
    {"--help", OPTION_JOINED | OPTION_NO_OBJECT},
    {"--ld-path=", OPTION_JOINED | OPTION_LINKER},
    {"--no-standard-libraries", OPTION_NO_RUNTIME | OPTION_GIVE_UP},
    {"--output", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"--output=", OPTION_JOINED | OPTION_GIVE_UP},
    {"--param", OPTION_ARGUMENT},
    {"--param=", OPTION_JOINED},
    {"--pedantic", 0},
    {"--pedantic-errors", 0},
    {"--pie", OPTION_LINKER},
    {"--precompile", OPTION_NO_OBJECT},
    {"--preprocess", OPTION_NO_OBJECT},
    {"--print-", OPTION_JOINED | OPTION_NO_OBJECT},
    {"--serialize-diagnostics", OPTION_ARGUMENT | OPTION_AUXILIARY},
    {"--shared", OPTION_LINKER},
    {"--static", 0},
    {"--sysroot", OPTION_ARGUMENT | OPTION_PARSE},
    {"--sysroot=", OPTION_JOINED | OPTION_PARSE},
    {"--target-help", OPTION_NO_OBJECT},
    {"--user-dependencies", OPTION_NO_OBJECT},
    {"--version", OPTION_NO_OBJECT},
    {"-A", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-B", OPTION_ARGUMENT | OPTION_JOINED},
    {"-C", OPTION_GIVE_UP},
    {"-CC", OPTION_GIVE_UP},
    {"-D", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-E", OPTION_NO_OBJECT},
    {"-F", OPTION_ARGUMENT | OPTION_JOINED},
    {"-G", OPTION_ARGUMENT | OPTION_JOINED},
    {"-H", 0},
    {"-I", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE},
    {"-I-", OPTION_GIVE_UP},
    {"-L", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
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
    {"-O", OPTION_JOINED | OPTION_PARSE},
    {"-P", OPTION_GIVE_UP},
    {"-Q", OPTION_GIVE_UP},
    {"-R", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-S", OPTION_NO_LINK},
    {"-T", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-Tbss", OPTION_ARGUMENT | OPTION_LINKER},
    {"-Tdata", OPTION_ARGUMENT | OPTION_LINKER},
    {"-Ttext", OPTION_ARGUMENT | OPTION_LINKER},
    {"-U", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-Wl,", OPTION_JOINED | OPTION_LINKER},
    {"-Wp,", OPTION_JOINED | OPTION_GIVE_UP},
    {"-Wp,-D", OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-Wp,-M", OPTION_JOINED | OPTION_DEPENDENCY},
    {"-Wp,-U", OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-Xanalyzer", OPTION_ARGUMENT},
    {"-Xarch_device", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-Xarch_host", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-Xassembler", OPTION_ARGUMENT},
    {"-Xclang", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-Xlinker", OPTION_ARGUMENT | OPTION_LINKER},
    {"-Xopenmp-target", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-Xpreprocessor", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-ansi", OPTION_PARSE},
    {"-arch", OPTION_ARGUMENT | OPTION_GIVE_UP},
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
    {"-fbuild-session", OPTION_JOINED | OPTION_GIVE_UP},
    {"-fcallgraph-info", OPTION_JOINED | OPTION_AUXILIARY},
    {"-fdebug-prefix-map=", OPTION_JOINED | OPTION_PREFIX_MAP},
    {"-fdirectives-only", OPTION_GIVE_UP},
    {"-fdump-", OPTION_JOINED | OPTION_AUXILIARY},
    {"-ffile-prefix-map=", OPTION_JOINED | OPTION_PREFIX_MAP},
    {"-ffreestanding", OPTION_GIVE_UP},
    {"-finput-charset=", OPTION_JOINED | OPTION_GIVE_UP},
    {"-fmodules", OPTION_JOINED | OPTION_GIVE_UP},
    {"-fms-extensions", OPTION_PARSE},
    {"-fno-builtin", OPTION_JOINED | OPTION_PARSE},
    {"-fno-openmp", OPTION_GIVE_UP},
    {"-fno-signed-bitfields", OPTION_GIVE_UP},
    {"-fno-signed-char", OPTION_PARSE},
    {"-fno-strict-aliasing", OPTION_PARSE},
    {"-fno-strict-overflow", OPTION_GIVE_UP},
    {"-fno-unsigned-char", OPTION_PARSE},
    {"-fopenacc", OPTION_JOINED | OPTION_GIVE_UP},
    {"-fopenmp", OPTION_PARSE | OPTION_OPENMP | OPTION_THREADS},
    {"-fopenmp-", OPTION_JOINED},
    {"-fopenmp-simd", OPTION_GIVE_UP},
    {"-fopenmp-targets=", OPTION_JOINED | OPTION_GIVE_UP},
    {"-fopenmp=", OPTION_JOINED | OPTION_PARSE | OPTION_OPENMP | OPTION_THREADS},
    {"-fopt-info", OPTION_JOINED | OPTION_AUXILIARY},
    {"-fpack-struct", OPTION_JOINED | OPTION_GIVE_UP},
    {"-fplan9-extensions", OPTION_GIVE_UP},
    {"-fpreprocessed", OPTION_GIVE_UP},
    {"-fprofile-", OPTION_JOINED | OPTION_AUXILIARY},
    {"-framework", OPTION_ARGUMENT | OPTION_LINKER},
    {"-frounding-math", OPTION_GIVE_UP},
    {"-fsave-optimization-record", OPTION_JOINED | OPTION_AUXILIARY},
    {"-fshort-enums", OPTION_PARSE},
    {"-fshort-wchar", OPTION_GIVE_UP},
    {"-fsigned-char", OPTION_PARSE},
    {"-fstack-usage", OPTION_AUXILIARY},
    {"-fstrict-aliasing", OPTION_PARSE},
    {"-fsyntax-only", OPTION_NO_OBJECT},
    {"-ftest-coverage", OPTION_AUXILIARY},
    {"-ftime-trace", OPTION_JOINED | OPTION_AUXILIARY},
    {"-ftree-parallelize-loops=", OPTION_JOINED | OPTION_THREADS},
    {"-funsigned-bitfields", OPTION_GIVE_UP},
    {"-funsigned-char", OPTION_PARSE},
    {"-fuse-ld=", OPTION_JOINED | OPTION_LINKER},
    {"-fwrapv", OPTION_JOINED | OPTION_GIVE_UP},
    {"-gcc-toolchain", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-gsplit-dwarf", OPTION_JOINED | OPTION_AUXILIARY},
    {"-h", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-help", OPTION_NO_OBJECT},
    {"-idirafter", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE},
    {"-iframework", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-imacros", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-imultilib", OPTION_ARGUMENT | OPTION_JOINED | OPTION_GIVE_UP},
    {"-include", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE | OPTION_MACROS},
    {"-include-pch", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-iplugindir=", OPTION_JOINED},
    {"-iprefix", OPTION_ARGUMENT | OPTION_JOINED | OPTION_GIVE_UP},
    {"-iquote", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE},
    {"-isysroot", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE},
    {"-isystem", OPTION_ARGUMENT | OPTION_JOINED | OPTION_PARSE},
    {"-ivfsoverlay", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-iwithprefix", OPTION_ARGUMENT | OPTION_JOINED | OPTION_GIVE_UP},
    {"-iwithprefixbefore", OPTION_ARGUMENT | OPTION_JOINED | OPTION_GIVE_UP},
    {"-iwithsysroot", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-l", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-m", OPTION_JOINED | OPTION_PARSE},
    {"-m16", OPTION_GIVE_UP},
    {"-m31", OPTION_GIVE_UP},
    {"-m32", OPTION_GIVE_UP},
    {"-mcmodel=kernel", OPTION_GIVE_UP},
    {"-miamcu", OPTION_GIVE_UP},
    {"-mllvm", OPTION_ARGUMENT},
    {"-mx32", OPTION_GIVE_UP},
    {"-no-pie", OPTION_LINKER},
    {"-nodefaultlibs", OPTION_NO_RUNTIME | OPTION_GIVE_UP},
    {"-nolibc", OPTION_NO_RUNTIME | OPTION_GIVE_UP},
    {"-nostartfiles", OPTION_LINKER},
    {"-nostdinc", OPTION_PARSE},
    {"-nostdlib", OPTION_NO_RUNTIME | OPTION_GIVE_UP},
    {"-o", OPTION_ARGUMENT | OPTION_JOINED},
    {"-pg", 0},
    {"-pie", OPTION_LINKER},
    {"-print-", OPTION_JOINED | OPTION_NO_OBJECT},
    {"-pthread", OPTION_PARSE | OPTION_THREADS},
    {"-r", OPTION_NO_RUNTIME},
    {"-rdynamic", OPTION_LINKER},
    {"-resource-dir", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-resource-dir=", OPTION_JOINED | OPTION_GIVE_UP},
    {"-rtlib=", OPTION_JOINED | OPTION_LINKER},
    {"-s", OPTION_LINKER},
    {"-save-temps", OPTION_JOINED | OPTION_AUXILIARY},
    {"-serialize-diagnostics", OPTION_ARGUMENT | OPTION_AUXILIARY},
    {"-shared", OPTION_LINKER},
    {"-shared-libgcc", OPTION_LINKER},
    {"-specs", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-specs=", OPTION_JOINED | OPTION_GIVE_UP},
    {"-static-libgcc", OPTION_LINKER},
    {"-static-openmp", OPTION_LINKER},
    {"-static-pie", OPTION_LINKER},
    {"-std=", OPTION_JOINED | OPTION_PARSE},
    {"-stdlib=", OPTION_JOINED | OPTION_LINKER},
    {"-symbolic", OPTION_LINKER},
    {"-target", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-traditional", OPTION_JOINED | OPTION_GIVE_UP},
    {"-trigraphs", OPTION_PARSE},
    {"-u", OPTION_ARGUMENT | OPTION_JOINED | OPTION_LINKER},
    {"-undef", OPTION_GIVE_UP},
    {"-unwindlib=", OPTION_JOINED | OPTION_LINKER},
    {"-working-directory", OPTION_ARGUMENT | OPTION_GIVE_UP},
    {"-working-directory=", OPTION_JOINED | OPTION_GIVE_UP},
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

const option *option_find(const char *word) {
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
