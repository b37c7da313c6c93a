/* The reference PDP-8/L: its state, and what can be done to it. */

#ifndef PDP8L_H
#define PDP8L_H

#include <stdint.h>

#include "teletype_gates.h"

typedef int64_t tick; /* 0.05 us */

enum { FETCH, DEFER, EXECUTE, INTERRUPT, WORD_COUNT, CURRENT_ADDRESS, BREAK, NONE };
enum { LOAD_ADD, START, CONT, STOP, EXAM, DEP };
enum { LIMIT, STOPPED, BREAKPOINT };
enum { FIELD = 4096, CORE = 8 * FIELD, BREAKERS = 2 };
enum { TAPE_FRAMES = 4096, PAPER_FRAMES = 1 << 16 };

struct reader {
    uint8_t tape[TAPE_FRAMES];
    int32_t length, position; /* the frame under the head is tape[position] */
    int32_t lever;            /* 1 at START */
};

struct paper {
    uint8_t frames[PAPER_FRAMES];
    int32_t count;
};

/* Every device has a flag, and `at`: the tick of the next thing that happens in it by itself. */

struct fast_reader { /* 01 */
    tick at;
    int32_t flag, buffer, fetching;
};

struct fast_punch { /* 02 */
    tick at;
    int32_t flag, buffer;
    int32_t ahead;
};

/* A device with a data break, under code 70 + its place; the later ones are nearer on the cable (breaks.c). */
struct breaker {
    tick at, asked; /* BRK RQ rose at `asked` */
    int32_t flag, breaking, three_cycle, into_core, counts_address, increments;
    int32_t field, address, period, word, left;
};

/* What was done in runs since these are all 0. */
struct counts {
    int32_t executed[CORE], written[CORE], interrupts, cycles;
    tick ticks;
};

struct pdp8l {
    uint16_t core[CORE];
    int32_t size; /* words of core; more than a field come with an MC8/L */
    int32_t inst_field, data_field, inst_buffer, saved_inst, saved_data, inhibit; /* IF DF IB SF: first addresses */
    int32_t inst_switch, data_switch;
    int32_t field, ema; /* of the last cycle, and of the next */
    int32_t breakers;   /* they are fitted */
    struct breaker breaker[BREAKERS];
    int32_t ac, link, pc, ma, mb, ir, sr;
    int32_t state, next; /* the major state of the last cycle, and of the next */
    int32_t run, ion, ion_ready, mem_prot, sing_step, protect, stored;
    int32_t fast; /* the PC8/L is fitted */
    tick now, instructions;
    struct gates teletype;
    int32_t printed; /* how many frames of its selector are on the page */
    struct fast_reader fast_reader;
    struct fast_punch fast_punch;
    int32_t punch_on, fast_punch_on;
    struct reader fast_tape;
    struct paper page, punched, fast_punched;
    struct counts *counts; /* who counts, or nobody */
};

/* The machine as it is switched on; `fast` fits the PC8/L. */
void pdp8l_power_up(struct pdp8l *m, int fast);

/* Fit so much core, and the breakers. */
void pdp8l_rack(struct pdp8l *m, int size, int breakers);

/* One memory cycle; one instruction, or the cycle of an interrupt. */
void pdp8l_cycle(struct pdp8l *m);
void pdp8l_step(struct pdp8l *m);

/* Run to tick `until` or `last` instructions in all, until RUN goes off, or to a mark: 1 at an address stops before
   its instruction and after a JMS to it, 2 after the word was written. */
int pdp8l_run(struct pdp8l *m, tick until, tick last, const uint8_t *marks);

/* Whether the program, left alone, goes round for ever and no device will do anything. */
int pdp8l_endless(const struct pdp8l *m);

/* Run so many cycles, or until RUN goes off. */
int pdp8l_run_cycles(struct pdp8l *m, int count);

/* Keys and the rest of what an operator does (panel.c). SR and MEM PROT are set in the structure. */
void pdp8l_key(struct pdp8l *m, int key);
void pdp8l_set_pc(struct pdp8l *m, int address);
void pdp8l_sing_step(struct pdp8l *m, int down);
void pdp8l_type(struct pdp8l *m, const uint8_t *frames, int count);
void pdp8l_tape(struct pdp8l *m, int fast, const uint8_t *frames, int count);
void pdp8l_lever(struct pdp8l *m, int fast, int start);

/* Let time pass while the processor stands still; let all happen that happens now; let the mechanisms finish what they have begun. */
void pdp8l_wait(struct pdp8l *m, tick ticks);
void pdp8l_settle(struct pdp8l *m);
void pdp8l_finish(struct pdp8l *m);

/* The tick at which a device does something next, be it that nobody sees it. */
tick pdp8l_next(const struct pdp8l *m);

#endif
