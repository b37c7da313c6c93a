/* A plain PDP-8/L: the processor. The panel is in panel.c, the devices are in devices.c.

   The tests hold the package's machine against this one. It is written from the books and shares nothing with the
   package: no word is decoded ahead, no loop is passed over, the shift registers of the Teletype are registers that
   shift. It is in C because a run of 10^8 instructions should take seconds.

   Time is in ticks of 0.05 us. A memory cycle is 32, an IOT 85, with its pulses 29, 47 and 65 ticks after it began.

   Conventions, where the books leave a choice: 6003 to 6007 do as their pulses do; a write that MEM PROT stops leaves
   the rest of its cycle.

   Sources: PDP-8/L Users Handbook 1968; Small Computer Handbook 1970; PDP-8/I instruction card; DEC M220 schematic. */

#include <string.h>

#include "parts.h"

void skip(struct pdp8l *m) { m->pc = (m->pc + 1) & 07777; }

void write_core(struct pdp8l *m, int word)
{
    if (m->mem_prot && m->ma >= 07600 && m->field == 0) {
        m->protect = 1;
        m->run = 0;
    } else {
        m->mb = m->core[m->field | m->ma] = word & 07777;
        m->stored = 1;
    }
}

static int address(const struct pdp8l *m) { return (m->mb & 0200 ? m->ma & 07600 : 0) | (m->mb & 0177); }

static int rotated_left(int lac) { return (lac << 1 | lac >> 12) & 017777; }
static int rotated_right(int lac) { return (lac >> 1 | lac << 12) & 017777; }

static void group1(struct pdp8l *m, int word)
{
    int lac, left, right;
    if (word & 0200) m->ac = 0;
    if (word & 0100) m->link = 0;
    if (word & 0040) m->ac ^= 07777;
    if (word & 0020) m->link ^= 1;
    lac = m->link << 12 | m->ac;
    if (word & 0001) lac = (lac + 1) & 017777;
    left = rotated_left(lac);
    right = rotated_right(lac);
    if (word & 0002) {
        left = rotated_left(left);
        right = rotated_right(right);
    }
    switch (word & 0014) { /* both at once: every bit passes both shift gates, which is their AND */
    case 0004: lac = left; break;
    case 0010: lac = right; break;
    case 0014: lac = left & right; break;
    }
    m->link = lac >> 12;
    m->ac = lac & 07777;
}

static void group2(struct pdp8l *m, int word)
{
    int sma = word & 0100 && m->ac & 04000;
    int sza = word & 0040 && m->ac == 0;
    int snl = word & 0020 && m->link;
    if ((sma || sza || snl) != !!(word & 0010)) skip(m);
    if (word & 0200) m->ac = 0;
    if (word & 0004) m->ac |= m->sr;
    if (word & 0002) m->run = 0;
}

static void processor_iot(struct pdp8l *m, int word)
{
    if (word & 1) m->ion = 1;
    if (word & 2) m->ion = m->ion_ready = 0;
}

static void input_output(struct pdp8l *m, int word)
{
    tick began = m->now;
    m->now += IOT;
    switch (word >> 3 & 077) {
    case 00: processor_iot(m, word); break;
    case 01: if (m->fast) fast_reader_iot(m, word, began); break;
    case 02: if (m->fast) fast_punch_iot(m, word, began); break;
    case 03: case 04: teletype_iot(m, word, began); break;
    case 020: case 021: case 022: case 023: case 024: case 025: case 026: case 027:
        if (m->size > FIELD) extension_iot(m, word);
        break;
    case 070: case 071: if (m->breakers) breaker_iot(m, word >> 3 & 1, word, began); break;
    }
}

