"""Reads files by Blender's importers (tools/clients.py): blender -b --python FILE -- FILES"""
import pathlib
import sys

import bpy
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from measure import answer, measure

numpy.bool = bool  # what Debian's NumPy no longer has, and the glTF importer of its Blender 3.4 uses
IMPORTERS = {"stl": bpy.ops.import_mesh.stl, "stl-ascii": bpy.ops.import_mesh.stl, "obj": bpy.ops.wm.obj_import,
             "ply": bpy.ops.import_mesh.ply, "ply-ascii": bpy.ops.import_mesh.ply, "glb": bpy.ops.import_scene.gltf}


def read(path, form, repeated):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    result = IMPORTERS[form](filepath=path)
    bpy.context.view_layer.update()  # of the places of things
    points, triangles = [], []
    for thing in bpy.data.objects:
        if thing.type == "MESH":
            triangles += [[len(points) + corner for corner in face.vertices] for face in thing.data.polygons]
            points += [list(thing.matrix_world @ vertex.co) for vertex in thing.data.vertices]
    assert all(len(triangle) == 3 for triangle in triangles), "not only triangles"
    return {**measure(points, triangles, repeated), "complaint": "" if result == {"FINISHED"} else str(result)}


answer(read)
