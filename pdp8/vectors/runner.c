/* Play vectors on an emulator: cc runner.c EMULATOR.c -o runner; gzip -dc tad.json.gz | ./runner

   Every vector is a line. Prints the first differences; the exit status is 1 if there is one. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emulator.h"

static const char *NAMES[REGISTERS] = {"pc", "ac", "link", "sr", "ion", "mem_prot", "run", "protect"};
static int differences;

static const char *find(const char *text, const char *name)
{
    char key[16];
    snprintf(key, sizeof key, "\"%s\":", name);
    text = strstr(text, key);
    return text ? text + strlen(key) : NULL;
}

static void compare(const char *line, const char *what, int got, int meant)
{
    if (got != meant && ++differences <= 10)
        printf("%.*s: %s is %o, not %o\n", (int)strcspn(line + 9, "\""), line + 9, what, got, meant);
}

/* Do `with` to each pair of numbers of a list of them. */
static void pairs(const char *at, const char *line, void (*with)(const char *, int, int))
{
    int address, word, length;
    for (at++; sscanf(at, "[%d,%d]%n", &address, &word, &length) == 2; at += length + (at[length] == ','))
        with(line, address, word);
}

static void deposit(const char *line, int address, int word) { (void)line; emulator_deposit(address, word); }
static void examine(const char *line, int address, int word) { compare(line, "core", emulator_examine(address), word); }

static void play(const char *line)
{
    const char *initial = find(line, "initial"), *final = find(line, "final"), *at = find(line, "flags");
    int registers[REGISTERS], i, state, ma, mb, meant_ma, meant_mb, ticks = 0;
    char name;
    for (i = 0; i < RUN; i++) registers[i] = atoi(find(initial, NAMES[i]));
    emulator_set(registers);
    pairs(find(initial, "ram"), line, deposit);
    for (; at && *at != ']'; at += strspn(at + 1, "0123456789") + 1) emulator_raise(atoi(at + 1));
    for (at = find(line, "cycles") + 1; sscanf(at, "[\"%c%*[A-Z]\",%d,%d]", &name, &meant_ma, &meant_mb) == 3;) {
        ticks += emulator_cycle(&state, &ma, &mb);
        compare(line, "state", state, name);
        compare(line, "MA", ma, meant_ma);
        compare(line, "MB", mb, meant_mb);
        at += strcspn(at, "]") + 1;
        at += *at == ',';
    }
    compare(line, "ticks", ticks, atoi(find(line, "ticks")));
    emulator_get(registers);
    for (i = 0; i < REGISTERS; i++) compare(line, NAMES[i], registers[i], atoi(find(final, NAMES[i])));
    pairs(find(final, "ram"), line, examine);
}

int main(void)
{
    char line[4096];
    int count = 0;
    for (; fgets(line, sizeof line, stdin); count += line[0] == '{')
        if (line[0] == '{') play(line);
    printf("%d vectors, %d differences\n", count, differences);
    return differences || !count;
}