static void fetch(struct pdp8l *m)
{
    m->state = FETCH;
    m->ma = m->pc;
    m->field = m->inst_field;
    m->mb = m->core[m->field | m->ma];
    m->ir = m->mb >> 9;
    m->pc = (m->pc + 1) & 07777;
    m->instructions++;
    if (m->ir == 6) {
        input_output(m, m->mb);
        return;
    }
    m->now += CYCLE;
    if (m->ir == 7) {
        if (!(m->mb & 0400)) group1(m, m->mb);
        else if (!(m->mb & 1)) group2(m, m->mb);
    } else if (m->mb & 0400) {
        m->next = DEFER;
    } else if (m->ir == 5) {
        m->pc = address(m);
    } else {
        m->next = EXECUTE;
    }
}

static void defer(struct pdp8l *m)
{
    m->state = DEFER;
    m->now += CYCLE;
    m->ma = address(m);
    m->field = m->inst_field;
    m->mb = m->core[m->field | m->ma];
    if (m->ma >= 010 && m->ma <= 017) write_core(m, m->mb + 1);
    m->next = EXECUTE;
    if (m->ir == 5) {
        m->pc = m->mb;
        m->next = FETCH;
    }
}

static void execute(struct pdp8l *m)
{
    int sum;
    m->field = m->state == DEFER && m->ir < 4 ? m->data_field : m->inst_field;
    m->ma = m->state == DEFER ? m->mb : address(m);
    m->mb = m->core[m->field | m->ma];
    m->state = EXECUTE;
    m->next = FETCH;
    m->now += CYCLE;
    switch (m->ir) {
    case 0:
        m->ac &= m->mb;
        break;
    case 1:
        sum = m->ac + m->mb;
        m->ac = sum & 07777;
        m->link ^= sum >> 12;
        break;
    case 2:
        write_core(m, m->mb + 1);
        if (m->mb == 0) skip(m);
        break;
    case 3:
        write_core(m, m->ac);
        m->ac = 0;
        break;
    case 4:
        write_core(m, m->pc);
        m->pc = (m->ma + 1) & 07777;
        break;
    }
}

static void interrupt(struct pdp8l *m)
{
    m->state = EXECUTE;
    m->next = FETCH;
    m->now += CYCLE;
    m->ir = 4;
    m->ma = m->field = 0;
    m->saved_inst = m->inst_field;
    m->saved_data = m->data_field;
    m->inst_field = m->data_field = m->inst_buffer = 0;
    write_core(m, m->pc);
    m->pc = 1;
    m->ion = m->ion_ready = 0;
}

/* LOAD IF, at the end of the cycle before the first one in the new field. */
static void load_if(struct pdp8l *m)
{
    if (m->ir == 4 && m->next != EXECUTE) return;
    if (m->ir == 5 && m->next != FETCH) return;
    m->inst_field = m->inst_buffer;
    m->inhibit = 0;
}

static void end(struct pdp8l *m, tick began)
{
    if (m->next != FETCH || !(m->ion || m->breakers)) return;
    if (m->ion) devices(m, m->now); /* looked at in the same TP3 in which HLT, STOP or SING STEP takes RUN away */
    if (m->ion && m->ion_ready && !m->inhibit && request(m)) m->next = INTERRUPT;
    else accept_break(m, began + 10);
    if (m->ion && m->next <= INTERRUPT) m->ion_ready = 1; /* a break is no instruction */
}

static int next_field(const struct pdp8l *m)
{
    switch (m->next) {
    case EXECUTE: if (m->state == DEFER && m->ir < 4) return m->data_field; /* fall through */
    case FETCH: case DEFER: return m->inst_field;
    case BREAK: return m->breaker[m->breaker[1].breaking].field & (m->size - 1);
    default: return 0;
    }
}

void pdp8l_cycle(struct pdp8l *m)
{
    tick began = m->now;
    m->protect = m->stored = 0;
    switch (m->next) {
    case FETCH: fetch(m); break;
    case DEFER: defer(m); break;
    case EXECUTE: execute(m); break;
    case INTERRUPT: interrupt(m); break;
    default: break_cycle(m); break;
    }
    if (m->state <= DEFER && (m->ir == 4 || m->ir == 5)) load_if(m);
    end(m, began);
    m->ema = next_field(m);
    if (m->sing_step) m->run = 0;
}

