# SPDX-License-Identifier: BSD-3-Clause
"""Whether the documents are whole: check_documents.py FOLDER_OF_THE_PROJECT FILE.xml...

README is short, and so is Documentation; no row of its tables of properties stands twice. The version of CMake that
the guide asks for is the required one, and new enough for what is used. What links and pictures of .md files name
exists, and so do files that pages for developers name. Pages of the guide begin with a picture and a task. Pictures
are small, and those of the guide are in its gallery. Each filter and source of the files, which are those of Plugin
after CMake pasted what they share, has a page in the guide that names each of its properties; the page, the one of
common properties, or one to whose properties it links, has a row for it. The guide calls properties, and values of
lists, as panels do."""

import pathlib
import re
import sys

sys.dont_write_bytecode = True
project = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(project / "Plugin"))
import options  # noqa: E402

LARGEST_README = 119
# Of all .md files in Documentation, counted as `wc -w` does.
MOST_WORDS = 60_000
# Commands of CMake that came late, with the version.
NEWER_CMAKE = {"file(CONFIGURE": (3, 18)}
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)")
guide = project / "Documentation" / "Guide"
# Of pictures: README's, and each of the guide.
LARGEST_GALLERY, LARGEST_PICTURE = 700_000, 60_000


def read(path):
    return path.read_text(encoding="utf-8")


def documents():
    """All .md files that belong to the project: not those of builds, and of folders that begin with a dot."""
    for path in sorted(project.rglob("*.md")):
        first = path.relative_to(project).parts[0]
        if first != "build" and not first.startswith("."):
            yield path


