/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/build_report.h"

#include <fcntl.h>
#include <jansson.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#include "driver/files.h"
#include "support/buffer.h"
#include "support/json_text.h"

const char *build_report_file(bool *by_run) {
    const char *own = getenv("REDCC_BUILD_REPORT");
    const char *of_run = getenv("REDCC_REPORT");
    *by_run = !(own && *own) && of_run && *of_run;
    return own && *own ? own : *by_run ? of_run : NULL;
}

/* Appends the JSON text without white space between its tokens, and a newline. */
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

static bool append_line(const char *report, const buffer *line) {
    int file = open(report, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0)
        return false;
    bool good = flock(file, LOCK_EX) == 0 && write_all(file, line->data, line->length);
    return close(file) == 0 && good;
}

/* Adds a member to the object: the folder to which its file names are relative. */
static void add_directory(buffer *line, const char *object) {
    char here[PATH_MAX];
    json_t *name = getcwd(here, sizeof here) ? json_text(here) : NULL;
    char *text = name ? json_dumps(name, JSON_ENCODE_ANY | JSON_COMPACT) : NULL;
    if (text && object[0] == '{')
        buffer_format(line, "{\"directory\":%s,%s", text, object + 1);
    else
        buffer_text(line, object);
    free(text);
    json_decref(name);
}

bool build_report_append(arena *a, const char *json_file, const char *report) {
    const char *text = file_read(a, json_file, NULL);
    if (!text || !*text)
        return false;
    buffer object = {0}, line = {0};
    compact(text, &object);
    add_directory(&line, object.data);
    bool good = append_line(report, &line);
    buffer_free(&object);
    buffer_free(&line);
    return good;
}

bool build_report_append_left_alone(const char *file, const char *why, const char *report) {
    json_t *object = json_pack("{s:s, s:o, s:[], s:o}", "redcc", REDCC_VERSION, "file",
                               json_text(file), "loops", "left_alone", json_text(why));
    char *text = object ? json_dumps(object, JSON_COMPACT) : NULL;
    json_decref(object);
    if (!text)
        return false;
    buffer line = {0};
    add_directory(&line, text);
    buffer_byte(&line, '\n');
    free(text);
    bool good = append_line(report, &line);
    buffer_free(&line);
    return good;
}
