"""What mkdocs.yml adds to docs/: README, CONTRIBUTING and CHANGELOG, a page for each module,
the workbench itself, and the page that teaches the method.

README and its like stand at the top of the repository, where a forge shows them; their links are rewritten
for the site, the first page of which is the README.
"""

import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from pdp8.web import curve, workbench

HOUSE = Path(__file__).parent.parent
TOP = {"README.md": "index.md", "CONTRIBUTING.md": "CONTRIBUTING.md", "CHANGELOG.md": "CHANGELOG.md"}
PACKAGES = ("pdp8", "pal", "tapes", "programs", "nc")
LINK = re.compile(r"\]\((?!https?:|#|mailto:)([^)\s]+?)(#[^)\s]*)?\)")


def modules() -> list[str]:
    """Return the names of all modules that have something to call, sorted."""
    folders = {found.parent for package in PACKAGES for found in (HOUSE / package).rglob("__init__.py")}
    paths = (path for folder in folders for path in folder.glob("*.py"))
    names = (".".join(path.relative_to(HOUSE).with_suffix("").parts) for path in paths)
    return sorted({name.removesuffix(".__init__") for name in names if not name.endswith("__main__")})


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages that are not in docs/."""
    for name, place in TOP.items():
        files.append(File.generated(config, place, content=(HOUSE / name).read_text(encoding="utf-8")))
    for module in modules():
        files.append(File.generated(config, f"api/{module}.md", content=f"# `{module}`\n\n::: {module}\n"))
    files.append(File.generated(config, "workbench-live.html", content=workbench.page()))
    files.append(File.generated(config, "curve-live.html", content=curve.page()))
    return files


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """List the modules under "Modules", a section a package."""
    names = modules()
    sections = [
        {package: [{name: f"api/{name}.md"} for name in names if name.split(".")[0] == package]}
        for package in PACKAGES
    ]
    config.nav = [*config.nav, {"Modules": sections}]
    return config


def on_page_markdown(markdown: str, page: object, config: MkDocsConfig, files: Files) -> str:
    """Rewrite links between the top of the repository and docs/."""
    return LINK.sub(lambda found: f"]({_moved(found[1])}{found[2] or ''})", markdown)


def _moved(target: str) -> str:
    """Return where a link of the repository leads on the site."""
    name = target.removeprefix("../")
    return TOP.get(name, name.removeprefix("docs/"))
