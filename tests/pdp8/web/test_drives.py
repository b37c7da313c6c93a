"""DECtape in the page: a reel that is dropped is mounted, boots as in Python to the tick, and is saved."""

import os
from pathlib import Path

import pytest

from pdp8.computer.use.bootstrap import boot
from tapes.dectape import decode
from tests.pdp8.computer.dectape import reel
from tests.pdp8.web.browsing import DESK, Browser, Page, click, until, visit

P = "workbench.machine.processor"
_GIVEN = """async () => {
  const given = [], { download } = workbench;
  workbench.download = (_, content) => given.push(content);
  workbench.save();
  workbench.download = download;
  await workbench.share();
  return [workbench.shared, ...given];
}"""
_TAKEN = "(text) => workbench.take(new File([text], 'taken'))"
SYSTEM = Path(os.environ.get("PDP8_OS8", "")) / "ps8.tu56"


def test_a_reel_boots_in_the_ticks_of_python(page: Page, tmp_path: Path) -> None:
    made, _ = reel.machine(0o20000)
    boot(made)
    made.run(10)
    assert made.teletype.printer.frames == b"\xcf\xcb"
    page.evaluate("void workbench.take(new File([new Uint8Array(1000)], 'wrong.tu56'))")
    until(page, "workbench.why.startsWith('wrong.tu56: 1,000 bytes; a DECtape image has')")
    assert page.evaluate("[workbench.machine.memory, workbench.machine.devices.length]") == [0o10000, 2]
    frames = [*Path(reel.file(tmp_path / "own.tu56")).read_bytes()]
    page.evaluate("(all) => void workbench.take(new File([new Uint8Array(all)], 'own.tu56'))", frames)
    until(page, "workbench.why.includes('Boot drive 0')")
    page.evaluate("['sing step', 'mem prot'].forEach((key) => workbench.switches.press(key))")
    click(page, "#boot-reel")
    until(page, "workbench.why.startsWith('HLT')")
    assert page.locator("#paper").inner_text().strip() == "OK"
    assert page.evaluate(f"[{P}.clock, {P}.pc, {P}.lac]") == [
        made.processor.clock,
        made.processor.pc,
        made.processor.lac,
    ]
    row = page.locator("[aria-label='Drive 0']")
    assert row.inner_text().strip().startswith("0: own.tu56, block 00")
    for block, said in ((6, "1 block"), (5, "2 blocks")):
        page.evaluate(f"workbench.touch(() => workbench.drives.control.drives[0].write({block}, 1, 0o1234))")
        until(page, f"document.getElementById('reels').textContent.includes('at rest, {said} written')")
    with page.expect_download() as saved:
        page.locator("[aria-label='Drive 0'] [data-click='drives.save']").click()
    image, _ = decode(saved.value.path().read_bytes())
    assert [image.words[129 * 5 + at] for at in (0, 1, 2)] == [5, 0o1234, 5]
    shared, state = page.evaluate(_GIVEN)
    page.reload()
    until(page, "!!window.workbench?.ready")
    page.evaluate(_TAKEN, state)
    assert page.evaluate("workbench.why").endswith("open it first")
    page.evaluate(f"{P}.core.fill(0)")
    page.evaluate(_TAKEN, shared)
    assert page.evaluate(f"[workbench.machine.memory, {P}.core[0o7640]]") == [0o20000, 0o317]
    assert row.is_hidden()  # a reel is too large to be kept
    page.evaluate(
        "() => { const { processor: p } = workbench.machine; p.extension.inst_field = 0o10000;"
        " p.deposit(0o10000 | p.pc, 0o7041); workbench.show(); }"
    )
    assert "7041 CIA" in page.locator("[data-register=next]").inner_text(), "in field 1"
    click(page, "#enter", "#take")
    until(page, "workbench.room.filaments.lit.get('ema')?.[0] === 1")
    assert page.locator("#room .lamps").inner_text().startswith("EMA lit, memory address")
    click(page, "#leave")
    page.locator("#source").fill("FIELD 1\n*300\n\tHLT\n$\n")
    click(page, "#run-it")
    until(page, "document.getElementById('next').textContent.includes('START begins at 10301')")
    page.locator("#save-as").select_option("rim")
    assert "a RIM tape can name only 0000 to 7777" in page.locator("#next").inner_text()
    click(page, "[data-opens=debugger]")
    page.locator("#page").select_option("33")
    page.evaluate(_TAKEN, '{"format": "pdp8 state", "version": 2}')
    until(page, "document.querySelector('#core th').textContent === '7600'")


