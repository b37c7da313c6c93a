/* The fewest blocks that mill a curve with both axes moving, every feed within so many percent: an exact search.

   usage: fewest line|oval WIDTH HEIGHT PERCENT [MARGIN [FASTEST]]      lengths in thousandths of an inch

       line    from 0,0 to WIDTH,HEIGHT, within 5 of it
       oval    clockwise from 9 o'clock about 0,0 and back; WIDTH and HEIGHT are its semi-axes, and those of its
               limits are 5 less and 5 more

   A state is a stop, each place of the .001 grid in the band, with the feeds in force, codes 01 to FASTEST (5) of Table
   2.4 or none yet. A block sets one feed and goes to any stop such that both extremes of its path, X fast and Y slow, X slow
   and Y fast, stay in the band: all other paths lie between these two. The search goes through all states of one block,
   then of two: the first number of blocks that reaches the end is the least.

   Assumed: a stop never goes back along the curve (its projection on the line, its angle on the oval); behind the last
   stop that a block reaches, MARGIN stops more are tried (800, some 70 columns), not all that there are.

   Prints the number, then each block: X, Y, axis whose feed it sets, code. It shares nothing with the package. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BAND = 5 };
static const double FEED[] = { 0, 1.0, 1.9, 2.7, 4.0, 5.5, 7.2, 9.1, 11.2, 13.3, 16.0, 18.6, 21.5, 24.7, 27.9, 31.5, 35.6, 39.7, 44.0 };
static const double EXACT = 1e-9;

typedef struct { double x, y; } Place;
typedef struct { int x, y; double along; } Stop;
typedef struct { int stop, pair; } State;

static double width, height, wrong, limit; /* limit: of the line, times its length */
static int oval, codes = 6; /* codes: with 0, no feed */
static Stop *stops;
static int count;

static int in_band(double x, double y)
{
    if (!oval)
        return fabs(width * y - height * x) <= limit;
    double a = width + BAND, b = height + BAND, c = width - BAND, d = height - BAND;
    return x * x * b * b + y * y * a * a <= a * a * b * b * (1 + EXACT)
        && x * x * d * d + y * y * c * c >= c * c * d * d * (1 - EXACT);
}

/* Whether the straight way between two places of the band stays in it: it may cross the oval's inner limit. */
static int stays(Place from, Place to)
{
    if (!oval)
        return 1;
    double c = width - BAND, d = height - BAND;
    double x = from.x / c, y = from.y / d, u = to.x / c - x, v = to.y / d - y, square = u * u + v * v;
    double part = square > 0 ? -(x * u + y * v) / square : 0;
    if (part <= 0 || part >= 1)
        return 1;
    x += part * u, y += part * v;
    return x * x + y * y >= 1 - EXACT;
}

/* Whether the path to a stop stays in the band when Y goes `rise` times as fast as X. */
static int keeps(const Stop *from, const Stop *to, double rise, double run)
{
    double across = to->x - from->x, up = to->y - from->y, climbs = fabs(across) * rise;
    Place start = { from->x, from->y }, end = { to->x, to->y }, corner = end;
    if (climbs < fabs(up))
        corner.y = start.y + copysign(climbs, up);
    else
        corner.x = start.x + copysign(fabs(up) * run, across);
    return in_band(corner.x, corner.y) && stays(start, corner) && stays(corner, end);
}

/* Whether a block at a pair of feeds may go to a stop, however they err; an axis without a feed stands still. */
static int reaches(const Stop *from, const Stop *to, int pair)
{
    double x = FEED[pair / codes], y = FEED[pair % codes], least = (1 - wrong) / (1 + wrong);
    if (!x || !y)
        return (x || to->x == from->x) && (y || to->y == from->y) && stays((Place){ from->x, from->y }, (Place){ to->x, to->y });
    double rise = y / x, run = x / y;
    return keeps(from, to, rise * least, run / least) && keeps(from, to, rise / least, run * least);
}

