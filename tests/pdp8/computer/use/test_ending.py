"""Why a program ended: programs that die in many ways, and the same sentence in every front end."""

import re
from pathlib import Path
from typing import NamedTuple

import pytest

import pal
from pal.assembly import PAL8
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.machine import Machine
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason, Stop, Why
from pdp8.computer.use import ending
from pdp8.computer.use.program import Program, read
from pdp8.computer.use.trace import Listing
from pdp8.console.session import Session
from pdp8.dap.breakpoints import Breakpoints
from pdp8.dap.debuggee import Debuggee
from pdp8.dap.launch import Launch
from pdp8.monitor.commands import do
from pdp8.monitor.prompt import Monitor
from tests.conftest import Call
from tests.pdp8.computer.bench import core, machine
from tests.pdp8.lessons import exercise, mark
from tests.pdp8.web.node import in_node, needs_node

KSF, RSF, PSF, TSF = ("6031 5200", "6011 5200", "6021 5200", "6041 5200")
NO_CHARACTER = "no character is on its way"


class Death(NamedTuple):
    """A program, what else is done to the machine, how its run ends, and the sentences that say why."""

    name: str
    also: str
    source: str
    ended: str
    said: list[str]

    @property
    def program(self) -> Program:
        return read(self.source.encode(), "x")


def _deaths() -> list[Death]:
    _, *pieces = (Path(__file__).parent / "deaths.txt").read_text().split("== ")
    found = []
    for piece in pieces:
        head, _, rest = piece.partition("\n")
        source, _, told = rest.partition("= ")
        end, *said = told.rstrip().split("\n- ")
        name, _, also = head.partition(" ")
        found.append(Death(name, also, source, end, said))
    return found


DEATHS = {death.name: death for death in _deaths()}
every_death = pytest.mark.parametrize("death", DEATHS.values(), ids=DEATHS)


def prepared(death: Death, field: int = 0) -> tuple[Machine, History]:
    """Return the machine with the program in a field, started, and its history."""
    m = Machine(memory=(field + 1) << 12)
    m.load({field << 12 | address: word for address, word in death.program.words.items()})
    m.panel.data_field = field
    m.start(field << 12 | 0o200)
    history = History(m)
    m.panel.mem_prot = death.also == "mem_prot"
    if death.also == "keys":
        m.teletype.keyboard.press(b"\310\311")
    return m, history


def explained(death: Death, field: int = 0) -> tuple[Stop, Machine]:
    m, history = prepared(death, field)
    words = {field << 12 | address: word for address, word in death.program.words.items()}
    return ending.explained(m.run(seconds=2), history, words), m


class Addresses:
    """The addresses of the instructions that a machine executed."""

    def __init__(self) -> None:
        self.all: list[int] = []

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        if processor.state == 0:
            self.all.append(processor.ma)

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        pass


@every_death
def test_it_is_true_by_the_trace(death: Death) -> None:
    """Where it left its words, by what was executed; and the machine stands as it stood."""
    stop, after = explained(death)
    m, _ = prepared(death)
    m.watch.observer = trace = Addresses()
    if m.run(seconds=2, instructions=200_000).reason is not Reason.LIMIT:
        assert after.values()["core"] == m.values()["core"]
    executed = trace.all
    words = death.program.words
    strange = next((at for at, address in enumerate(executed) if address not in words), None)
    for why in stop.why:
        if why.what in (ending.LEFT, ending.JUMPED, ending.INTERRUPTED):
            assert strange is not None
            assert executed[strange] == why.other
            assert why.what == ending.INTERRUPTED or executed[strange - 1] == why.address
        else:
            assert strange is None
        if why.what not in (ending.UNREAD, ending.PROTECTED):
            assert why.address in executed
    late = ending.explained(stop, History(after), words)
    past = {*ending.DEPARTURES, ending.LOST, ending.UNREAD}
    assert not past & {why.what for why in late.why}, "the history begins behind it"


@every_death
def test_in_field_1_it_is_the_same(death: Death) -> None:
    """But for an interrupt and MEM PROT, which are of field 0."""
    if "ION" in death.source or death.also == "mem_prot":
        pytest.skip("an interrupt's handler, and what is protected, are in field 0")
    ends = [explained(death, field) for field in (0, 1)]
    (below, _), (stop, _) = ends

    def there(address: int) -> int:
        return address + 0o10000 if address >= 0 else address

    assert stop.why == tuple(
        why._replace(
            address=there(why.address),
            other=why.other if why.what == ending.WRITTEN else there(why.other),
            through=there(why.through),
        )
        for why in below.why
    )
    said = [" ".join([ending.ended(*end), *ending.sentences(end[0], Listing(), end[1].core)]) for end in ends]
    assert re.sub(r"\b1([0-7]{4})\b", r"\1", said[1]) == said[0]


