/* Every change of one word of the conversion program that leaves its work as it is.

   usage: variants < WORDS     lines "address word", octal, decimal points nowhere

   The program reads two lines of a FORTRAN tape, all ten digits, spaces, CR, LF and rubouts, with channel 8 and without.
   A change leaves its work as it is if the program punches a blank frame first, then for each character as many frames
   as before, and each of them has an odd number of holes and the same holes in channels 1 to 4 and 8, which are all that
   the head of the Hydra-Point sees. Prints "address word" of each.

   The Teletype keeps its time: a character is there after KSF has waited for it, so a KCC before that loses none.
   It shares nothing with the package. */

#include <stdio.h>
#include <string.h>

enum { WORDS = 4096, MASK = 07777, HEAD = 0217, LONGEST = 4000 };
typedef struct { unsigned short core[WORDS]; int ac, link, pc; int reader, flag, buffer, ready; } Machine;

static const char *const LINE = " 76 2250 4133  185\r\n\177\177 986 2261 4037  184\r\n\177\177";
static unsigned short program[WORDS], wanted[256][9];
static int counts[256];

static int odd(int frame)
{
    int holes = 0;
    for (; frame; frame &= frame - 1)
        holes++;
    return holes & 1;
}

static void operate(Machine *m, int word, int *stops)
{
    if (!(word & 0400)) {
        if (word & 0200) m->ac = 0;
        if (word & 0100) m->link = 0;
        if (word & 0040) m->ac ^= MASK;
        if (word & 0020) m->link ^= 1;
        if (word & 0001) m->ac++, m->link ^= m->ac >> 12, m->ac &= MASK;
        for (int turns = word & 2 ? 2 : 1; turns && word & 014; turns--) {
            int both = m->link << 12 | m->ac;
            both = word & 010 ? both >> 1 | (both & 1) << 12 : (both << 1 | both >> 12) & 017777;
            m->ac = both & MASK, m->link = both >> 12;
        }
        return;
    }
    if (word & 1) { *stops = 1; return; } /* group 3 is not the 8/L's, and none of its words would do */
    int skips = (word & 0100 && m->ac & 04000) || (word & 0040 && !m->ac) || (word & 0020 && m->link);
    if (word & 010) skips = !skips;
    if (skips) m->pc = (m->pc + 1) & MASK;
    if (word & 0200) m->ac = 0;
    if (word & 2) *stops = 1;
}

/* What the program does with the next character: the frames it punches until it waits for another; -1 if it is lost. */
static int next(Machine *m, int character, unsigned short *frames)
{
    int punched = 0, given = 0;
    for (int steps = 0; steps < LONGEST; steps++) {
        int word = m->core[m->pc], page = word & 0200 ? m->pc & 07600 : 0, at = page | (word & 0177), stops = 0;
        m->pc = (m->pc + 1) & MASK;
        if (word < 06000 && word & 0400) {
            if ((at & 07770) == 010) m->core[at] = (m->core[at] + 1) & MASK;
            at = m->core[at];
        }
        switch (word >> 9) {
        case 0: m->ac &= m->core[at]; break;
        case 1: m->ac += m->core[at], m->link ^= m->ac >> 12, m->ac &= MASK; break;
        case 2: if (!(m->core[at] = (m->core[at] + 1) & MASK)) m->pc = (m->pc + 1) & MASK; break;
        case 3: m->core[at] = m->ac, m->ac = 0; break;
        case 4: m->core[at] = m->pc, m->pc = (at + 1) & MASK; break;
        case 5: m->pc = at; break;
        case 6:
            if ((word & 0770) == 030) {
                if (word & 1) {
                    if (m->flag) m->pc = (m->pc + 1) & MASK;
                    else if (given) return punched; /* it waits for the next character */
                    else if (character < 0) return punched;
                    else m->buffer = character, m->flag = 1, given = 1; /* it has come while the program waited */
                }
                if (word & 2) m->flag = 0, m->ac = 0;
                if (word & 4) m->ac |= m->buffer;
            } else if ((word & 0770) == 040) {
                if (word & 1 && m->ready) m->pc = (m->pc + 1) & MASK;
                else if (word & 1) m->ready = 1; /* it has printed while the program waited */
                if (word & 2) m->ready = 0;
                if (word & 4) { if (punched == 8) return -1; frames[punched++] = m->ac & 0377, m->ready = 0; }
            } else
                return -1;
            break;
        default: operate(m, word, &stops);
        }
        if (stops) return -1;
    }
    return -1;
}

static int works(const unsigned short *core, int learn)
{
    Machine m = { .pc = 0200 };
    memcpy(m.core, core, sizeof m.core);
    unsigned short frames[9];
    if (next(&m, -1, frames) != 1 || frames[0]) return 0; /* it begins with a blank frame */
    for (int turn = 0; turn < 2; turn++)
        for (const char *at = LINE; *at; at++) {
            int character = *at | (turn ? 0 : 0200), count = next(&m, character, frames);
            if (learn) {
                counts[character] = count;
                memcpy(wanted[character], frames, sizeof frames);
            }
            if (count < 0 || count != counts[character]) return 0;
            for (int frame = 0; frame < count; frame++)
                if (!odd(frames[frame]) || (frames[frame] ^ wanted[character][frame]) & HEAD) return 0;
        }
    return 1;
}

int main(void)
{
    unsigned address, word;
    char is_word[WORDS] = { 0 };
    while (scanf("%o %o", &address, &word) == 2)
        program[address & MASK] = word & MASK, is_word[address & MASK] = 1;
    if (!works(program, 1)) return 1;
    for (address = 0; address < WORDS; address++)
        for (unsigned other = 0; is_word[address] && other < WORDS; other++) {
            unsigned short kept = program[address];
            program[address] = other;
            if (other != kept && works(program, 0)) printf("%04o %04o\n", address, other);
            program[address] = kept;
        }
    return 0;
}
