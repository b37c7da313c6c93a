/* The Teletype's interface as DEC built it: the flip-flops of the M706 receiver and the M707 transmitter, their
   clocks, and the mechanisms at both ends of the line.

   The tests hold the package's Teletype against this one. It is written from the description of the modules'
   flip-flops alone and shares nothing with the package, nor with devices.c. A flip-flop keeps the name that DEC's
   drawing gives it; clocked ones take their inputs as they stood before the edge.

   Times are in elevenths of a tick of 0.05 us, so that a unit of the line (1/110 s) and both clocks are whole numbers.
   What happens at one instant happens in the order of `step`. A tick has seen all that happens up to and including it.

   DEC's clocks run free; here their phase is the package's, by convention: a character whose start unit finds RUN at 0
   sets the receiver's clock, so that its first pulse comes 1/8 unit later; the transmitter's clock stands still at rest
   and starts with IOP4. The drawings do not decide whether the pulse that ends RUN is high for long enough to see a
   start unit; here it is not.

   Sources: DEC M706, M707 and PDP-8/I drawings. */

#include "teletype_gates.h"

#include <string.h>

enum { PER_TICK = 11, UNIT = 2000000, RECEIVER_CLOCK = UNIT / 8, TRANSMITTER_CLOCK = UNIT / 2, FRAME = 11 * UNIT };
enum { IOP1 = 29, IOP2 = 47, IOP4 = 65 }; /* ticks from the beginning of an IOT */
enum { MARK = 1, SPACE = 0, SKIP = 010000 };

#define NEVER INT64_MAX

/* M706 */

static int run(const struct receiver *r) { return r->active || r->in_last_unit; }

static void preset(struct receiver *r)
{
    r->active = 1;
    r->spike = 1;
    r->bits = 0377;
    r->reader_run = 0;
    r->stop_1 = r->stop_2 = 0;
}

static void receiver_shift(struct receiver *r, int line)
{
    r->flag = r->in_last_unit = !(r->bits & 1);
    r->bits = r->bits >> 1 | line << 7;
    if (r->spike && line == MARK) r->active = r->spike = 0;
}

static void rise(struct receiver *r, int line)
{
    int was_active = r->active;
    if (r->active) receiver_shift(r, line);
    r->stop_2 = r->stop_1;
    r->stop_1 = !was_active;
    if (r->stop_2) r->in_last_unit = 0;
}

static void fall(struct receiver *r)
{
    r->spike = 0;
    if (r->in_last_unit) r->active = 0;
}

static void receiver_pulse(struct receiver *r, int line)
{
    if (run(r)) {
        r->divider = (r->divider + 1) % 8;
        if (r->divider == 4) rise(r, line);
        if (r->divider == 0) fall(r);
        return;
    }
    r->divider = 1;
    if (line == SPACE) preset(r);
}

static void receiver_initialize(struct receiver *r)
{
    r->active = r->spike = r->flag = 0;
    r->reader_run = 1;
}

static int receiver_iop(struct receiver *r, int iop, int ac)
{
    if (iop == 1) return r->flag ? ac | SKIP : ac;
    if (iop == 4) return ac | r->bits;
    r->flag = 0;
    r->reader_run = 1;
    return ac & SKIP;
}

/* M707 */

static int more(const struct transmitter *t) { return t->enable || t->bits & 0376; }

static void transmitter_shift(struct transmitter *t)
{
    t->flag = !more(t);
    t->line = t->bits & 1;
    t->bits = t->bits >> 1 | t->enable << 7;
    t->enable = 0;
}

static void transmitter_edge(struct transmitter *t)
{
    struct transmitter was = *t;
    t->active = was.enable && !was.stop_2 || was.active && (was.freq_div || more(&was));
    t->freq_div = !(was.freq_div && was.active);
    t->stop_1 = was.active;
    t->stop_1_5 = was.stop_1;
    t->stop_2 = was.stop_1_5;
    if (!was.freq_div || !t->freq_div) t->stop_1 = t->stop_1_5 = t->stop_2 = 1;
    if (!was.freq_div) transmitter_shift(t);
    if (t->active && !was.active) t->line = SPACE;
    if (!t->active) t->line = MARK;
}

static int at_rest(const struct transmitter *t) { return !t->active && !t->enable && !t->stop_2; }

static void transmitter_initialize(struct transmitter *t)
{
    t->bits = t->enable = t->active = t->flag = 0;
    t->freq_div = 1;
    t->line = MARK;
}

static int transmitter_iop(struct transmitter *t, int iop, int ac)
{
    if (iop == 1) return t->flag ? ac | SKIP : ac;
    if (iop == 2) t->flag = 0;
    if (iop == 4) {
        t->bits |= ac & 0377;
        t->enable = 1;
    }
    return ac;
}

/* The keyboard and the reader: they send one frame after the other on the receiver's line. */

static int key_waits(const struct sender *s) { return s->keys_sent != s->keys; }

static int tape_waits(const struct gates *g)
{
    return g->sender.lever && g->receiver.reader_run && g->sender.position < g->sender.length;
}

/* The next change on the line, or the next unit that goes on without one. */
static int64_t next_unit(const struct gates *g)
{
    const struct sender *s = &g->sender;
    if (s->units) return s->at;
    if (!key_waits(s) && !tape_waits(g)) return NEVER;
    return s->at > g->now ? s->at : g->now;
}

