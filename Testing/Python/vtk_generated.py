# SPDX-License-Identifier: BSD-3-Clause
"""What is generated from the files of Plugin is correct whatever their texts are."""

import ast
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

SOURCE = pathlib.Path(__file__).resolve().parents[2]
NASTY = 'a "quoted" \\ \\n text, \'\'\' """ {braces} %d ?? <&> \u00e9 end"'
LINES = "one\ntwo\ttab"
XML = f"""<ServerManagerConfiguration><ProxyGroup name="filters">
<SourceProxy class="vtkMadeFilter" label={quoteattr(NASTY)} name="MadeFilter">
  <Documentation short_help={quoteattr(NASTY)}>"{'long words ' * 30}

  back\\slash "{'"' * 3}</Documentation>
  <InputProperty command="SetInputConnection" name="Input"><DataTypeDomain><DataType value="vtkDataSet"/></DataTypeDomain>
  </InputProperty>
  <IntVectorProperty command="SetKind" name="Kind" label={quoteattr(LINES)} default_values="1" number_of_elements="1">
    <EnumerationDomain name="enum"><Entry text={quoteattr(NASTY)} value="1"/><Entry text={quoteattr(LINES)} value="0"/>
    </EnumerationDomain><Documentation>"{'w' * 300} \\" end\\</Documentation>
  </IntVectorProperty>
  <IntVectorProperty command="SetRefineByIt" name="RefineByIt" default_values="1" number_of_elements="1">
    <BooleanDomain name="bool"/></IntVectorProperty>
  <DoubleVectorProperty command="SetHow" name="How" default_values="0.5" number_of_elements="1">
    <Documentation>{"half a line " * 20}</Documentation></DoubleVectorProperty>
  <IntVectorProperty command="SetRare" name="Rare" default_values="7" number_of_elements="1"
    panel_visibility="advanced"/>
</SourceProxy></ProxyGroup></ServerManagerConfiguration>
"""


def generate(script, *more):
    with tempfile.TemporaryDirectory() as folder:
        xml = pathlib.Path(folder, "Made.xml")
        made = pathlib.Path(folder, "made")
        xml.write_text(XML.replace("one\ntwo\ttab", "one&#10;two&#9;tab"), encoding="utf-8")
        subprocess.run([sys.executable, SOURCE / script, SOURCE / "Plugin", *more, made, xml], check=True, timeout=60)
        texts = [path.read_text(encoding="utf-8") for path in sorted(pathlib.Path(folder).glob("made*"))]
        return texts if len(texts) > 1 else texts[0]


def read_literals(text):
    """The texts of literals of C++, those that stand side by side as one, and the code between them."""
    literal = r'"(?:[^"\\\n]|\\[nrt"\\])*"'
    texts = []
    for group in re.findall(f"(?:{literal} ?)+", text):
        texts.append("".join(json.loads(one) for one in re.findall(literal, group)))
    return texts, re.sub(literal, "", text)


class Generated(unittest.TestCase):
    def test_program(self):
        texts, code = read_literals(generate("Program/write_options.py"))
        self.assertNotIn('"', code)
        self.assertNotIn("\\", code)
        nasty = " ".join(NASTY.split())
        for text in (nasty, LINES, "Kind", "kind", "made-filter", f'"{"w" * 300} \\" end\\', "RefineByIt", "How", "0.5",
                     f'"{"long words " * 30}'.strip() + '\n\nback\\slash "' + '"' * 3, ("half a line " * 20).strip()):
            self.assertIn(text, texts)
        self.assertEqual(texts.count(nasty), 4)  # label, short help, entry, default

    def test_labels(self):
        """The words of messages, as panels have them: a label, or the words of a name."""
        texts, code = read_literals(generate("Plugin/write_labels.py"))
        self.assertNotIn("\\", code)
        words = dict(zip(texts[3::2], texts[4::2]))
        self.assertEqual(words["RefineByIt"], '"Refine By It"')
        self.assertEqual(words["Kind ="], f'"{LINES}" =')
        self.assertEqual(words["vtkMadeFilter"], f'"{" ".join(NASTY.split())}"')
        self.assertEqual(words["vtkDataSetSurfaceFilter"], '"Extract Surface"')
        self.assertEqual(words["vtkQuadraticTetra"], "quadratic tetra")
        self.assertNotIn("Kind", words)  # may be a word like any other

    def test_python(self):
        text, types = generate("Python/write_functions.py", '1.0 "made"')
        tree, stub = ast.parse(text), ast.parse(types)
        function = next(node for node in tree.body if isinstance(node, ast.FunctionDef))
        help_ = " ".join(ast.get_docstring(function).split())
        for part in (" ".join(NASTY.split()), f'"{"w" * 300} \\" end\\', "refine: where", "made = made_filter("):
            self.assertIn(part, help_)
        constants = [str(node.value) for node in ast.walk(tree) if isinstance(node, ast.Constant)]
        strings = [line for text in constants for line in text.splitlines()]
        for part in ('back\\slash "' + '"' * 3, f'"{"w" * 300} \\" end\\', ("half a line " * 20).strip(),
                     "SetRefineByIt"):
            self.assertIn(part, strings)
        arguments = {one.arg: default for one, default in zip(function.args.kwonlyargs, function.args.kw_defaults)}
        self.assertEqual(ast.literal_eval(arguments["onetwotab"]), NASTY)
        self.assertNotIn("rare", arguments)  # as the panel does not show it at once
        self.assertIn("rare", strings)
        more = next(node for node in stub.body if isinstance(node, ast.ClassDef))
        self.assertEqual([line.target.id for line in more.body], ["kind", "refine_by_it", "rare"])
        annotation = next(one.annotation for node in ast.walk(stub) if isinstance(node, ast.FunctionDef)
                          for one in node.args.kwonlyargs if one.arg == "onetwotab")
        self.assertEqual(ast.literal_eval(annotation.slice), (NASTY, LINES))
        version = next(node for node in tree.body if isinstance(node, ast.Assign) and
                       node.targets[0].id == "__version__")
        self.assertEqual(ast.literal_eval(version.value), '1.0 "made"')


if __name__ == "__main__":
    unittest.main()
