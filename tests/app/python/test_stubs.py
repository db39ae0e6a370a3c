# SPDX-License-Identifier: GPL-3.0-or-later
"""The stubs say what the compiled module has."""

import ast
import inspect
import pathlib
import re
import subprocess
import sys

import pytest
import spherewalk
from spherewalk import _core

STUB = pathlib.Path(spherewalk.__file__).with_name("_core.pyi")
CLASSES = {node.name: node for node in ast.parse(STUB.read_text()).body if isinstance(node, ast.ClassDef)}


def functions():
    """Each function of the stub, and what the module has in its place."""
    for node in ast.parse(STUB.read_text()).body:
        if isinstance(node, ast.FunctionDef):
            yield node.name, node, getattr(_core, node.name)
    for name, body in CLASSES.items():
        for node in body.body:
            is_property = isinstance(node, ast.FunctionDef) and any(
                isinstance(word, ast.Name) and word.id == "property" for word in node.decorator_list)
            if isinstance(node, ast.FunctionDef) and not is_property and node.name != "__eq__":
                yield f"{name}.{node.name}", node, getattr(getattr(_core, name), node.name)


def stub_arguments(node):
    """Names with defaults, in order; "*" before those that are given by name only."""
    listed = []
    positional = node.args.args
    defaults = [None] * (len(positional) - len(node.args.defaults)) + node.args.defaults
    for argument, default in zip(positional, defaults):
        listed.append((argument.arg, default and ast.unparse(default)))
    if node.args.kwonlyargs:
        listed.append(("*", None))
        for argument, default in zip(node.args.kwonlyargs, node.args.kw_defaults):
            listed.append((argument.arg, default and ast.unparse(default)))
    return [(name, default) for name, default in listed if name not in ("self",)]


def real_arguments(function):
    """The same of the first line of a compiled function's documentation: "f(a: int, *, b: float = 1.0) -> C"."""
    header = next(line for line in function.__doc__.splitlines() if "(" in line)
    header = re.sub(r"^\w+\(", "f(", header).replace("spherewalk._core.", "")
    header = header[: header.rindex(") ->")]
    tree = ast.parse("def " + header.replace("os.PathLike", "PathLike") + "): ...").body[0]
    return stub_arguments(tree)


def same_default(stub, real):
    return stub == real or stub == "..." or ast.literal_eval(stub) == ast.literal_eval(real)


@pytest.mark.parametrize("name, node, function", functions(), ids=lambda value: value if isinstance(value, str) else "")
def test_a_function_takes_what_its_stub_says(name, node, function):
    stub, real = stub_arguments(node), real_arguments(function)
    assert [argument for argument, _ in stub] == [argument for argument, _ in real]
    for (_, wanted), (_, got) in zip(stub, real):
        assert (wanted is None) == (got is None) and (wanted is None or same_default(wanted, got)), name


def test_mypy_finds_the_same_names_in_stub_and_module(tmp_path):
    # Compiled classes have a metaclass of their own, and constructors of which Python knows nothing; their arguments are
    # compared above.
    (tmp_path / "allowed").write_text("spherewalk(\\._core)?\\.[A-Z]\\w+(\\.__init__)?\n")
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "spherewalk", "--allowlist", tmp_path / "allowed"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stdout


def test_mypy_finds_the_types_of_an_installed_module(tmp_path):
    (tmp_path / "use.py").write_text(
        "import spherewalk\n"
        "def f(renderer: spherewalk.Renderer, camera: spherewalk.Camera) -> None:\n"
        "    reveal_type(renderer.render(camera, [0, 0, 1, 0, 0, 0, 1], frame='body').report.offset_m)\n"
        "    renderer.render(camera, [0, 0, 1, 0, 0, 0, 1], frame='head')\n"
        "    spherewalk.ViewOptions(sampling='finest')\n")
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"),
                           str(tmp_path / "use.py")], stdout=subprocess.PIPE, text=True)
    assert 'Revealed type is "builtins.float"' in done.stdout
    assert done.stdout.count("error:") == 2 and "frame" in done.stdout and "sampling" in done.stdout, done.stdout


def test_everything_has_a_docstring():
    for name in spherewalk.__all__:
        thing = getattr(spherewalk, name)
        if not name.startswith("__"):
            assert inspect.getdoc(thing), name
    for name in CLASSES:
        for member, thing in vars(getattr(_core, name)).items():
            if not member.startswith("_") and callable(thing):
                assert len(thing.__doc__.strip().splitlines()) > 1, f"{name}.{member}"
