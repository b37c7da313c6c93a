/* The panel of the reference: what each key does in each condition, and SING STEP.

   Written from what the panels of an 8/L's RTL (mrieker/pdp8l, zynq/pdp8lsim.v and pipan8l/simlib.cc) and the gates of
   an 8/I (drovak/verilogpdp) do, without the package's panel at hand.

   A hand comes between two cycles. STOP then lets the instruction finish; SING STEP takes RUN away at once, since the
   cycle that it is in has just ended. A key that presets clears the major state, and with it the DEFER, the EXECUTE or
   the interrupt that would have come next: CONT fetches.

   Conventions, where the sources differ: STOP comes before an interrupt that was seen, which CONT then does; a DEP that
   MEM PROT refuses leaves the old word in MB. */

#include "parts.h"

void preset(struct pdp8l *m)
{
    abandon_break(m);
    m->state = NONE;
    m->next = FETCH;
    m->ema = m->inst_field;
}

/* The memory cycle of a key: the word at PC. */
static void look(struct pdp8l *m)
{
    m->protect = 0;
    m->ma = m->pc;
    m->field = m->ema = m->inst_field;
    m->mb = m->core[m->field | m->ma];
}

static void advance(struct pdp8l *m) { m->pc = (m->pc + 1) & 07777; }

/* Run a cycle, or the rest of an instruction; meanwhile time passes for the devices, and what their mechanisms have
   begun is finished as the machine stands. */
static void run(struct pdp8l *m, int cycles)
{
    pdp8l_run_cycles(m, cycles);
    pdp8l_finish(m);
}

/* RUN comes on, and under SING STEP goes off with the end of one cycle. */
static void go(struct pdp8l *m)
{
    m->run = 1;
    if (m->sing_step) run(m, 1);
}

static void stop(struct pdp8l *m)
{
    while (m->run && within(m)) run(m, 1);
    m->run = 0;
}

void pdp8l_key(struct pdp8l *m, int key)
{
    if (key == STOP) {
        stop(m);
        return;
    }
    if (m->run) return;
    if (key != CONT) preset(m);
    switch (key) {
    case LOAD_ADD:
        m->pc = m->sr;
        load_address(m);
        look(m);
        break;
    case EXAM:
        look(m);
        advance(m);
        break;
    case DEP:
        look(m);
        if (m->mem_prot && m->ma >= 07600 && m->field == 0) m->protect = 1;
        else m->mb = m->core[m->field | m->ma] = m->sr;
        advance(m);
        break;
    case START:
        initialize(m);
        go(m);
        break;
    case CONT:
        go(m);
        break;
    }
}

void pdp8l_sing_step(struct pdp8l *m, int down)
{
    m->sing_step = down;
    if (down) m->run = 0;
}

void pdp8l_set_pc(struct pdp8l *m, int address)
{
    if (m->next > INTERRUPT) preset(m);
    m->pc = address & 07777;
    m->next = FETCH;
    m->inst_field = m->inst_buffer = m->ema = address & 070000;
}
