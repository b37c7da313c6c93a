/* What an emulator has to offer to runner.c. */

enum { PC, AC, LINK, SR, ION, MEM_PROT, RUN, PROTECT, TICKS, REGISTERS };

/* Set the registers up to MEM_PROT; flags down, RUN on, a FETCH comes next. With ION set an interrupt may
   come after the first instruction. */
void emulator_set(const int *registers);

/* Raise the flag of a device: 3 keyboard, 4 printer, 1 and 2 reader and punch of the PC8/L. Only interrupts.json.gz
   has flags. */
void emulator_flag(int device);

void emulator_deposit(int address, int word);
int emulator_examine(int address);

/* Run so many instructions, and the interrupt that comes after the last. */
void emulator_run(int instructions);

/* Run one memory cycle; `state` is 'F', 'D' or 'E'. With -DCYCLES this is called in place of emulator_run. */
void emulator_cycle(char *state, int *ma, int *mb);

/* Get the registers; those that are not written are not compared. TICKS of 0.05 us since emulator_set. */
void emulator_get(int *registers);
