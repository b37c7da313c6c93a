/* The devices of the reference PDP-8/L: the ASR-33 and its interface, which is the one made of flip-flops
   (teletype_gates.c), and the PC8/L reader and punch.

   Conventions, where the books leave a choice: what a mechanism has begun when the processor stops is printed and
   punched then, and not again; an RFC during a fetch starts no second one; a PPC while the punch works ors into its
   frame.

   Sources: Small Computer Handbook 1970, PC8 reader and punch. */

#include <string.h>

#include "parts.h"

enum { READ = 66667, PUNCH = 400000, FOUR_FRAMES = 4 * 2000000 };

static void put(struct paper *paper, int frame) { paper->frames[paper->count++ % PAPER_FRAMES] = frame; }

static int ready(const struct reader *reader) { return reader->lever && reader->position < reader->length; }

/* ---- 03 and 04 ---- */

/* Take what the selector has printed since; it has `ahead` of it already. */
static void print(struct pdp8l *m, const struct selector *s)
{
    for (; m->printed < s->printed; m->printed++) {
        put(&m->page, s->page[m->printed % QUEUE]);
        if (m->punch_on) put(&m->punched, s->page[m->printed % QUEUE]);
    }
}

static int at_rest(const struct gates *g)
{
    return !g->transmitter.active && !g->transmitter.enable && (g->selector.unit == 0 || g->selector.unit == 9);
}

static void look(struct pdp8l *m)
{
    print(m, &m->teletype.selector);
    if (at_rest(&m->teletype)) m->printed = m->teletype.selector.printed;
}

static void run_teletype(struct pdp8l *m, tick now)
{
    do gates_run(&m->teletype, now);
    while (gates_now(&m->teletype) < now);
    look(m);
}

/* Whether no flag of the Teletype changes any more by itself. */
int still(const struct pdp8l *m)
{
    struct gates left = m->teletype;
    tick until = gates_now(&left) + FOUR_FRAMES;
    while (gates_now(&left) < until) {
        gates_run(&left, until);
        if (left.receiver.flag != m->teletype.receiver.flag || left.transmitter.flag != m->teletype.transmitter.flag)
            return 0;
    }
    return 1;
}

void teletype_iot(struct pdp8l *m, int word, tick began)
{
    int answer = gates_iot(&m->teletype, word, m->ac, began);
    if (answer & 010000) skip(m);
    m->ac = answer & 07777;
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
    run_teletype(m, now);
    if (m->fast_reader.at <= now)
        frame_fetched(m);
    if (m->fast_punch.at <= now)
        frame_punched(m);
    breakers_until(m, now);
}

static tick earlier(tick a, tick b) { return a < b ? a : b; }

tick pdp8l_next(const struct pdp8l *m)
{
    return earlier(gates_next(&m->teletype), earlier(m->fast_reader.at, m->fast_punch.at));
}

int request(const struct pdp8l *m)
{
    return m->teletype.receiver.flag || m->teletype.transmitter.flag || m->fast_reader.flag || m->fast_punch.flag ||
           breakers_request(m);
}

void initialize_devices(struct pdp8l *m)
{
    gates_initialize(&m->teletype, m->now);
    look(m);
    m->fast_reader = (struct fast_reader){.at = NEVER};
    punch_frame(m);
    m->fast_punch = (struct fast_punch){.at = NEVER};
}

/* ---- the pulses of an IOT that began at tick `began` ---- */

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

/* What a hand brings on begins when time goes on, and is seen by what the devices have come to. */
static void catch_up(struct pdp8l *m)
{
    if (gates_now(&m->teletype) < m->now) devices(m, m->now);
}

void pdp8l_type(struct pdp8l *m, const uint8_t *frames, int count)
{
    int n;
    catch_up(m);
    for (n = 0; n < count; n++) gates_type(&m->teletype, frames[n]);
}

void pdp8l_tape(struct pdp8l *m, int fast, const uint8_t *frames, int count)
{
    catch_up(m);
    if (fast) {
        memcpy(m->fast_tape.tape, frames, count);
        m->fast_tape.length = count;
        m->fast_tape.position = 0;
        pdp8l_lever(m, fast, m->fast_tape.lever);
    } else {
        gates_load_tape(&m->teletype, frames, count);
    }
}

void pdp8l_lever(struct pdp8l *m, int fast, int start)
{
    catch_up(m);
    if (!fast) {
        m->teletype.sender.lever = start;
        return;
    }
    m->fast_tape.lever = start;
    if (m->fast_reader.fetching && m->fast_reader.at == NEVER) fetch_frame(m, m->now);
}

void pdp8l_finish(struct pdp8l *m)
{
    struct gates left = m->teletype;
    while (!at_rest(&left)) gates_run(&left, gates_now(&left) + 1 + FOUR_FRAMES / 44);
    print(m, &left.selector);
    punch_frame(m);
    m->fast_punch.ahead = m->fast_punch.at != NEVER;
}
