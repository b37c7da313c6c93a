/* The reference as an emulator for the runner of the vectors. */

#include "emulator.h"
#include "pdp8l.h"

static struct pdp8l m;

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
}

void emulator_raise(int device)
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

int emulator_cycle(int *state, int *ma, int *mb)
{
    tick before = m.now;
    pdp8l_cycle(&m);
    *state = "FDE"[m.state];
    *ma = m.ma;
    *mb = m.mb;
    return m.now - before;
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
}
