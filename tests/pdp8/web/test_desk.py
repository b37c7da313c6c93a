"""The desk: programs that are kept, what is typed, files and links, exercises and parts, in Chromium."""

from pdp8 import shelf
from pdp8.lessons import form, student
from tests.pdp8.web.browsing import Browser, Page, click, until, visit

HALT = "*200\n\tHLT\n$\n"


def _reopened(page: Page) -> None:
    page.reload()
    until(page, "!!window.workbench")


def _drop(page: Page, name: str, content: str) -> None:
    page.evaluate("([name, content]) => workbench.take(new File([content], name))", [name, content])


def test_programs_are_kept_and_never_written_over(page: Page) -> None:
    """By name, from visit to visit; a file of a taken name gets another, what is deleted comes back.

    A browser that keeps nothing says so.
    """
    click(page, "#new-program")
    page.locator("#program-name").fill("mine.pal")
    page.locator("#program-name").press("Enter")
    page.locator("#source").fill(HALT)
    _reopened(page)
    assert page.evaluate("[workbench.editor.name, workbench.editor.text]") == ["mine.pal", HALT]
    _drop(page, "mine.pal", "*300\n\tHLT\n$\n")
    until(page, "workbench.editor.name === 'mine 2.pal'")
    page.evaluate("(text) => workbench.editor.put('mine.pal', text)", HALT)
    assert page.evaluate("workbench.editor.name") == "mine.pal"
    click(page, "#delete-program")
    assert "mine.pal" not in page.evaluate("workbench.programs.names()")
    click(page, "[data-click='editor.undo']")
    _reopened(page)
    kept = page.evaluate("['mine.pal', 'mine 2.pal'].map((name) => workbench.programs.get(name))")
    assert kept == [HALT, "*300\n\tHLT\n$\n"]
    page.add_init_script("Storage.prototype.setItem = () => { throw new Error('forbidden'); };")
    _reopened(page)
    assert "keeps no programs for this page (forbidden)" in page.locator("#program-says").inner_text()
    page.locator("#source").fill(HALT)
    assert page.evaluate("workbench.editor.assemble()")


_TYPED = """(area) => {
  area.focus();
  area.setSelectionRange(2000, 2000);
  return Array.from({ length: 40 }, () => {
    const began = performance.now();
    document.execCommand("insertText", false, "A");
    return performance.now() - began;
  });
}"""


def test_a_thousand_lines_are_typed_without_delay(page: Page) -> None:
    """A key takes 16 ms; a quick one's, since others work too. Of what is found the first is shown."""
    page.evaluate("(text) => { workbench.editor.text = text; }", "*200\n" + "\t5 + 3\n" * 1200 + "$\n")
    until(page, "document.getElementById('messages').textContent.includes('and 1,100 more')")
    took = sorted(page.locator("#source").evaluate(_TYPED))
    assert took[len(took) // 4] < 16


def test_counts_and_the_current_line(page: Page) -> None:
    page.locator("#source").fill("*200\n\tISZ N\n\tJMP .-1\n\tHLT\nN,\t-5\n$\n")
    page.locator("#counts").check()
    click(page, "#run-it")
    until(page, "!workbench.machine.processor.run && workbench.machine.processor.pc === 0o203")
    rows = [row.split() for row in page.locator("#gutter .line").all_inner_texts()]
    assert [row[3] for row in rows[1:4]] == ["5", "4", "1"]
    page.evaluate("workbench.machine.pc = 0o201; workbench.touched();")
    assert page.locator("#gutter .now").inner_text().split()[:2] == ["3", "0201"]


def test_a_link_holds_program_and_machine(page: Page, browser: Browser) -> None:
    """Another browser opens it; a bundled tape goes by its name, so it is short; foreign text stays text.

    One that is too long becomes a file.
    """
    page.locator("#source").fill("*200\n\tHLT\n/<img src=x onerror=alert(1)>&\n$\n")
    click(page, "#assemble", "#load")
    page.evaluate("workbench.teletype.mount('circle.asc')")
    click(page, "#share")
    until(page, "location.hash.startsWith('#s=')")
    assert len(page.url) < 1500
    with visit(browser, page.url, "window.workbench?.editor.text.includes('onerror')") as other:
        assert other.evaluate("workbench.machine.processor.core[0o200]") == 0o7402
        assert other.locator("img").count() == 0
        tape = other.evaluate("[...workbench.machine.teletype.reader.tape]")
        assert bytes(tape) == shelf.read_bundled("circle.asc")
    core = "workbench.machine.processor.core"
    page.evaluate(
        f"crypto.getRandomValues({core}).forEach((word, at, core) => {{ core[at] = word & 0o7777; }})"
    )
    with page.expect_download() as download:
        click(page, "#share")
    assert "allowed: here is a file instead" in page.locator("#next").inner_text()
    words = page.evaluate(f"[...{core}]")
    text = download.value.path().read_text()
    _reopened(page)
    _drop(page, "session.json", text)
    until(page, f"{core}[4095] === {words[4095]}")
    assert page.evaluate(f"[...{core}]") == words


def test_an_exercise_of_a_teachers_is_dropped_and_marked(page: Page) -> None:
    """The form for students, without what is hidden, is marked by a Worker; a link leads to a bundled one."""
    exercise = form.read("delay", student.SEED)
    _drop(page, "homework.json", student.form(exercise))
    until(page, "workbench.exercises.name === 'homework.json'")
    click(page, "[data-click='exercises.begin']")
    assert page.evaluate("workbench.editor.name") == "homework.pal"
    page.locator("#source").fill(exercise.solution)
    click(page, "[data-opens=exercises]", "#asked .go")
    until(page, "document.getElementById('marks').textContent.includes('homework.pal: 3 of 3 points')")
    assert exercise.points == 6
    page.goto(page.url.split("#")[0] + "#exercise=read-a-frame")
    _reopened(page)
    assert page.locator("#asked code").inner_text() == "o   o o o .       "


def test_from_a_radius_to_a_wall(page: Page) -> None:
    """A small circle is punched, translated and cut by three buttons; typed anew, it is refused."""
    says = "document.getElementById('part-punched').textContent.includes"
    click(page, "[data-opens=parts]")
    page.locator("[name=radius]").fill("0.25")
    click(page, "#part .go")
    until(page, f"{says}('blocks: circle 2.asc')")
    click(page, "#part-translate")
    until(page, "!document.getElementById('part-cut').disabled")
    click(page, "#part-cut")
    assert "minutes at the Hydra-Point" in page.evaluate("document.getElementById('part-is-cut').textContent")
    assert page.evaluate("workbench.mill.name") == "circle 2.eia"
    page.locator("[name=radius]").evaluate("(input) => { input.value = '1750'; }")
    page.evaluate("workbench.tabs.open('parts')")
    click(page, "#part .go")
    until(page, f"{says}('for 1750 thousandths write 1.75')")
