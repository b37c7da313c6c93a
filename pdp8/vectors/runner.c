/* Play vectors on an emulator: cc runner.c EMULATOR.c -o runner; gzip -dc tad.json.gz | ./runner [8/E]

   Every vector is a line. With a model only the vectors that hold for it are played. With -DCYCLES they are played
   cycle by cycle. Prints a difference of each of the first words that differ; the exit status is 1 if there is one. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emulator.h"

enum { SHOWN = 20, WORDS = 010000, REGISTERS = 9, NOT_WRITTEN = -1 };
static const char *NAMES[REGISTERS] = {"pc", "ac", "link", "sr", "ion", "mem_prot", "run", "protect", "ticks"};
static int differences, words, seen[WORDS];

static const char *find(const char *text, const char *name)
{
    char key[16];
    snprintf(key, sizeof key, "\"%s\":", name);
    text = strstr(text, key);
    return text ? text + strlen(key) : NULL;
}

/* Compare, until a difference is found in the vector. */
static void compare(const char *line, const char *what, int got, int meant, int *wrong)
{
    const char *name = line + strlen("{\"name\":\"");
    int word = strtol(name, NULL, 8);
    if (got == meant || *wrong) return;
    *wrong = 1;
    differences++;
    if (!seen[word]++ && words++ < SHOWN)
        printf(strcmp(what, "ticks") ? "  %.*s: %s is %o, not %o\n" : "  %.*s: %s is %d, not %d\n",
               (int)strcspn(name, "\""), name, what, got, meant);
}

/* Read the pair of numbers at `*at`, and go to the next. */
static int pair(const char **at, int *address, int *word)
{
    int length;
    (*at)++;
    if (sscanf(*at, "[%d,%d]%n", address, word, &length) != 2) return 0;
    *at += length;
    return 1;
}

#ifdef CYCLES
static void run(const char *line, int *wrong)
{
    const char *at = find(line, "cycles");
    char name, state;
    int ma, mb, meant_ma, meant_mb;
    while (sscanf(at + 1, "[\"%c%*[A-Z]\",%d,%d]", &name, &meant_ma, &meant_mb) == 3) {
        emulator_cycle(&state, &ma, &mb);
        compare(line, "state", state, name, wrong);
        compare(line, "MA", ma, meant_ma, wrong);
        compare(line, "MB", mb, meant_mb, wrong);
        at = strchr(at, ']') + 1;
    }
}
#else
static void run(const char *line, int *wrong)
{
    (void)wrong;
    emulator_run(atoi(find(line, "instructions")));
}
#endif

/* Play a vector; return 0 if it is passed over. */
static int play(const char *line)
{
    const char *initial = find(line, "initial"), *final = find(line, "final"), *at;
    union { struct registers named; int values[REGISTERS]; } all;
    int i, address, word, wrong = 0;
    for (i = 0; i < REGISTERS; i++) {
        at = find(initial, NAMES[i]);
        all.values[i] = at && at < final ? atoi(at) : 0;
    }
    emulator_set(&all.named);
    for (at = find(initial, "ram"); pair(&at, &address, &word);) emulator_deposit(address, word);
    for (at = find(initial, "flags"); at && *at != ']'; at += strcspn(at + 1, ",]") + 1)
        if (!emulator_flag(atoi(at + 1))) return 0;
    run(line, &wrong);
    for (i = 0; i < REGISTERS; i++) all.values[i] = NOT_WRITTEN;
    emulator_get(&all.named);
    for (i = 0; i < REGISTERS; i++) {
        at = find(final, NAMES[i]);
        if (at && all.values[i] != NOT_WRITTEN) compare(line, NAMES[i], all.values[i], atoi(at), &wrong);
    }
    for (at = find(final, "ram"); pair(&at, &address, &word);)
        compare(line, "core", emulator_examine(address), word, &wrong);
    return 1;
}

int main(int count, char **arguments)
{
    char line[4096], model[16];
    int played = 0;
    snprintf(model, sizeof model, "\"%s\"", count > 1 ? arguments[1] : "8/L");
    while (fgets(line, sizeof line, stdin)) {
        const char *found = strstr(line, model);
        if (!find(line, "cycles") || !found || found > find(line, "instructions")) continue;
        played += play(line);
    }
    printf("%d played, %d differ in %d words\n", played, differences, words);
    return differences || !played;
}
