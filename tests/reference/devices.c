/* The devices of the reference PDP-8/L: the ASR-33 and its interface (M706, M707), the PC8/L reader and punch.

   A unit of the Teletype's line is 1/110 s. Conventions, where the books leave a choice: a transmission from idle
   begins with its pulse; the reader begins as soon as READER RUN and the line allow it, but a start unit between
   IOP2 and IOP4 of one IOT is not in the buffer at its IOP4; the printer takes a space
   after its eighth data unit for a new start unit, and a line that falls silent ends in marks what it has begun; an
   RFC during a fetch starts no second one; a PPC while the punch works ors into its frame.

   Sources: Small Computer Handbook 1970, Teletype control, PC8 reader and punch; DEC M706 and M707 schematics. */

#include <string.h>

#include "parts.h"

enum { FRAME = 2000000, READ = 66667, PUNCH = 400000 };

static tick later(tick a, tick b) { return a > b ? a : b; }

/* The ticks of half units of the line, to the nearest: 22 are 0.1 s. */
static tick half_units(int count) { return (2 * (tick)count * (FRAME / 2) + 11) / 22; }

static void put(struct paper *paper, int frame) { paper->frames[paper->count++ % PAPER_FRAMES] = frame; }

static int ready(const struct reader *reader) { return reader->lever && reader->position < reader->length; }

/* ---- 03: the line from keyboard and reader, and its receiver ---- */

static void plan_receiver(struct pdp8l *m, tick now)
{
    struct receiver *r = &m->receiver;
    if (r->half)
        r->at = r->start + half_units(r->half);
    else if (m->keys_sent < m->keys || (r->reader_run && ready(&m->tape)))
        r->at = later(now, r->free);
    else
        r->at = NEVER;
}

static void receive(struct pdp8l *m, tick now)
{
    struct receiver *r = &m->receiver;
    if (r->half == 0) { /* a start unit */
        r->character = m->keys_sent < m->keys ? m->keyboard[m->keys_sent++] : m->tape.tape[m->tape.position++];
        r->reader_run = 0;
        r->buffer = 0377;
        r->start = now;
        r->free = now + FRAME;
        r->half = 1;
    } else if (r->half == 1) { /* no false start; what is unread is lost */
        r->flag = 0;
        r->half = 3;
    } else { /* the middle of a data unit */
        r->buffer = r->buffer >> 1 | (r->character & 1) << 7;
        r->character >>= 1;
        r->flag = r->half == 17;
        r->half = r->flag ? 0 : r->half + 2;
    }
    plan_receiver(m, now);
}

/* ---- 04: the transmitter, and the line to printer and punch ---- */

static void print(struct pdp8l *m, int mark)
{
    struct printer *p = &m->printer;
    if (p->unit == 0) {
        p->selected = 0;
        p->unit = !mark;
    } else {
        p->selected |= mark << (p->unit - 1);
        p->unit = p->unit == 8 ? 0 : p->unit + 1;
        if (p->unit == 0) {
            put(&m->page, p->selected);
            if (m->punch_on)
                put(&m->punched, p->selected);
        }
    }
}

static void silence(struct pdp8l *m)
{
    while (m->printer.unit)
        print(m, 1);
}

static void shift(struct pdp8l *m)
{
    struct transmitter *t = &m->transmitter;
    int mark = t->shift_register & 1;
    t->shift_register >>= 1;
    t->shifts++;
    t->flag = t->shift_register == 0;
    if (!t->ahead)
        print(m, mark);
    if (t->flag) { /* that was the end marker, the first stop unit; a second one follows */
        t->free = t->start + half_units(2 * t->shifts + 4);
        t->ahead = 0;
        t->at = NEVER;
        silence(m);
    } else {
        t->at = t->start + half_units(2 * t->shifts + 2);
    }
}

static void transmit(struct pdp8l *m, int character, tick now)
{
    struct transmitter *t = &m->transmitter;
    if (t->shift_register == 0) {
        t->start = later(now, t->free);
        t->shifts = 0;
        t->at = t->start + half_units(2);
        print(m, 0);
    } else if (t->ahead) {
        print(m, 0);
    }
    t->ahead = 0;
    t->shift_register |= 0400 | character;
}

/* ---- 01 and 02: the PC8/L ---- */

static void fetch_frame(struct pdp8l *m, tick now)
{
    m->fast_reader.fetching = 1;
    m->fast_reader.at = ready(&m->fast_tape) ? now + READ : NEVER;
}

static void frame_fetched(struct pdp8l *m)
{
    struct fast_reader *r = &m->fast_reader;
    r->at = NEVER;
    if (ready(&m->fast_tape)) {
        r->buffer = m->fast_tape.tape[m->fast_tape.position++];
        r->flag = 1;
        r->fetching = 0;
    }
}

static void punch_frame(struct pdp8l *m)
{
    struct fast_punch *p = &m->fast_punch;
    if (p->at != NEVER && !p->ahead && m->fast_punch_on)
        put(&m->fast_punched, p->buffer);
}

