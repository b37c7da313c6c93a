"""Faults put into the reference, which the runner in C has to find: what is replaced by what in its C."""

FAULTS = {
    "a page of the next address": ("m->ma & 07600 : 0) |", "m->pc & 07600 : 0) |"),
    "page bit inverted": ("m->mb & 0200 ? m->ma", "!(m->mb & 0200) ? m->ma"),
    "autoindex 0017 missing": ("m->ma <= 017) write(m, m->mb + 1)", "m->ma < 017) write(m, m->mb + 1)"),
    "autoindex at 0020": ("m->ma <= 017) write(m, m->mb + 1)", "m->ma <= 020) write(m, m->mb + 1)"),
    "a PC of 13 bits": (
        "m->pc = (m->pc + 1) & 07777;\n    m->instructions++",
        "m->pc++;\n    m->instructions++",
    ),
    "carry sets the link": ("m->link ^= sum >> 12", "m->link |= sum >> 12"),
    "DCA keeps AC": ("write(m, m->ac);\n        m->ac = 0;", "write(m, m->ac);"),
    "ISZ writes AC": ("case 2:\n        write(m, m->mb + 1)", "case 2:\n        write(m, m->ac)"),
    "ISZ skips at 7777": ("if (m->mb == 0) skip(m);", "if (m->mb == 07777) skip(m);"),
    "JMS executes its return address": (
        "m->pc = (m->ma + 1) & 07777;\n        break",
        "m->pc = m->ma;\n        break",
    ),
    "MEM PROT begins at 7700": ("m->ma >= 07600) {", "m->ma >= 07700) {"),
    "a protected DCA keeps AC": ("m->ac = 0;\n        break;", "if (!m->protect) m->ac = 0;\n        break;"),
    "both rotates do nothing": ("lac = left & right; break;", "break;"),
    "7002 is BSW": (
        "switch (word & 0014) {",
        "if ((word & 016) == 2) lac = (lac & 010000) | (lac & 077) << 6 | (lac >> 6 & 077);\n"
        "    switch (word & 0014) {",
    ),
    "IAC left out": ("if (word & 0001) lac = (lac + 1) & 017777;", ""),
    "group 3 clears AC": (
        "else if (!(m->mb & 1)) group2",
        "else if (m->mb & 1) { if (m->mb & 0200) m->ac = 0; } else group2",
    ),
    "SPA SNA SZL or-ed": (
        "if ((sma || sza || snl) != !!(word & 0010)) skip(m);",
        "if (word & 0010 ? !(sma && sza && snl) : sma || sza || snl) skip(m);",
    ),
    "OSR before CLA": (
        "if (word & 0200) m->ac = 0;\n    if (word & 0004) m->ac |= m->sr;",
        "if (word & 0004) m->ac |= m->sr;\n    if (word & 0200) m->ac = 0;",
    ),
    "KCC leaves AC": ("return ac & SKIP;\n}\n\n/* M707", "return ac;\n}\n\n/* M707"),
    "ION at once": (
        "m->ion_ready = 1;\n    }",
        "m->ion_ready = 1;\n        if (m->mb == 06001 && request(m)) m->next = INTERRUPT;\n    }",
    ),
    "an IOT takes a cycle": ("m->now += IOT;", "m->now += CYCLE;"),
    "an interrupt leaves ION": ("m->pc = 1;\n    m->ion = m->ion_ready = 0;", "m->pc = 1;"),
}
