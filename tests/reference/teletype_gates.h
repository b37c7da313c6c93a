/* The state of the Teletype made of flip-flops, and what can be done to it (teletype_gates.c). */

#ifndef TELETYPE_GATES_H
#define TELETYPE_GATES_H

#include <stdint.h>

enum { QUEUE = 4096 };

struct receiver { /* M706 */
    int64_t pulse_at;
    int32_t divider, active, spike, in_last_unit, stop_1, stop_2;
    int32_t bits; /* BIT 1 is the lowest */
    int32_t flag, reader_run;
};

struct transmitter { /* M707 */
    int64_t edge_at;
    int32_t active, freq_div, stop_1, stop_1_5, stop_2;
    int32_t enable, bits; /* BIT 1 is the lowest */
    int32_t line, flag;
};

struct sender { /* the keyboard and the reader */
    int64_t at; /* when the next unit begins, or the line is free */
    int32_t units, shifting, line;
    int32_t keys, keys_sent, lever, length, position;
    uint8_t keyboard[QUEUE], tape[QUEUE];
};

struct selector { /* the printer */
    int64_t at;
    int32_t unit, frame, printed;
    uint8_t page[QUEUE];
};

struct gates {
    int64_t now;
    struct receiver receiver;
    struct transmitter transmitter;
    struct sender sender;
    struct selector selector;
};

int64_t gates_now(const struct gates *g);
int64_t gates_next(const struct gates *g);
int gates_same(const struct gates *a, const struct gates *b);
int64_t gates_run(struct gates *g, int64_t until);
int gates_iot(struct gates *g, int word, int ac, int64_t began);
void gates_initialize(struct gates *g, int64_t now);
void gates_power_up(struct gates *g);
void gates_type(struct gates *g, int frame);
void gates_load_tape(struct gates *g, const uint8_t *frames, int length);

#endif
