# SPDX-License-Identifier: BSD-3-Clause
"""Makes one site of the documents and the public classes by Doxygen, and checks it: make_site.py PROJECT FOLDER

FOLDER/html/index.html is the guide; its sections are the menu. The .md files are copied to FOLDER/pages on the way, where
each title gets a label and links lead to labels, because versions of Doxygen differ in what they make of links between
files. Files that documents link to and that are no documents are copied to FOLDER/html/files. Fails where Doxygen warns,
and where a link or a picture of the site leads nowhere."""

import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse
from xml.sax.saxutils import quoteattr

LINK = re.compile(r"(!?)\[([^\]]*)\]\(\s*<?([^)\s>]+)>?\s*\)")
HEADING = re.compile(r"^(#+) +(.*?)\s*$")
CODE = re.compile(r"^(```.*?^```[^\n]*$|(?:^    [^\n]*$\n?)+)", re.DOTALL | re.MULTILINE)
SPAN = re.compile(r"(`[^`\n]+`)")
LANGUAGES = {"python": "py", "cpp": "cpp"}  # what Doxygen colours
# Pictures and tables are no wider than the page.
STYLE = ".contents img { max-width: 100%; height: auto; } .contents table { max-width: 100%; } .contents td { overflow-wrap: anywhere; }\n"
ITEM = re.compile(r"^- \[([^\]]*)\]\(([^)]*)\)", re.MULTILINE)


def word(text):
    """What a link behind # calls a section."""
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


