#include "toy.h"
int pc, ac, l, core[4096];
void step(void)
{
    int word = core[pc], address = (word & 0177) | (word & 0200 ? pc & 07600 : 0), total;
    if (word & 0400) address = core[address] = (core[address] + (address >> 3 == 1)) & 07777;
    total = (l << 12 | ac) + core[address];
    pc = (pc + 1) & 07777;
    ac = total & 07777;
    l = total >> 12 & 1;
}
