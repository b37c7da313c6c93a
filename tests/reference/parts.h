/* What processor, panel and devices of the reference know of each other. */

#include "pdp8l.h"

#define NEVER INT64_MAX

enum { CYCLE = 32, IOT = 85, IOP1 = 29, IOP2 = 47, IOP4 = 65 }; /* the pulses from the beginning of an IOT */

void initialize_devices(struct pdp8l *m);

/* INITIALIZE: of everything. MANUAL PRESET, which is a part of it: the major state. */
void initialize(struct pdp8l *m);
void preset(struct pdp8l *m);

/* Whether a cycle of an unfinished instruction comes next; one cycle, counted if somebody counts. */
int within(const struct pdp8l *m);
void counted_cycle(struct pdp8l *m);

/* Let everything happen in the devices that happens up to and including tick `now`. */
void devices(struct pdp8l *m, tick now);

int request(const struct pdp8l *m);

/* Data breaks and the memory extension (breaks.c). */
void breakers_initialize(struct pdp8l *m);
void breakers_until(struct pdp8l *m, tick now);
int breakers_request(const struct pdp8l *m);
int breakers_still(const struct pdp8l *m);
void breaker_iot(struct pdp8l *m, int which, int word, tick began);
void accept_break(struct pdp8l *m, tick tp1);
void abandon_break(struct pdp8l *m);
void break_cycle(struct pdp8l *m);
void extension_iot(struct pdp8l *m, int word);
void load_address(struct pdp8l *m);

void write_core(struct pdp8l *m, int word);
int still(const struct pdp8l *m);
void skip(struct pdp8l *m);

void teletype_iot(struct pdp8l *m, int word, tick began);
void fast_reader_iot(struct pdp8l *m, int word, tick began);
void fast_punch_iot(struct pdp8l *m, int word, tick began);
