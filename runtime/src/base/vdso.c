/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/vdso.h"

#if defined(__linux__) && defined(__LP64__)

#include <elf.h>
#include <stdint.h>
#include <string.h>

/* The tables that the image's dynamic section refers to. */
struct image {
    /* difference between actual addresses and the addresses in the image's tables */
    uintptr_t shift;
    const Elf64_Sym *symbol;
    const char *text;
};

static const void *at(uintptr_t address) {
    return (const void *)address;
}

static void take_entry(struct image *image, const Elf64_Dyn *entry) {
    const void *place = at(image->shift + (uintptr_t)entry->d_un.d_ptr);
    if (entry->d_tag == DT_SYMTAB)
        image->symbol = place;
    if (entry->d_tag == DT_STRTAB)
        image->text = place;
}

/* Reads the image's tables. False if the format is unknown. */
static int read_image(struct image *image, uintptr_t place) {
    const Elf64_Ehdr *header = at(place);
    if (!place || memcmp(header->e_ident, ELFMAG, SELFMAG) != 0)
        return 0;
    const Elf64_Phdr *part = at(place + (uintptr_t)header->e_phoff);
    const Elf64_Dyn *dynamic = 0;
    int loaded = 0;
    for (int p = 0; p < header->e_phnum; p++) {
        if (part[p].p_type == PT_LOAD && !loaded) {
            image->shift = place + (uintptr_t)part[p].p_offset - (uintptr_t)part[p].p_vaddr;
            loaded = 1;
        }
        if (part[p].p_type == PT_DYNAMIC)
            dynamic = at(place + (uintptr_t)part[p].p_offset);
    }
    for (; loaded && dynamic && dynamic->d_tag != DT_NULL; dynamic++)
        take_entry(image, dynamic);
    return image->symbol && image->text;
}

/* The number of symbols is not stored directly. The search ends at the string table, which linkers
 * put after the symbols. */
void (*redcc_vdso_find(unsigned long place, const char *name))(void) {
    struct image image = {0};
    if (!read_image(&image, place))
        return 0;
    const Elf64_Sym *end = at((uintptr_t)image.text);
    for (const Elf64_Sym *symbol = image.symbol; symbol + 1 <= end; symbol++)
        if (symbol->st_shndx != SHN_UNDEF && strcmp(image.text + symbol->st_name, name) == 0)
            return (void (*)(void))(image.shift + (uintptr_t)symbol->st_value);
    return 0;
}

#else

void (*redcc_vdso_find(unsigned long place, const char *name))(void) {
    (void)place;
    (void)name;
    return 0;
}

#endif
