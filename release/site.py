"""What mkdocs.yml adds to docs/: README and its like, a page for each module and one of all commands,
the workbench itself, and the page that teaches the method.

README and its like stand at the top of the repository, where a forge shows them; their links are rewritten
for the site, the first page of which is the README.
"""

import ast
import html
import sys
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from pdp8.web import curve, workbench

HOUSE = Path(__file__).parent.parent
sys.path.insert(0, str(HOUSE))

from release.links import TOP, moved  # noqa: E402
from release.reference import reference  # noqa: E402

PACKAGES = ("pdp8", "pal", "tapes", "programs", "nc")


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
    files.append(File.generated(config, "api/index.md", content=index()))
    files.append(File.generated(config, "reference.md", content=reference()))
    files.append(File.generated(config, "workbench-live.html", content=workbench.page()))
    files.append(File.generated(config, "curve-live.html", content=curve.page("workbench-live.html")))
    return files


def index() -> str:
    """Return the page that lists the modules, a package after the other, each with what it is."""
    lines = ["# Modules", ""]
    for name in modules():
        path = HOUSE.joinpath(*name.split("."))
        package = path / "__init__.py"
        source = package if package.exists() else path.with_suffix(".py")
        said = (ast.get_docstring(ast.parse(source.read_text(encoding="utf-8"))) or "").partition("\n")[0]
        lines += [f"## {name}\n"] if name in PACKAGES else []
        lines.append(f"- [`{name}`]({name}.md) {html.escape(said)}")
    return "\n".join(lines)


def on_page_markdown(markdown: str, page: object, config: MkDocsConfig, files: Files) -> str:
    """Rewrite links between the top of the repository and docs/."""
    return moved(markdown)


def on_post_build(config: MkDocsConfig) -> None:
    """Take out the theme's source maps, a twelfth of the site: they are for who works on the theme."""
    for source_map in Path(config.site_dir).rglob("*.map"):
        source_map.unlink()
