/* The reference as an emulator for the runner of the vectors. */

#include "emulator.h"
#include "pdp8l.h"

static struct pdp8l m;

static tick start;

void emulator_set(const struct registers *registers)
{
    static int on;
    if (!on) pdp8l_power_up(&m, 1);
    on = 1;
    m.run = 0;
    pdp8l_key(&m, START);
    m.teletype.receiver.flag = m.teletype.transmitter.flag = m.fast_reader.flag = m.fast_punch.flag = 0;
    m.teletype.receiver.bits = 0;
    m.pc = registers->pc;
    m.ac = registers->ac;
    m.link = registers->link;
    m.sr = registers->sr;
    m.ion = m.ion_ready = registers->ion;
    m.mem_prot = registers->mem_prot;
    m.protect = 0;
    start = m.now;
}

int emulator_flag(int device)
{
    switch (device) {
    case 1: m.fast_reader.flag = 1; break;
    case 2: m.fast_punch.flag = 1; break;
    case 3: m.teletype.receiver.flag = 1; break;
    case 4: m.teletype.transmitter.flag = 1; break;
    }
    return 1;
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

void emulator_get(struct registers *registers)
{
    registers->pc = m.pc;
    registers->ac = m.ac;
    registers->link = m.link;
    registers->sr = m.sr;
    registers->ion = m.ion;
    registers->mem_prot = m.mem_prot;
    registers->run = m.run;
    registers->protect = m.protect;
    registers->ticks = m.now - start;
}
