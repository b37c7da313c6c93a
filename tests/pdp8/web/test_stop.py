"""STOP in the page's machine: the instruction is done to its end, and an interrupt waits."""

from tests.pdp8.conftest import Ask

_STOPPED = """(afternoon, { core, cycles }) => {
  const machine = new afternoon.machine.constructor();
  for (const [address, word] of Object.entries(core)) machine.core[address] = word;
  const { panel, processor } = machine;
  processor.pc = 0o200;
  panel.start();
  for (let cycle = 0; cycle < cycles; cycle++) processor.cycle();
  panel.stop();
  const { ma, mb, pc, next, ion, clock, run } = processor;
  return [ma, mb, pc, next, ion, clock, run];
}"""


def test_stop_between_two_cycles_ends_the_instruction(ask: Ask) -> None:
    """ISZ I 0300, stopped after FETCH: DEFER and EXECUTE are done, the word at 0400 is counted."""
    core = {0o200: 0o2700, 0o300: 0o400, 0o400: 0o17}
    for cycles in (1, 2, 3):
        assert ask(_STOPPED, {"core": core, "cycles": cycles}) == [0o400, 0o20, 0o201, 0, 0, 96, 0]


def test_stop_comes_before_an_interrupt_of_the_same_instruction(ask: Ask) -> None:
    """TLS, ION, a JMP to itself: the flag has risen, the interrupt is due next, and STOP keeps it waiting."""
    core = {0o200: 0o6046, 0o201: 0o6001, 0o202: 0o5202}
    raised = 2 + (2_000_000 * 9 // 11 + 47 - 2 * 85) // 32
    for cycles in (raised, raised + 1, raised + 2, raised + 3):
        ma, mb, pc, following, ion, _, running = ask(_STOPPED, {"core": core, "cycles": cycles})
        seen = (ma, mb, pc, following, ion, running)
        if ma == 0:  # the interrupt was taken before STOP
            assert seen == (0, 0o202, 1, 0, 0, 0)
        else:
            assert seen == (0o202, 0o5202, 0o202, 0, 1, 0)
