/* The reference as an emulator for the runner of the vectors. */

#include "emulator.h"
#include "pdp8l.h"

static struct pdp8l m;

static tick start;

void emulator_set(const int *registers)
{
    static int on;
    if (!on) pdp8l_power_up(&m, 1);
    on = 1;
    m.run = 0;
    pdp8l_start(&m);
    m.receiver.flag = m.transmitter.flag = m.fast_reader.flag = m.fast_punch.flag = 0;
    m.receiver.buffer = 0;
    m.pc = registers[PC];
    m.ac = registers[AC];
    m.link = registers[LINK];
    m.sr = registers[SR];
    m.ion = m.ion_ready = registers[ION];
    m.mem_prot = registers[MEM_PROT];
    m.protect = 0;
    start = m.now;
}

void emulator_flag(int device)
{
    switch (device) {
    case 1: m.fast_reader.flag = 1; break;
    case 2: m.fast_punch.flag = 1; break;
    case 3: m.receiver.flag = 1; break;
    case 4: m.transmitter.flag = 1; break;
    }
}

void emulator_deposit(int address, int word) { m.core[address] = word; }
int emulator_examine(int address) { return m.core[address]; }

void emulator_cycle(char *state, int *ma, int *mb)
{
    pdp8l_cycle(&m);
    *state = "FDE"[m.state];
    *ma = m.ma;
    *mb = m.mb;
}

void emulator_run(int instructions)
{
    tick last = m.instructions + instructions;
    int steps = 2 * instructions; /* an interrupt after each: with a fault it may come again and again */
    while (steps-- && m.run && (m.instructions < last || m.next == INTERRUPT)) pdp8l_step(&m);
}

void emulator_get(int *registers)
{
    registers[PC] = m.pc;
    registers[AC] = m.ac;
    registers[LINK] = m.link;
    registers[SR] = m.sr;
    registers[ION] = m.ion;
    registers[MEM_PROT] = m.mem_prot;
    registers[RUN] = m.run;
    registers[PROTECT] = m.protect;
    registers[TICKS] = m.now - start;
}