def test_a_system_that_does_not_boot_is_named_and_not_to_be_booted(page: Page) -> None:
    mount = (
        "(all) => { workbench.drives.mount('own', new Uint8Array(380292).fill(0).map((_, at) => all[at])); }"
    )
    for words, end in (
        ([0xFE, 13, 0xFF, 13], "its system does not boot"),
        ([0xFE, 13], "Press Boot drive 0"),
    ):
        page.evaluate(mount, words)
        assert page.evaluate("workbench.why").endswith(end)
        page.evaluate("workbench.drives.takeOff({ value: '0' })")


_WRITTEN = """async (act) => {
  const { drives } = workbench, saved = [];
  const asks = () => !dispatchEvent(new Event("beforeunload", { cancelable: true }));
  workbench.download = (name, content) => saved.push(name) && (window.last = content);
  ["a", "b"].forEach((name, unit) => {
    drives.mount(name, new Uint8Array(380292).fill(unit, 0, 1));
    workbench.touch(() => drives.control.drives[unit].write(6, 1, 0o1234));
  });
  drives.save({ value: "0" });
  const found = [asks()];
  await (0, eval)(`workbench.${act}`);
  found.push(saved.join(" "), asks());
  if (workbench.room.open) workbench.room.leave();
  found.push(...[0, 1].map((unit) => `${drives.called(unit)}${drives.unsaved(unit) ? "!" : ""}`));
  for (const value of drives.control ? "01" : "") drives.takeOff({ value });
  return found;
}"""
_EXCHANGED = """take((workbench.save(), new File(
  [last.replace(/"drive([01])"/g, (_, unit) => `"drive${1 - unit}"`)], "x.state")))"""


def test_what_was_written_on_a_reel_is_saved_by_whatever_takes_it_away(page: Page) -> None:
    """Once, if no file has it; before the page is left it is asked for, from the room too."""
    page.evaluate("() => { window.held = workbench.drives.bare(workbench.machine); }")
    gone = [True, "a b", False, "a reel", "a reel"]
    for act, found in {
        "take(new File([held], 'a.state'))": gone,
        "drives.control.drives[0].write(6, 2, 1)": [True, "a", True, "a!", "b!"],
        "afternoon.go(0)": gone,
        "enter()": [True, "a", True, "a", "b!"],
        "drives.takeOff({ value: '1' })": [True, "a b", False, "a", "a reel"],
        "drives.mount('c', new Uint8Array(380292))": [True, "a b", False, "a", "c"],
        _EXCHANGED: [True, "a pdp8.state", True, "b!", "a"],
    }.items():
        assert page.evaluate(_WRITTEN, act) == found, act


@pytest.mark.skipif(not SYSTEM.exists(), reason="PDP8_OS8=FOLDER names the folder with ps8.tu56")
def test_ps8_answers(browser: Browser, file: Path) -> None:
    with visit(browser, file.as_uri() + DESK) as page:
        page.set_input_files("#file", SYSTEM)
        until(page, "document.getElementById('reels').textContent.includes('ps8.tu56')")
        click(page, "#boot-reel")
        until(page, "workbench.teletype.paper.lines.at(-1) === '.'")
        page.wait_for_timeout(1000)  # a key that comes while the line feed is printed is lost, as it was
        page.keyboard.type("R PIP", delay=200)
        page.keyboard.press("Enter")
        until(page, "workbench.teletype.paper.lines.at(-1) === '*'")
