/* What an emulator has to offer to runner.c. */

struct registers { int pc, ac, link, sr, ion, mem_prot, run, protect, ticks; };

/* Set the registers up to mem_prot; flags down, RUN on, a FETCH comes next. With ION set an interrupt may come after
   the first instruction. */
void emulator_set(const struct registers *registers);

/* Raise the flag of a device: 3 keyboard, 4 printer, 1 and 2 reader and punch of the PC8/L. Return 0 if there is no
   such device: the vector is passed over. Only interrupts.json.gz has flags. */
int emulator_flag(int device);

void emulator_deposit(int address, int word);
int emulator_examine(int address);

/* Run so many instructions, and the interrupt that comes after the last. */
void emulator_run(int instructions);

/* Run one memory cycle; `state` is 'F', 'D' or 'E'. With -DCYCLES this is called in place of emulator_run. */
void emulator_cycle(char *state, int *ma, int *mb);

/* Get the registers; those that are not written are not compared. The ticks of 0.05 us are since emulator_set. */
void emulator_get(struct registers *registers);
