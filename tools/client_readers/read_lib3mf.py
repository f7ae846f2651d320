"""Reads files by lib3mf 1.8 (tools/clients.py)."""
import ctypes
import ctypes.util
import os

from measure import answer, measure

LIBRARY = ctypes.CDLL(ctypes.util.find_library("3MF"))


def call(name, *arguments):
    code = getattr(LIBRARY, "lib3mf_" + name)(*arguments)
    assert code == 0, f"lib3mf_{name} returns {code:#x}"


def handle(name, *arguments):
    made = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(made))
    return made


def number(name, *arguments):
    value = ctypes.c_uint32()
    call(name, *arguments, ctypes.byref(value))
    return value.value


def triples(name, item, mesh, count):
    values = (item * (3 * count))()
    call(name, mesh, values, count, ctypes.byref(ctypes.c_uint32()))
    return [list(values[3 * i:3 * i + 3]) for i in range(count)]


def read(path, _, repeated):
    model = handle("createmodel")
    reader = handle("model_queryreader", model, b"3mf")
    call("reader_setstrictmodeactive", reader, ctypes.c_bool(True))
    call("reader_readfromfileutf8", reader, path.encode())
    warnings = number("reader_getwarningcount", reader)
    said = [f"{warnings} warnings"] if warnings else []
    points, triangles = [], []
    meshes = handle("model_getmeshobjects", model)
    while number("resourceiterator_movenext", meshes):
        mesh = handle("resourceiterator_getcurrent", meshes)
        if not number("meshobject_ismanifoldandoriented", mesh):
            said.append("not manifold and oriented")
        corners = triples("meshobject_gettriangleindices", ctypes.c_uint32, mesh,
                          number("meshobject_gettrianglecount", mesh))
        triangles += [[len(points) + corner for corner in triangle] for triangle in corners]
        points += triples("meshobject_getvertices", ctypes.c_float, mesh, number("meshobject_getvertexcount", mesh))
    return {**measure(points, triangles, repeated), "complaint": ", ".join(said)}


answer(read)
os._exit(0)  # or the library and Python end each other
