"""The card of a drill, beside the panel: what is done, what is next, and what the coach says."""

from textwrap import wrap

from rich.text import Text

from pdp8.console.pages import Page, subtitle, title
from pdp8.console.session import Session
from pdp8.lessons.drill import Coach
from tapes.measure import duration

_ROWS = 12
"""Steps that are shown at once."""


class DrillCard(Page):
    """A drill's card."""

    def __init__(self, session: Session, name: str, coach: Coach) -> None:
        super().__init__(session, name)
        self.coach = coach

    def look(self) -> object:
        """Set the title; the card depends on the step, on what was said, and on the whole seconds."""
        coach = self.coach
        title(self, f"drill: {coach.drill.title}")
        subtitle(self, f"{duration(int(coach.seconds))} · {coach.wrong} wrong · X begins again")
        return coach.at, coach.said, coach.wrong

    def render(self) -> Text:
        """Draw the steps around the next one, and what the coach says."""
        coach, steps = self.coach, self.coach.drill.steps
        first = max(0, min(coach.at - _ROWS // 3, len(steps) - _ROWS))
        said = wrap(coach.said, max(20, self.size.width))
        lines = [*(Text(line, style="bold") for line in said), Text("")]
        for number, step in enumerate(steps[first : first + _ROWS], first):
            mark = "✓" if number < coach.at else "▸" if number == coach.at else " "
            style = "bold" if number == coach.at else "dim" if number < coach.at else ""
            lines.append(Text(f"{mark} {step.say}", style=style))
        return Text("\n").join(lines)