static double along(int x, int y)
{
    if (!oval)
        return x * width + y * height;
    double angle = atan2(y, -x);
    return angle < 0 ? angle + 2 * acos(-1) : angle;
}

static int by_along(const void *one, const void *other)
{
    double a = ((const Stop *)one)->along, b = ((const Stop *)other)->along;
    return (a > b) - (a < b);
}

static void add(int x, int y, double at)
{
    stops[count++] = (Stop){ x, y, at };
}

static void list_stops(void)
{
    int reach_x = (int)width + BAND, reach_y = (int)height + BAND;
    stops = malloc(sizeof *stops * 400000);
    for (int x = oval ? -reach_x : 0; x <= reach_x; x++)
        for (int y = oval ? -reach_y : 0; y <= reach_y; y++) {
            double at = along(x, y), last = oval ? 2 * acos(-1) : along((int)width, (int)height);
            if (!in_band(x, y) || at > last)
                continue;
            add(x, y, at);
            if (oval && at == 0) /* where it starts it ends */
                add(x, y, last);
        }
    qsort(stops, count, sizeof *stops, by_along);
}

static int find(int x, int y, int last)
{
    int found = -1;
    for (int at = 0; at < count && (last || found < 0); at++)
        if (stops[at].x == x && stops[at].y == y)
            found = at;
    return found;
}

static void print_way(State *came, int stop, int pair)
{
    State from = came[(size_t)stop * codes * codes + pair];
    if (from.stop < 0)
        return;
    print_way(came, from.stop, from.pair);
    int x_changed = from.pair / codes != pair / codes;
    int x_is_set = x_changed || (from.pair % codes == pair % codes && pair / codes);
    printf("%d %d %c %d\n", stops[stop].x, stops[stop].y, x_is_set ? 'X' : 'Y', x_is_set ? pair / codes : pair % codes);
}

int main(int arguments, char **argument)
{
    if (arguments < 5)
        return 2;
    oval = !strcmp(argument[1], "oval");
    width = atof(argument[2]), height = atof(argument[3]), wrong = atof(argument[4]) / 100;
    int margin = arguments > 5 ? atoi(argument[5]) : 800;
    if (arguments > 6)
        codes = atoi(argument[6]) + 1;
    size_t pairs = codes * codes;
    limit = BAND * hypot(width, height) * (1 + EXACT);
    list_stops();
    int start = oval ? find(-(int)width, 0, 0) : find(0, 0, 0);
    int end = oval ? find(-(int)width, 0, 1) : find((int)width, (int)height, 1);
    size_t states = (size_t)count * pairs;
    State *came = malloc(sizeof *came * states), *now = malloc(sizeof *now * states), *next = malloc(sizeof *next * states);
    char *seen = calloc(states, 1), *left = calloc(states, 1);
    int many = 1;
    now[0] = (State){ start, 0 };
    came[start * pairs] = (State){ -1, 0 };
    for (int blocks = 1; many; blocks++) {
        int found = 0;
        for (int each = 0; each < many; each++) {
            State from = now[each];
            int x = from.pair / codes, y = from.pair % codes;
            for (int set = 2; set < 2 * codes; set++) {
                int pair = set % 2 ? x * codes + set / 2 : set / 2 * codes + y;
                if (left[from.stop * pairs + pair])
                    continue;
                left[from.stop * pairs + pair] = 1;
                int to = from.stop;
                while (to > 0 && stops[to - 1].along == stops[from.stop].along)
                    to--;
                for (int misses = 0; to < count && misses <= margin; to++, misses++) {
                    if (!reaches(&stops[from.stop], &stops[to], pair))
                        continue;
                    misses = 0;
                    if (seen[to * pairs + pair])
                        continue;
                    seen[to * pairs + pair] = 1;
                    came[to * pairs + pair] = from;
                    next[found++] = (State){ to, pair };
                    if (to == end) {
                        printf("%d\n", blocks);
                        print_way(came, to, pair);
                        return 0;
                    }
                }
            }
        }
        State *other = now;
        now = next, next = other, many = found;
    }
    return 1;
}
