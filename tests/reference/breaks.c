/* The memory extension MC8/L and data breaks, with a device that asks for them.

   Written from DEC's drawing D-BS-MC8-L-2 and from what is said of a PDP-8's break cycles, without the package's at hand:

     BRK RQ is seen at TP1, 10 ticks into a cycle. Where an instruction ends and no interrupt is taken, the nearest device
     that was seen gets WORD COUNT, CURRENT ADDRESS and BREAK, or BREAK alone. WORD COUNT and CURRENT ADDRESS are in field
     0, BREAK in the device's. The word count overflows with the carry of its own cycle.

   The device, for IOT 67nX: 1 skips if its flag is up, 2 clears it, 4 starts it as AC says:

     4000 three cycles | 2000 into core | 1000 MEM INCREMENT | 400 CURRENT ADDRESS counts | 300 field | 77 period

   Its word count is at 0030 and 0032. It asks every 11 + 37 times period ticks, until its word count overflows, or 20 times. */

#include "parts.h"

void breakers_initialize(struct pdp8l *m)
{
    for (int i = 0; i < BREAKERS; i++) {
        struct breaker *b = &m->breaker[i];
        b->flag = b->breaking = 0;
        b->at = b->asked = NEVER;
    }
}

void breakers_until(struct pdp8l *m, tick now)
{
    if (!m->breakers) return;
    for (int i = 0; i < BREAKERS; i++) {
        struct breaker *b = &m->breaker[i];
        if (b->at <= now && b->asked == NEVER) b->asked = b->at;
    }
}

int breakers_request(const struct pdp8l *m)
{
    return m->breakers && (m->breaker[0].flag || m->breaker[1].flag);
}

int breakers_still(const struct pdp8l *m)
{
    return !m->breakers || (m->breaker[0].at == NEVER && m->breaker[1].at == NEVER);
}

void breaker_iot(struct pdp8l *m, int which, int word, tick began)
{
    struct breaker *b = &m->breaker[which];
    devices(m, began + IOP1);
    if (word & 1 && b->flag) skip(m);
    devices(m, began + IOP2);
    if (word & 2) b->flag = 0;
    devices(m, began + IOP4);
    if (!(word & 4)) return;
    b->three_cycle = !!(m->ac & 04000);
    b->into_core = !!(m->ac & 02000);
    b->increments = !!(m->ac & 01000);
    b->counts_address = !!(m->ac & 0400);
    b->field = (m->ac & 0300) << 6;
    b->period = 11 + 37 * (m->ac & 077);
    b->left = 20;
    b->asked = NEVER;
    b->at = began + IOP4 + b->period;
}

void accept_break(struct pdp8l *m, tick tp1)
{
    if (!m->breakers) return;
    breakers_until(m, tp1);
    for (int i = BREAKERS - 1; i >= 0; i--) {
        struct breaker *b = &m->breaker[i];
        if (b->asked <= tp1) {
            b->asked = NEVER;
            b->breaking = 1;
            b->address = b->three_cycle ? 030 + 2 * i : b->word;
            b->at += b->period;
            if (!b->three_cycle && --b->left == 0) {
                b->at = NEVER;
                b->flag = 1;
            }
            m->next = b->three_cycle ? WORD_COUNT : BREAK;
            return;
        }
    }
}

static struct breaker *breaking(struct pdp8l *m) { return &m->breaker[m->breaker[1].breaking]; }

void abandon_break(struct pdp8l *m)
{
    if (m->next >= WORD_COUNT && m->next <= BREAK) breaking(m)->breaking = 0;
}

void break_cycle(struct pdp8l *m)
{
    struct breaker *b = breaking(m);
    int overflow;
    m->now += CYCLE;
    m->state = m->next;
    m->field = 0;
    switch (m->state) {
    case WORD_COUNT:
        m->ma = b->address;
        m->mb = m->core[m->ma];
        overflow = m->mb + 1 > 07777;
        write_core(m, m->mb + 1);
        if (overflow) {
            b->flag = 1;
            b->at = b->asked = NEVER;
        }
        m->next = CURRENT_ADDRESS;
        break;
    case CURRENT_ADDRESS:
        m->ma = (m->ma + 1) & 07777;
        m->mb = m->core[m->ma];
        if (b->counts_address) write_core(m, m->mb + 1);
        m->next = BREAK;
        break;
    case BREAK:
        m->ma = b->three_cycle ? m->mb : b->address;
        m->field = b->field & (m->size - 1);
        m->mb = m->core[m->field | m->ma];
        b->breaking = 0;
        if (b->into_core) {
            b->word = (b->word * 5 + 1) & 07777;
            write_core(m, b->word);
        } else {
            b->word ^= m->mb;
            if (b->increments) write_core(m, m->mb + 1);
        }
        m->next = FETCH;
        break;
    }
}

static void load_ib(struct pdp8l *m, int field)
{
    m->inst_buffer = field;
    m->inhibit = 1;
}

/* MB 6 to 8 are the field; with one-bit registers MB 6 and 7 have to be 0. MB 9 lets SF into DF and IB. */
void extension_iot(struct pdp8l *m, int word)
{
    int field = (word >> 3 & 7) * FIELD;
    if (field < m->size) {
        if (word & 1) m->data_field = word & 4 ? m->saved_data : field;
        if (word & 2) load_ib(m, word & 4 ? m->saved_inst : field);
    }
    if (!(word & 4)) return;
    switch (word >> 3 & 7) {
    case 1: m->ac |= m->data_field / FIELD << 3; break;
    case 2: m->ac |= m->inst_field / FIELD << 3; break;
    case 3: m->ac |= m->saved_inst / FIELD << 3 | m->saved_data / FIELD; break;
    case 4:
        m->data_field = m->saved_data;
        load_ib(m, m->saved_inst);
        break;
    }
}

void load_address(struct pdp8l *m)
{
    if (m->size == FIELD) return;
    m->saved_inst = m->inst_field;
    m->saved_data = m->data_field;
    m->inst_field = m->inst_buffer = m->inst_switch;
    m->data_field = m->data_switch;
    m->inhibit = 0;
}

void pdp8l_rack(struct pdp8l *m, int size, int breakers)
{
    m->size = size;
    m->breakers = breakers;
}
