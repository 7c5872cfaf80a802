/* Start values travel in resources/start.bin, so that one binary serves every mission. The file and
   the description are written from the same specification. All numbers have their lowest byte first:

       8 bytes    "segfmu", 0, version of this format
       uint64     mark of the sources that the binary was made of
       uint64     rows of the arrays
       uint64     variables of the description
       40 bytes   GUID of the description, filled up with zeros
       double     start values of `real`, MODEL_REALS of them
       int64      start values of `integer`, MODEL_INTEGERS of them
       uint64     sum over all words before */
#include "start.h"

#include <stdio.h>
#include <string.h>

#include "build.h"
#include "checksum.h"
#include "say.h"

enum { FORMAT = 1, LONGEST_PATH = 4096, WORD = 8, HEAD = 4 };

static const char FILE_NAME[] = "start.bin";

enum {
    TOKEN_WORDS = LONGEST_TOKEN / WORD, VALUES = HEAD + TOKEN_WORDS,
    WORDS = VALUES + MODEL_REALS + MODEL_INTEGERS + 1
};

#ifdef _WIN32
#include <wchar.h>
/* of kernel32; windows.h itself has macros for common words */
__declspec(dllimport) int __stdcall MultiByteToWideChar(
    unsigned page, unsigned long flags, const char *text, int bytes, wchar_t *found, int room);

static FILE *opened(const char *path)
{
    enum { UTF8 = 65001 };
    wchar_t wide[LONGEST_PATH];
    return MultiByteToWideChar(UTF8, 0, path, -1, wide, LONGEST_PATH) > 0 ? _wfopen(wide, L"rb")
                                                                        : NULL;
}
#else
static FILE *opened(const char *path)
{
    return fopen(path, "rb");
}
#endif

static int digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10
        : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Resolve %20 and the like, in place. */
static void decode(char *text)
{
    char *to = text;
    for (const char *p = text; *p != '\0'; p++) {
        if (*p == '%' && digit(p[1]) >= 0 && digit(p[2]) >= 0) {
            *to++ = (char)(16 * digit(p[1]) + digit(p[2]));
            p += 2;
        } else {
            *to++ = *p;
        }
    }
    *to = '\0';
}

static bool has_drive(const char *path)
{
    char letter = path[0];
    return ((letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z')) && path[1] == ':';
}

/* The path in a location: what follows file:, file:// or file://localhost of a URI, else all. */
static const char *path_in(const char *location)
{
    static const char scheme[] = "file:", local[] = "//localhost/";
    const char *p = location;
    if (strncmp(p, scheme, sizeof scheme - 1) == 0) {
        p += sizeof scheme - 1;
        if (strncmp(p, local, sizeof local - 1) == 0) {
            p += sizeof local - 2;
        } else if (p[0] == '/' && p[1] == '/' && (p[2] == '/' || has_drive(p + 2))) {
            p += 2;
        }
    }
    return p[0] == '/' && has_drive(p + 1) ? p + 1 : p;
}

/* Open the file in a folder; importers differ in whether they encode what is special in a URI. */
static FILE *find(const char *location, char path[LONGEST_PATH])
{
    const char *folder = path_in(location);
    size_t length = strlen(folder);
    const char *separator = length > 0 && strchr("/\\", folder[length - 1]) != NULL ? "" : "/";
    if (length + sizeof FILE_NAME + 1 > LONGEST_PATH) {
        return NULL;
    }
    snprintf(path, LONGEST_PATH, "%s%s%s", folder, separator, FILE_NAME);
    FILE *file = opened(path);
    if (file == NULL) {
        decode(path);
        file = opened(path);
    }
    return file;
}

/* A word from its bytes, whatever the order of the processor is. */
static uint64_t word_of(const unsigned char bytes[WORD])
{
    uint64_t word = 0;
    for (int i = WORD - 1; i >= 0; i--) {
        word = word << 8 | bytes[i];
    }
    return word;
}

/* Words of a file; one more than there is room for where it has more. */
static size_t read_words(FILE *file, uint64_t words[WORDS])
{
    unsigned char bytes[WORD];
    size_t count = 0;
    while (count < WORDS && fread(bytes, sizeof bytes, 1, file) == 1) {
        words[count++] = word_of(bytes);
    }
    return fgetc(file) == EOF ? count : count + 1;
}

bool start_read(const char *location, start_values *start, char message[MESSAGE])
{
    static const unsigned char magic[WORD] = {'s', 'e', 'g', 'f', 'm', 'u', 0, FORMAT};
    uint64_t words[WORDS];
    char path[LONGEST_PATH];
    if (location == NULL || location[0] == '\0') {
        return say(message, "the importer names no folder of resources, where the start values are");
    }
    FILE *file = find(location, path);
    if (file == NULL) {
        return say(message, "%s cannot be opened in %.200s; unpack the whole archive", FILE_NAME,
                   location);
    }
    size_t count = read_words(file, words);
    fclose(file);
    if (count < 2 || words[0] != word_of(magic)) {
        return say(message, "%s is no file of start values of this package's format %d", FILE_NAME,
                   FORMAT);
    }
    if (words[1] != BUILD_MARK) {
        return say(message, "%s belongs to another version of %s; build the archive again",
                   FILE_NAME, model_name);
    }
    start->rows = (int64_t)words[2];
    start->variables = (int64_t)words[HEAD - 1];
    if (count != WORDS || words[WORDS - 1] != checksum(words, (WORDS - 1) * sizeof *words) || start->rows < 0
        || start->rows > MODEL_ROWS || start->variables < 1
        || start->variables > MODEL_VARIABLES) {
        return say(message, "%s is damaged; unpack the archive again", FILE_NAME);
    }
    for (int i = 0; i < LONGEST_TOKEN; i++) {
        start->token[i] = (char)(words[HEAD + i / WORD] >> 8 * (i % WORD) & 255u);
    }
    start->token[LONGEST_TOKEN] = '\0';
    memcpy(start->real, words + VALUES, sizeof start->real);
    memcpy(start->integer, words + VALUES + MODEL_REALS, sizeof start->integer);
    return true;
}
