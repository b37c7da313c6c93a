"""Faults put into the reference that few states show, so that the runner in C has to find them: what is
replaced by what in its C.
"""

FAULTS = {
    "a page of the next address": ("m->ma & 07600 : 0) |", "m->pc & 07600 : 0) |"),
    "autoindex 0017 missing": (
        "m->ma <= 017) write_core(m, m->mb + 1)",
        "m->ma < 017) write_core(m, m->mb + 1)",
    ),
    "autoindex at 0020": ("m->ma <= 017) write_core(m, m->mb + 1)", "m->ma <= 020) write_core(m, m->mb + 1)"),
    "a PC of 13 bits": (
        "m->pc = (m->pc + 1) & 07777;\n    m->instructions++",
        "m->pc++;\n    m->instructions++",
    ),
    "carry sets the link": ("m->link ^= sum >> 12", "m->link |= sum >> 12"),
    "ISZ skips at 7777": ("if (m->mb == 0) skip(m);", "if (m->mb == 07777) skip(m);"),
    "MEM PROT begins at 7700": ("m->ma >= 07600 && m->field == 0) {", "m->ma >= 07700 && m->field == 0) {"),
    "a protected DCA keeps AC": ("m->ac = 0;\n        break;", "if (!m->protect) m->ac = 0;\n        break;"),
    "SPA SNA SZL or-ed": (
        "if ((sma || sza || snl) != !!(word & 0010)) skip(m);",
        "if (word & 0010 ? !(sma && sza && snl) : sma || sza || snl) skip(m);",
    ),
    "OSR before CLA": (
        "if (word & 0200) m->ac = 0;\n    if (word & 0004) m->ac |= m->sr;",
        "if (word & 0004) m->ac |= m->sr;\n    if (word & 0200) m->ac = 0;",
    ),
    "ION at once": (
        "m->ion_ready = 1; /* a break is no instruction */",
        "m->ion_ready = 1;\n    if (m->ion && m->mb == 06001 && request(m)) m->next = INTERRUPT;",
    ),
    "an interrupt leaves ION": ("m->pc = 1;\n    m->ion = m->ion_ready = 0;", "m->pc = 1;"),
}
