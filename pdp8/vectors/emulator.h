/* What an emulator has to offer to runner.c. */

enum { PC, AC, LINK, SR, ION, MEM_PROT, RUN, PROTECT, REGISTERS };

/* Set the registers up to MEM_PROT; all devices at rest, flags down, RUN on, the next cycle a FETCH. With ION set
   an interrupt may come after the first instruction. */
void emulator_set(const int *registers);

/* Raise the flag of a device: 3 keyboard, 4 printer, 1 and 2 reader and punch of the PC8/L. */
void emulator_raise(int device);

void emulator_deposit(int address, int word);
int emulator_examine(int address);

/* Run one memory cycle; return its ticks of 0.05 us: 32, or 85 for an IOT. `state` is 'F', 'D' or 'E'. */
int emulator_cycle(int *state, int *ma, int *mb);

/* Get all registers. */
void emulator_get(int *registers);