@every_death
def test_run_says_it(death: Death, call: Call) -> None:
    Path("x").write_text(death.source)
    if death.also:
        pytest.skip("nobody is at the panel or the keyboard")
    _, _, said = call("pdp8 run x --max-time 2")
    first, *rest = (line.removeprefix("pdp8 run: ") for line in said.splitlines())
    assert rest == death.said
    assert first.startswith(death.ended) or "for a key" in death.ended, "it has a tape, which is empty"


def test_run_says_it_from_cold(call: Call) -> None:
    """Where the loaders are in core, other words are run before the program stands still."""
    said = {}
    for name in ("nohlt", "noreturn", "jump400", "tsf"):
        Path("x").write_text(DEATHS[name].source)
        status, _, lines = call("pdp8 run x --boot --quiet")
        said[name] = status, [line.removeprefix("pdp8 run: ") for line in lines.splitlines()[1:]]
    assert said == {name: (1, DEATHS[name].said) for name in said}


def test_the_loaders_are_loaded_too(call: Call) -> None:
    """A jump to BIN leaves no words, nor is it the end of a program that waits for the next tape there."""
    Path("x").write_text("*200\nCLA\nJMP I .+1\n7777\n$\n")
    status, _, said = call("pdp8 run x --boot --quiet")
    assert status == 1
    (why,) = said.splitlines()[1:]
    assert "It waits for device 01 at 7647 (RSF): no such device is fitted" in why


def test_a_run_is_repeated_with_what_came_in_meanwhile() -> None:
    """A program that reads two frames of a pipe, has another first word, and leaves its words."""
    words = core("6031 5200 6036 2211 5200 7200 1212 3200 5310 7776 5210")
    m = Machine()
    m.load(words)
    m.teletype.reader.load(b"A")
    m.start(0o200)
    began = m.values()
    m.run(seconds=0.15)
    m.teletype.reader.tape += b"B"
    m.teletype.receiver.look()
    stop = ending.explained(m.run(seconds=2), ending.rerun(m, began), words)
    assert [(why.what, why.address, why.other) for why in stop.why] == [(ending.JUMPED, 0o210, 0o310)]


@every_death
def test_the_monitor_says_it(death: Death) -> None:
    lines: list[str] = []
    monitor = Monitor(lines.append)
    monitor.machine.load(death.program.words)
    monitor.listing = death.program.listing
    for line in [
        *["set mem_prot 1"] * (death.also == "mem_prot"),
        "go 200 0",
        *['keyboard now "HI"'] * (death.also == "keys"),
        "run 2",
    ]:
        do(monitor, line)
    assert lines[-len(death.said) :] == death.said or not death.said


@every_death
def test_the_panel_says_it(death: Death) -> None:
    m, _ = prepared(death)
    session = Session(m, clock=lambda: 0.0)
    session.listing = death.program.listing
    while session.machine.elapsed < 2 and session.said in ("running", "standing still"):
        session.advance(0.5)
    if death.ended != "still running":
        assert session.said == ". ".join([death.ended, *death.said])


@every_death
def test_the_debugger_says_it(death: Death, tmp_path: Path) -> None:
    (tmp_path / "x.pal").write_text(death.source)
    debuggee = Debuggee(Launch.of({"program": str(tmp_path / "x.pal")}), Breakpoints())
    debuggee.monitor.machine.panel.mem_prot = death.also == "mem_prot"
    if death.also == "keys":
        debuggee.monitor.machine.teletype.keyboard.press(b"\310\311")
    debuggee.run()
    ended = None
    while ended is None and debuggee.monitor.machine.elapsed < 2:
        ended = debuggee.advance()
    if ended is not None:
        assert debuggee.said[-len(death.said) :] == death.said or not death.said
        assert ended.description == death.ended