static void frame_punched(struct pdp8l *m)
{
    punch_frame(m);
    m->fast_punch.flag = 1;
    m->fast_punch.ahead = 0;
    m->fast_punch.at = NEVER;
}

/* ---- all devices ---- */

/* Let everything happen that happens up to and including tick `now`. */
void devices(struct pdp8l *m, tick now)
{
    while (m->receiver.at <= now)
        receive(m, m->receiver.at);
    while (m->transmitter.at <= now)
        shift(m);
    if (m->fast_reader.at <= now)
        frame_fetched(m);
    if (m->fast_punch.at <= now)
        frame_punched(m);
}

int request(const struct pdp8l *m)
{
    return m->receiver.flag || m->transmitter.flag || m->fast_reader.flag || m->fast_punch.flag;
}

void initialize_devices(struct pdp8l *m)
{
    struct receiver *r = &m->receiver;
    struct transmitter *t = &m->transmitter;
    r->flag = r->half = 0;
    r->reader_run = 1;
    plan_receiver(m, m->now);

    if (t->start > m->now) /* its start unit was still to come */
        m->printer.unit = 0;
    t->flag = t->shift_register = t->ahead = 0;
    t->free = m->now;
    t->at = NEVER;
    silence(m);

    m->fast_reader = (struct fast_reader){.at = NEVER};
    punch_frame(m);
    m->fast_punch = (struct fast_punch){.at = NEVER};
}

/* ---- the pulses of an IOT that began at tick `began` ---- */

void receiver_iot(struct pdp8l *m, int word, tick began)
{
    struct receiver *r = &m->receiver;
    int before;
    devices(m, began + IOP1);
    if (word & 1 && r->flag) skip(m);
    devices(m, began + IOP2 - 1);
    before = r->buffer;
    devices(m, began + IOP2);
    if (word & 2) {
        m->ac = r->flag = 0;
        r->reader_run = 1;
        plan_receiver(m, began + IOP2);
    }
    devices(m, began + IOP4);
    if (word & 4) m->ac |= word & 2 && r->half && r->start >= began + IOP2 ? before : r->buffer;
}

void transmitter_iot(struct pdp8l *m, int word, tick began)
{
    devices(m, began + IOP1);
    if (word & 1 && m->transmitter.flag) skip(m);
    devices(m, began + IOP2);
    if (word & 2) m->transmitter.flag = 0;
    devices(m, began + IOP4);
    if (word & 4) transmit(m, m->ac & 0377, began + IOP4);
}

void fast_reader_iot(struct pdp8l *m, int word, tick began)
{
    struct fast_reader *r = &m->fast_reader;
    devices(m, began + IOP1);
    if (word & 1 && r->flag) skip(m);
    devices(m, began + IOP2);
    if (word & 2) {
        m->ac |= r->buffer;
        r->flag = 0;
    }
    devices(m, began + IOP4);
    if (word & 4) {
        r->flag = r->buffer = 0;
        if (!r->fetching) fetch_frame(m, began + IOP4);
    }
}

void fast_punch_iot(struct pdp8l *m, int word, tick began)
{
    struct fast_punch *p = &m->fast_punch;
    devices(m, began + IOP1);
    if (word & 1 && p->flag) skip(m);
    devices(m, began + IOP2);
    if (word & 2) p->flag = p->buffer = 0;
    devices(m, began + IOP4);
    if (word & 4) {
        p->buffer |= m->ac & 0377;
        if (p->at == NEVER) p->at = began + IOP4 + PUNCH;
    }
}

/* ---- keys, tapes and levers ---- */

void pdp8l_type(struct pdp8l *m, const uint8_t *frames, int count)
{
    memcpy(m->keyboard + m->keys, frames, count);
    m->keys += count;
    plan_receiver(m, m->now);
}

void pdp8l_tape(struct pdp8l *m, int fast, const uint8_t *frames, int count)
{
    struct reader *reader = fast ? &m->fast_tape : &m->tape;
    memcpy(reader->tape, frames, count);
    reader->length = count;
    reader->position = 0;
    pdp8l_lever(m, fast, reader->lever);
}

void pdp8l_lever(struct pdp8l *m, int fast, int start)
{
    (fast ? &m->fast_tape : &m->tape)->lever = start;
    if (!fast) plan_receiver(m, m->now);
    else if (m->fast_reader.fetching && m->fast_reader.at == NEVER) fetch_frame(m, m->now);
}

void pdp8l_finish(struct pdp8l *m)
{
    struct transmitter *t = &m->transmitter;
    int rest;
    for (rest = t->ahead ? 0 : t->shift_register; rest; rest >>= 1)
        print(m, rest & 1);
    silence(m);
    t->ahead = t->shift_register != 0;
    punch_frame(m);
    m->fast_punch.ahead = m->fast_punch.at != NEVER;
}