def sections(path):
    """What a link behind # can name: titles in small letters with dashes."""
    titles = re.findall(r"^#+ +(.*)$", re.sub(r"^```.*?^```", "", read(path), flags=re.DOTALL | re.MULTILINE),
                        re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def broken_links(path):
    text = re.sub(r"```.*?```|`[^`\n]*`", "", read(path), flags=re.DOTALL)
    for link in LINK.findall(text):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, section = link.partition("#")
        target = path.parent / name if name else path
        if not target.exists():
            yield f"{path.relative_to(project)} links to {link}, which is not there"
        elif section and target.suffix == ".md" and section not in sections(target):
            yield f"{path.relative_to(project)} links to {link}, but there is no such section"


def missing_in_guide(one):
    page = guide / f"{one.name}.md"
    if not page.exists():
        yield f"{one.name} has no page: write {page.relative_to(project)}"
        return
    text = read(page)
    # Pages that have rows for it.
    others = [name for name in re.findall(r"\((\w+\.md)#properties\)", text) if (guide / name).exists()]
    tables = text + "".join(read(guide / name) for name in ["CommonProperties.md", *others])
    for option in one.options:
        if f"`{option.name}`" not in text or f"| `{option.name}`" not in tables:
            yield (f"{page.relative_to(project)} does not name `{option.name}`, or no table has it: "
                   "cmake --build build/vtk --target guide_tables adds it")
    if f"({page.name})" not in read(guide / "README.md"):
        yield f"the index of the guide does not link to {page.name}"


def repeated_rows():
    """Rows of properties that stand twice in the guide, word for word."""
    seen = {}
    for path in sorted(guide.glob("*.md")):
        for row in re.findall(r"^\| `.*$", read(path), re.MULTILINE):
            if seen.setdefault(row, path) != path:
                yield f"{path.relative_to(project)} and {seen[row].name} both have the row {row[:60]}..."


def too_many_words():
    count = sum(len(read(path).split()) for path in (project / "Documentation").rglob("*.md"))
    if count > MOST_WORDS:
        yield f"Documentation has {count} words, of {MOST_WORDS} at most: take out what repeats"


def pages_without_a_task():
    """Pages of the guide that do not begin with a picture, and then with what a reader has and wants; README has a table."""
    for path in sorted(guide.glob("*.md")):
        begin = r"# .*\n\n!\[.*\n\n" if path.name == "README.md" else r"# .*\n\n!\[.*\n\n(\*[^*]+\*\n\n)?You "
        if not re.match(begin, read(path)):
            yield f"{path.relative_to(project)} does not begin with a picture and a task (You have ..., and you want ...)"


def wrong_labels(filters):
    """Properties and values of lists that the guide does not call as panels do, code apart."""
    options_of = {}
    for one in filters:
        for option in one.options:
            options_of.setdefault(option.name, []).append(option)
    entries = [(text, option) for found in options_of.values() for option in found for text, _ in option.entries]
    shown = {text for text, _ in entries}
    # Other spellings of values that no text has by chance.
    spellings = {text for _, option in entries for text, _ in option.spellings if re.search(r"[a-z][A-Z]|\W", text)} - shown
    for path in sorted(guide.glob("*.md")):
        name = path.relative_to(project)
        text = re.sub(r"^```.*?^```|^    .*?$|\]\([^)]*\)", "", read(path), flags=re.DOTALL | re.MULTILINE)
        text = " ".join(text.split())
        for label, key in re.findall(r"\*([^*]+)\* \(`(\w+)`\)", text):
            if key in options_of and label not in {option.shown for option in options_of[key]}:
                yield f"{name} calls {key} *{label}*, panels {options_of[key][0].shown}"
        for key, value in re.findall(r"`(\w+)`(?:\s=)?\s([A-Z][\w/ -]+)", text):
            labels = [entry for option in options_of.get(key, []) for entry, _ in option.entries]
            if labels and not any(re.match(re.escape(entry) + r"\b", value) for entry in labels):
                yield f"{name} has {key} {value.split()[0]}, but panels have {', '.join(dict.fromkeys(labels))}"
        for word in sorted(spellings):
            if re.search(rf"(?<!\w){re.escape(word)}(?!\w)", re.sub(r"`[^`]*`", "", text)):
                yield f"{name} says {word}, which panels do not"


def wrong_pictures():
    limits = {project / "Documentation" / "gallery.png": LARGEST_GALLERY}
    limits.update((path, LARGEST_PICTURE) for path in sorted((guide / "pictures").iterdir()))
    shown = read(guide / "Gallery.md")
    for path, most in limits.items():
        size = path.stat().st_size
        if size > most:
            yield f"{path.relative_to(project)} has {size} bytes, of {most} at most: write_small_png makes it small"
        if f"{path.name})" not in shown:
            yield f"{path.relative_to(project)} is not in Documentation/Guide/Gallery.md"


def missing_files():
    """Files that pages for developers name without their folders."""
    folders = ("Data", "Documentation", "Examples", "Filters", "Plugin", "Program", "Python", "Testing")
    there = {path.name for folder in folders for path in (project / folder).rglob("*.*")}
    for name in ("Glossary", "Architecture", "Contributing"):
        page = project / "Documentation" / f"{name}.md"
        for file in sorted(set(re.findall(r"`(\w+\.(?:h|cxx|py))`", read(page))) - there):
            yield f"{page.relative_to(project)} names {file}, which is not there"


def wrong_cmake_versions():
    asked = re.search(r"Needed are CMake ([\d.]+)", read(guide / "Building.md"))[1]
    for path in sorted(project.rglob("CMakeLists.txt")):
        if path.relative_to(project).parts[0] == "build":
            continue
        text = read(path)
        required = re.search(r"cmake_minimum_required\(VERSION ([\d]+\.[\d]+)", text)
        if required and required[1] != asked:
            yield f"{path.relative_to(project)} requires CMake {required[1]}, but the guide says {asked}"
        for command, version in NEWER_CMAKE.items():
            if command in text and tuple(map(int, asked.split("."))) < version:
                yield f"{path.relative_to(project)} uses {command}...), which CMake {asked} does not have"


def main():
    faults = []
    lines = len(read(project / "README.md").splitlines())
    if lines > LARGEST_README:
        faults.append(f"README.md has {lines} lines, of {LARGEST_README} at most: put details into Documentation/Guide")
    for path in documents():
        faults += broken_links(path)
    faults += too_many_words()
    faults += repeated_rows()
    faults += pages_without_a_task()
    faults += wrong_pictures()
    faults += missing_files()
    faults += wrong_cmake_versions()
    filters = options.read(sys.argv[2:])
    if len(filters) < 11:
        faults.append(f"only {len(filters)} filters and sources were found in {sys.argv[2:]}")
    for one in filters:
        faults += missing_in_guide(one)
    faults += wrong_labels(filters)
    sys.exit("\n".join(faults) or 0)


main()