_ON_THE_PAGE = """async (deaths) => {
  globalThis.document = { getElementById: () => ({ classList: { contains: () => false } }) }; // all are
  const { assemble } = await import("@/pal/assembling.mjs");
  const { Machine } = await import("@/pdp8/computer/machine.mjs");
  const { one_of_each } = await import("@/pdp8/computer/hardware/devices.mjs");
  const { History } = await import("@/pdp8/computer/past/history.mjs");
  const { Stop } = await import("@/pdp8/computer/stop.mjs");
  const { Goal } = await import("@/pdp8/computer/use/goals.mjs");
  const { told } = await import("@/pdp8/computer/use/ending.mjs");
  const { Listing } = await import("@/pdp8/computer/use/trace.mjs");
  const { next } = await import("@/pdp8/web/bench/next.mjs");
  return deaths.map(([name, also, source]) => {
    const assembly = assemble(source);
    // on the page device 01 is fitted
    const machine = new Machine(["rsf", "oneline"].includes(name) ? null : one_of_each());
    machine.load(assembly.words);
    machine.start(0o200);
    const history = new History(machine);
    machine.panel.mem_prot = also === "mem_prot";
    if (also === "keys") machine.teletype.keyboard.press([0o310, 0o311]);
    let reason = "limit";
    for (let slice = 0; slice < 20 && reason === "limit"; slice++) {
      reason = history.together(() => new Goal().run(machine, 2_000_000));
    }
    const [stop, why] = told(new Stop(reason, machine.pc, machine.elapsed), history, Listing.of(assembly));
    if (reason !== "idle") machine.panel.stop();
    return next({ machine, why, stop })[0];
  });
}"""


@needs_node
def test_the_page_says_it() -> None:
    """Beside the keys that end it."""
    given = [(death.name, death.also, death.source) for death in DEATHS.values()]
    for death, said in zip(DEATHS.values(), in_node(_ON_THE_PAGE, given), strict=True):
        ended = said.partition(". ")[0] if death.ended == "still running" else death.ended
        assert said[1:].startswith(". ".join([ended, *death.said])[1:]), death.name


@every_death
def test_check_says_it(death: Death) -> None:
    """Core that was not loaded is drawn there, which is where the last program gets its address."""
    if death.also or death.name == "autoindex":
        pytest.skip("nobody is at the panel or the keyboard, or core differs")
    (found,) = mark(exercise("stop='tape out'\nseconds=2"), death.source).marks
    said = [str(failure.got) for failure in found.failures if failure.what == "the end"]
    assert all(sentence in " ".join(said) for sentence in death.said)


@pytest.mark.parametrize(
    ("words", "tape", "said", "hands"),
    [
        (KSF, None, "a key, or a tape in the reader", ["keyboard", "tape"]),
        (KSF, b"", "a key, or a tape in the reader", ["keyboard", "tape"]),
        ("6032 6031 5201", b"", "a key, or a tape in the reader", ["keyboard", "tape"]),
        (RSF, None, "from the high-speed reader at 0200 (RSF): it has no tape", ["high-speed tape"]),
        ("6014 6011 5201", b"", "its tape has run out", ["high-speed tape"]),
        (RSF, b"AB", "no RFC asked for one", ["high-speed tape"]),
        (PSF, None, "It waits for the high-speed punch", []),
        (TSF, None, NO_CHARACTER, []),
        ("6031 7410 5206 6041 5200 5206 7402", None, NO_CHARACTER, ["keyboard", "tape"]),
        ("6001 5201", None, "It waits for a key", ["keyboard", "tape"]),
        ("5200", None, "It goes round at 0200", []),
    ],
)
def test_what_is_waited_for(words: str, tape: bytes | None, said: str, hands: list[str]) -> None:
    """And nothing else is named."""
    m = machine(words, tape, highspeed="6011" in words or "6021" in words)
    assert m.run(seconds=9).reason in (Reason.IDLE, Reason.TAPE_OUT)
    waits = ending.waits_for(m)
    sentences = " ".join(ending.said(why, Listing(), m.core) for why in waits)
    assert said in sentences
    assert ending.hands(m, waits) == hands
    if hands == ["high-speed tape"] or not hands:
        assert "a key" not in sentences


def test_the_line_is_said_without_its_comment() -> None:
    """In PAL8 a slash behind a quote is a character."""
    listing = Listing.of(pal.assemble('*200\nA,\tJMP A+"/-"/\t/GO\n$\n', dialect=PAL8))
    m = machine("5200")
    m.run(seconds=9)
    (why,) = ending.waits_for(m)
    assert 'at 0200 (A, JMP A+"/-"/):' in ending.said(why, listing, m.core)


@pytest.mark.parametrize(("tape", "hand"), [(b"AB", "lever"), (None, "tape")])
def test_a_lever_at_stop(tape: bytes | None, hand: str) -> None:
    m = machine(KSF, tape)
    m.teletype.reader.lever(False)
    m.run(seconds=9)
    assert ending.hands(m, ending.waits_for(m)) == ["keyboard", hand]


@pytest.mark.parametrize("what", [ending.LOST, ending.UNREAD])
@pytest.mark.parametrize(("number", "said"), [(1, "1 character "), (2, "2 characters "), (1234, "1,234 ch")])
def test_lost_characters_are_counted(what: str, number: int, said: str) -> None:
    assert said in ending.said(Why(what, 0o200, number=number), Listing(), Machine().core)
