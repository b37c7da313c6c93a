"""Where the links of README and its like lead, away from the repository: to a page or picture of the site.

PDP8_SITE is the site's address, https://example.org/pdp8/; without it links stay relative. setup.py sets it
before the links of README, for PyPI; mkdocs.yml has it as site_url.
"""

import os
import re

TOP = {
    "README.md": "index.md",
    "CONTRIBUTING.md": "CONTRIBUTING.md",
    "CHANGELOG.md": "CHANGELOG.md",
    "benchmarks/README.md": "benchmarks.md",
}
"""The pages of the site that do not stand in docs/."""
_LINK = re.compile(r"\]\((?!https?:|#|mailto:)([^)\s]+?)(#[^)\s]*)?\)")


def moved(markdown: str) -> str:
    """Return a page as the site has it: each link to a page or picture beside it."""
    return _LINK.sub(lambda found: f"]({_place(found[1])}{found[2] or ''})", markdown)


def absolute(markdown: str) -> str:
    """Return README with the site's address before each link; as it is, while the site has no address."""
    address = os.environ.get("PDP8_SITE", "").rstrip("/")
    if not address:
        return markdown

    def there(found: re.Match[str]) -> str:
        page = re.sub(r"\.md$", ".html", _place(found[1]))
        return f"]({address}/{page}{found[2] or ''})"

    return _LINK.sub(there, markdown)


def _place(target: str) -> str:
    """Return where on the site a link of the repository leads."""
    name = target.removeprefix("../")
    return TOP.get(name, name.removeprefix("docs/"))
