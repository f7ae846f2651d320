"""The stubs of the extension say what is in it: no name more or less, and the same arguments."""
import ast
import inspect
import re

import pytest

from conftest import ROOT
from dupin import _core

STUBS = ast.parse((ROOT / "python/dupin/_core.pyi").read_text())


def names_of(body):
    """What a module's or a class's body of the stubs declares: the node by name."""
    found = {}
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            found[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            found[node.target.id] = node
    return found


def declared(node):
    """The arguments' names of a function of the stubs, and of those with a default value."""
    arguments = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
    optional = [*node.args.args][len(node.args.args) - len(node.args.defaults):]
    optional += [a for a, default in zip(node.args.kwonlyargs, node.args.kw_defaults) if default]
    return [a.arg for a in arguments if a.arg != "self"], {a.arg for a in optional}


def bound(function):
    """The same of what pybind11 binds, which says it in the first line of the docstring."""
    line = (function.__doc__ or "").split("\n")[0]
    match = re.fullmatch(r"\w+\((.*)\) -> .*", line)
    if not match or "Overloaded" in (function.__doc__ or ""):
        return None
    depth, parts = 0, [""]
    for c in match.group(1):
        depth += (c in "[(") - (c in "])")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    parts = [p.strip() for p in parts if p.strip() not in ("", "*")]
    names = [p.split(":")[0] for p in parts]
    return [n for n in names if n != "self"], {n for n, p in zip(names, parts) if " = " in p}


def public(names):
    """Without what every class or module has, and pybind11's own."""
    base = set(dir(object)) | {"__module__", "__dict__", "__weakref__", "__annotations__", "__slotnames__"}
    return {n for n in names if n not in base and not n.startswith(("_pybind11", "__pybind11"))}


def classes():
    return [n for n, node in names_of(STUBS.body).items() if isinstance(node, ast.ClassDef)]


def test_the_module_has_the_names_of_the_stubs():
    there = public(vars(_core)) - {"__doc__", "__file__", "__name__", "__loader__", "__spec__", "__package__"}
    assert there | {"__version__"} == set(names_of(STUBS.body))


@pytest.mark.parametrize("name", classes())
def test_classes_have_the_members_of_the_stubs(name):
    assert public(vars(getattr(_core, name))) == public(names_of(names_of(STUBS.body)[name].body))


def functions():
    for name, node in names_of(STUBS.body).items():
        if isinstance(node, ast.FunctionDef):
            yield name, node, getattr(_core, name)
        elif isinstance(node, ast.ClassDef):
            for member, inner in names_of(node.body).items():
                if isinstance(inner, ast.FunctionDef):
                    yield f"{name}.{member}", inner, inspect.getattr_static(getattr(_core, name), member)


def test_functions_take_the_arguments_of_the_stubs():
    looked_at = 0
    for name, node, there in functions():
        is_property = any(getattr(d, "id", "") == "property" for d in node.decorator_list)
        assert isinstance(there, property) == is_property, name
        if is_property or re.search(r"\.__(?!init__)\w+__$", name):
            continue  # operators take what Python gives them
        signature = bound(there.__func__ if isinstance(there, staticmethod) else there)
        if signature is not None:
            names, optional = declared(node)
            nameless = [i for i, n in enumerate(signature[0]) if n == f"arg{i}"]  # which are given by their place
            assert ([f"arg{i}" if i in nameless else n for i, n in enumerate(names)], optional) == signature, name
            looked_at += 1
    assert looked_at >= 30