class Site:
    def __init__(self, project, folder):
        self.project, self.folder = project, folder
        self.pages, self.html = folder / "pages", folder / "html"
        documents = [project / "README.md", project / "CHANGELOG.md", *project.glob("Documentation/*.md"),
                     *project.glob("Documentation/Guide/*.md"), *project.glob("Documentation/Analysis/*.md"),
                     project / "Data/README.md", project / "Examples/README.md", project / "Filters/Core/README.md", project / "Testing/README.md",
                     project / "Testing/Benchmarks/README.md"]
        self.documents = [path.resolve() for path in documents if path.exists()]
        self.guide = project / "Documentation/Guide/README.md"
        self.files, self.parents, self.labels = set(), set(), set()

    def label(self, path):
        name = path.relative_to(self.project).with_suffix("")
        return "mainpage" if path == self.guide else "page_" + re.sub(r"\W", "_", str(name))

    def section(self, path, name):
        return f"{self.label(path)}_{re.sub(r'[^a-z0-9]', '_', name)}"

    def new(self, label):
        """A label that no section has yet: releases have the same sections."""
        while label in self.labels:
            label += "_again"
        self.labels.add(label)
        return label

    def shown(self, path):
        """The title of a document."""
        return path.read_text(encoding="utf-8").split("\n", 1)[0].lstrip("# ")

    def title(self, path):
        """The same as links call it."""
        return word(self.shown(path))

    # ------------------------------------------------------------ from documents to pages

    def document_of(self, target):
        """The document that a path is about: itself, or the README of a folder or the one above it."""
        while target.is_dir() and target != self.project:
            if (target / "README.md") in self.documents:
                return target / "README.md"
            target = target.parent
        return target if target in self.documents else None

    def link(self, path, match):
        picture, text, address = match.groups()
        if re.match(r"[a-z]+:", address):
            return match[0]
        name, _, section = address.partition("#")
        target = (path.parent / urllib.parse.unquote(name)).resolve() if name else path
        if picture:
            return f"![{text}]({target.name})"
        document = self.document_of(target)
        if document:
            if section and section != self.title(document):
                return f"[{text}](@ref {self.section(document, section)})"
            # The pages that lists of the guide's index name hang below it.
            below = path == self.guide and match.string[:match.start()].endswith("\n- ")
            if below and document not in self.parents and document != path:
                self.parents.add(document)
                return f'@subpage {self.label(document)} "{text}"'
            return f"[{text}](@ref {self.label(document)})".replace("@ref mainpage", "@ref index")
        self.files.add(target)
        return f'<a href="files/{target.relative_to(self.project)}">{text}</a>'

    def prose(self, path, text):
        """A piece without code blocks."""
        lines = []
        for line in text.split("\n"):
            heading = HEADING.match(line)
            if heading:
                label = self.label(path) if len(heading[1]) == 1 else self.new(self.section(path, word(heading[2])))
                line = f"{heading[1]} {heading[2]} {{#{label}}}"
            lines.append(line)
        text = re.sub(r"<!--.*?-->", "", "\n".join(lines), flags=re.DOTALL)
        # Links may stand around code; Doxygen's words are not to be found in code.
        text = LINK.sub(lambda match: self.link(path, match), text)
        return "".join(piece if piece.startswith("`") else re.sub(r"(?<!\w)@(?!ref|subpage)", "\\\\@", piece)
                       for piece in SPAN.split(text))

    def block(self, text):
        """A code block, with the name by which Doxygen knows its language."""
        start = re.match(r"```(\w*)", text)
        if not start:
            return text
        language = LANGUAGES.get(start[1])
        return f"```{{.{language}}}" + text[start.end():] if language else "```{.unparsed}" + text[start.end():]

    def write_pages(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.pages.mkdir(parents=True)
        for path in sorted(self.documents, key=lambda one: one != self.guide):
            pieces = CODE.split(path.read_text(encoding="utf-8"))
            text = "".join(self.block(piece) if i % 2 else self.prose(path, piece) for i, piece in enumerate(pieces))
            name = str(path.relative_to(self.project)).replace("/", "_")
            (self.pages / name).write_text(text, encoding="utf-8")

    # ------------------------------------------------------------ Doxygen

    def menu(self):
        """The tabs of the site: the guide, its sections that list pages, README and the like, and the classes."""
        tabs = ['<tab type="mainpage" visible="yes" title="Guide"/>']
        for section in re.split(r"^## ", self.guide.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
            pages = [(text, self.document_of((self.guide.parent / name).resolve())) for text, name in ITEM.findall(section)]
            tabs.append(self.tab(section.split("\n", 1)[0], pages))
        project = [self.project / name for name in ("README.md", "CHANGELOG.md")]
        others = sorted({*self.documents} - {self.guide, *self.parents, *project})
        analysis = [path for path in others if path.parent.name == "Analysis"]
        developers = [path for path in others if path not in analysis]
        for title, paths in (("Smoothness", analysis), ("Project", project + developers)):
            tabs.append(self.tab(title, [(self.shown(path), path) for path in paths]))
        return "\n".join(["<navindex>", *filter(None, tabs), '<tab type="classes" visible="yes" title="Classes">',
                          '<tab type="classlist" visible="yes" title="" intro=""/>',
                          '<tab type="hierarchy" visible="yes" title="" intro=""/>', "</tab>", "</navindex>"])

    def tab(self, title, pages):
        inside = [f'<tab type="user" visible="yes" url="@ref {self.label(path)}" title={quoteattr(text)}/>' for text, path in pages]
        return "\n".join([f'<tab type="usergroup" visible="yes" title={quoteattr(title)}>', *inside, "</tab>"]) if pages else ""

    def write_layout(self):
        """Doxygen's own layout of this version, with the menu in the place of its own."""
        layout = self.folder / "layout.xml"
        subprocess.run(["doxygen", "-l", str(layout)], check=True, stdout=subprocess.DEVNULL)
        text = layout.read_text(encoding="utf-8")
        layout.write_text(text[:text.index("<navindex>")] + self.menu() + text[text.index("</navindex>") + len("</navindex>"):],
                          encoding="utf-8")
        style = self.folder / "site.css"
        style.write_text(STYLE, encoding="utf-8")
        return [f'LAYOUT_FILE = "{layout}"', f'HTML_EXTRA_STYLESHEET = "{style}"']

    def run_doxygen(self):
        settings = (self.project / "Documentation/Doxyfile").read_text(encoding="utf-8")
        images = {str(path.parent) for path in self.project.glob("Documentation/**/*.png")}
        log = self.folder / "warnings.txt"
        settings += "\n".join(["", f'INPUT = "{self.pages}" "{self.project}/Filters"', f'OUTPUT_DIRECTORY = "{self.folder}"',
                               "IMAGE_PATH = " + " ".join(f'"{path}"' for path in sorted(images)),
                               f'WARN_LOGFILE = "{log}"', f'STRIP_FROM_PATH = "{self.project}"', *self.write_layout(), ""])
        made = subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=self.project)
        if made.returncode:
            sys.exit(f"doxygen ended with {made.returncode}")
        for path in self.files:
            copy = self.html / "files" / path.relative_to(self.project)
            copy.parent.mkdir(parents=True, exist_ok=True)
            if path.is_dir():
                sys.exit(f"a document links to the folder {path}, which has no README.md")
            shutil.copyfile(path, copy)
        return [line for line in log.read_text(encoding="utf-8").splitlines() if line]


# ---------------------------------------------------------------- the check

class Names(html.parser.HTMLParser):
    """What a page links to, and what can be linked to in it."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.links += [values[name] for name in ("href", "src") if values.get(name)]
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}


def broken(folder):
    """What links and pictures of a folder of HTML files lead nowhere."""
    pages = {path: Names(path) for path in sorted(folder.rglob("*.html"))}
    for path, names in pages.items():
        for link in sorted(set(names.links)):
            parts = urllib.parse.urlsplit(link)
            # Doxygen 1.17 links letters of lists of members that are too short to have them.
            if parts.scheme or parts.netloc or (path.name.startswith("functions") and link.startswith("#index_")):
                continue
            target = pathlib.Path(os.path.normpath(path.parent / urllib.parse.unquote(parts.path))) if parts.path else path
            if not target.exists():
                yield f"{path.name} links to {link}, which is not there"
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
                yield f"{path.name} links to {link}, but there is no such place"


def main():
    site = Site(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
    site.write_pages()
    faults = site.run_doxygen() + list(broken(site.html))
    if faults:
        sys.exit("\n".join(faults + [f"{len(faults)} faults in the site"]))
    print(f"{len(list(site.html.glob('*.html')))} pages, no warning, no broken link: {site.html / 'index.html'}")


if __name__ == "__main__":
    main()
