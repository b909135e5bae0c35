/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/report_log.h"

#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#include "driver/files.h"
#include "support/buffer.h"

/* JSON without the white space between its tokens, and a line's end. */
static void compact(const char *text, buffer *line) {
    bool in_string = false;
    for (; *text; text++) {
        if (*text == '"')
            in_string = !in_string;
        if (in_string && *text == '\\' && text[1])
            buffer_byte(line, *text++);
        if (in_string || !strchr(" \t\r\n", *text))
            buffer_byte(line, *text);
    }
    buffer_byte(line, '\n');
}

static bool write_all(int file, const char *text, size_t length) {
    while (length > 0) {
        ssize_t count = write(file, text, length);
        if (count <= 0)
            return false;
        text += count;
        length -= (size_t)count;
    }
    return true;
}

bool report_log_append(arena *a, const char *report, const char *log) {
    const char *text = file_read(a, report, NULL);
    if (!text || !*text)
        return false;
    int file = open(log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0)
        return false;
    buffer line = {0};
    compact(text, &line);
    bool good = flock(file, LOCK_EX) == 0 && write_all(file, line.data, line.length);
    buffer_free(&line);
    return close(file) == 0 && good;
}