int within(const struct pdp8l *m)
{
    return m->next == DEFER || m->next == EXECUTE || m->state == WORD_COUNT || m->state == CURRENT_ADDRESS;
}

void pdp8l_step(struct pdp8l *m)
{
    do pdp8l_cycle(m);
    while (within(m) && !m->protect);
}

static int wrote(const struct pdp8l *m) { return m->stored; }

static int place(const struct pdp8l *m) { return m->field | m->ma; }

void counted_cycle(struct pdp8l *m)
{
    struct counts *counts = m->counts;
    tick began = m->now;
    int interrupts = m->next == INTERRUPT;
    pdp8l_cycle(m);
    if (!counts) return;
    counts->executed[place(m)] += m->state == FETCH;
    counts->written[place(m)] += wrote(m);
    counts->interrupts += interrupts;
    counts->cycles++;
    counts->ticks += m->now - began;
}

static int marked(struct pdp8l *m, const uint8_t *marks)
{
    int reached = 0;
    do {
        counted_cycle(m);
        if (wrote(m)) reached |= marks[place(m)] & 2 || (m->state == EXECUTE && m->ir == 4 && marks[place(m)] & 1);
    } while (within(m) && !m->protect);
    return reached;
}

int pdp8l_run(struct pdp8l *m, tick until, tick last, const uint8_t *marks)
{
    int first = 1, reason = LIMIT;
    if (m->now >= until || m->instructions >= last) return LIMIT;
    if (m->sing_step) return pdp8l_run_cycles(m, 1);
    m->run = 1;
    while (reason == LIMIT && m->now < until && m->instructions < last) {
        int reached = 0;
        if (!first && m->state != BREAK && marks && marks[m->inst_field | m->pc] & 1) {
            reason = BREAKPOINT;
            break;
        }
        first = 0;
        if (marks) reached = marked(m, marks);
        else pdp8l_step(m);
        if (!m->run) reason = STOPPED;
        else if (reached) reason = BREAKPOINT;
    }
    devices(m, m->now);
    return reason;
}

int pdp8l_run_cycles(struct pdp8l *m, int count)
{
    if (count == 0) return LIMIT;
    m->run = 1;
    devices(m, m->now);
    for (; count && m->run; count--) counted_cycle(m);
    devices(m, m->now);
    return m->run ? LIMIT : STOPPED;
}

int pdp8l_endless(const struct pdp8l *m)
{
    struct pdp8l turn = *m;
    int steps;
    if (!breakers_still(m) || !still(m) || m->fast_reader.at != NEVER || m->fast_punch.at != NEVER) return 0;
    for (steps = 0; steps < 20000; steps++) {
        pdp8l_step(&turn);
        if (turn.pc == m->pc && turn.ac == m->ac) {
            turn.now = m->now;
            turn.instructions = m->instructions;
            if (!gates_same(&turn.teletype, &m->teletype)) continue;
            turn.teletype = m->teletype;
            turn.printed = m->printed;
            if (memcmp(&turn, m, sizeof turn) == 0) return 1;
        }
    }
    return 0;
}

void initialize(struct pdp8l *m)
{
    m->ac = m->link = m->ion = m->ion_ready = m->inhibit = 0;
    preset(m);
    breakers_initialize(m);
    initialize_devices(m);
}

void pdp8l_power_up(struct pdp8l *m, int fast)
{
    memset(m, 0, sizeof *m);
    m->fast = fast;
    m->size = FIELD;
    gates_power_up(&m->teletype);
    m->teletype.sender.lever = m->fast_tape.lever = m->punch_on = m->fast_punch_on = 1;
    m->fast_punch.at = NEVER;
    initialize(m);
}

void pdp8l_wait(struct pdp8l *m, tick ticks)
{
    if (ticks == 0) return;
    devices(m, m->now);
    m->now += ticks;
    devices(m, m->now);
}

void pdp8l_settle(struct pdp8l *m) { devices(m, m->now); }