static void send_unit(struct gates *g)
{
    struct sender *s = &g->sender;
    if (!s->units) {
        int frame = key_waits(s) ? s->keyboard[s->keys_sent++ % QUEUE] : s->tape[s->position++];
        s->units = 10; /* from the low end: start, eight of data, stop */
        s->shifting = frame << 1 | 01000;
        s->at = g->now;
        if (!run(&g->receiver)) g->receiver.pulse_at = g->now + RECEIVER_CLOCK;
    }
    s->line = s->shifting & 1;
    s->shifting >>= 1;
    s->units--;
    s->at += s->units ? UNIT : 2 * UNIT;
}

/* The printer's selector: a space that it finds at its stop is a start unit; then it samples eight units in their
   middle, whatever the line shows. */

static void look_for_start(struct selector *s, int line, int64_t now)
{
    if (s->unit || line == MARK) return;
    s->unit = 1;
    s->frame = 0;
    s->at = now + UNIT + UNIT / 2;
}

static void select_unit(struct gates *g)
{
    struct selector *s = &g->selector;
    if (s->unit == 9) {
        s->unit = 0;
        s->at = NEVER;
        return;
    }
    s->frame |= g->transmitter.line << (s->unit - 1);
    s->at += s->unit == 8 ? UNIT / 2 : UNIT;
    if (s->unit++ == 8) s->page[s->printed++ % QUEUE] = s->frame;
}

/* Time */

static int64_t earlier(int64_t a, int64_t b) { return a < b ? a : b; }

static int64_t next(const struct gates *g)
{
    return earlier(earlier(g->receiver.pulse_at, g->transmitter.edge_at), earlier(next_unit(g), g->selector.at));
}

/* Do all that happens at the next instant. */
static void step(struct gates *g)
{
    g->now = next(g);
    if (g->receiver.pulse_at == g->now) {
        receiver_pulse(&g->receiver, g->sender.line);
        g->receiver.pulse_at += RECEIVER_CLOCK;
    }
    if (g->transmitter.edge_at == g->now) {
        int rested = at_rest(&g->transmitter);
        transmitter_edge(&g->transmitter);
        g->transmitter.edge_at = rested ? NEVER : g->now + TRANSMITTER_CLOCK;
    }
    if (next_unit(g) == g->now) send_unit(g);
    if (g->selector.at == g->now) select_unit(g);
    look_for_start(&g->selector, g->transmitter.line, g->now);
}

static int visible(const struct gates *g)
{
    return g->receiver.flag << 2 | g->transmitter.flag << 1 | g->receiver.reader_run;
}

/* Run up to and including tick `until`, or to an earlier one in which a flag or READER RUN changes; return which. */
int64_t gates_run(struct gates *g, int64_t until)
{
    int before = visible(g);
    while (next(g) <= until * PER_TICK) {
        step(g);
        if (visible(g) != before) until = (g->now + PER_TICK - 1) / PER_TICK;
    }
    g->now = until * PER_TICK;
    return until;
}

static void run_to(struct gates *g, int64_t until)
{
    while (g->now < until * PER_TICK) gates_run(g, until);
}

/* Do an IOT that begins at tick `began`; return AC, and 010000 if it skips. */
int gates_iot(struct gates *g, int word, int ac, int64_t began)
{
    static const int at[] = {[1] = IOP1, [2] = IOP2, [4] = IOP4};
    for (int iop = 1; iop <= 4; iop *= 2) {
        if (!(word & iop)) continue;
        run_to(g, began + at[iop]);
        if ((word & 0770) == 0030) ac = receiver_iop(&g->receiver, iop, ac);
        if ((word & 0770) != 0040) continue;
        ac = transmitter_iop(&g->transmitter, iop, ac);
        if (g->transmitter.edge_at == NEVER && g->transmitter.enable) g->transmitter.edge_at = g->now;
    }
    return ac;
}

void gates_initialize(struct gates *g, int64_t now)
{
    run_to(g, now);
    receiver_initialize(&g->receiver);
    transmitter_initialize(&g->transmitter);
}

static int same_receiver(const struct receiver *a, const struct receiver *b)
{
    return a->flag == b->flag && a->bits == b->bits && a->reader_run == b->reader_run;
}

static int same_transmitter(const struct transmitter *a, const struct transmitter *b)
{
    return a->flag == b->flag && a->bits == b->bits && a->enable == b->enable && a->active == b->active &&
           a->stop_2 == b->stop_2;
}

/* Tell whether an IOT would meet the same in both. */
int gates_same(const struct gates *a, const struct gates *b)
{
    return same_receiver(&a->receiver, &b->receiver) && same_transmitter(&a->transmitter, &b->transmitter);
}

int64_t gates_now(const struct gates *g) { return g->now / PER_TICK; }

/* The tick that sees what happens next. */
int64_t gates_next(const struct gates *g) { return (next(g) + PER_TICK - 1) / PER_TICK; }

void gates_power_up(struct gates *g)
{
    memset(g, 0, sizeof *g);
    g->transmitter.edge_at = NEVER;
    g->sender.line = MARK;
    g->selector.at = NEVER;
    gates_initialize(g, 0);
}

void gates_type(struct gates *g, int frame) { g->sender.keyboard[g->sender.keys++ % QUEUE] = frame; }

void gates_load_tape(struct gates *g, const uint8_t *frames, int length)
{
    memcpy(g->sender.tape, frames, length);
    g->sender.length = length;
    g->sender.position = 0;
}
