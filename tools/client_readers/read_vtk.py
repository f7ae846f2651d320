"""Reads files by VTK (tools/clients.py)."""
from measure import answer
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges, vtkMassProperties
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

READERS = {"stl": vtkSTLReader, "stl-ascii": vtkSTLReader, "obj": vtkOBJReader, "ply": vtkPLYReader,
           "ply-ascii": vtkPLYReader, "vtp": vtkXMLPolyDataReader}


def merged(reader):
    clean = vtkCleanPolyData()
    clean.PointMergingOn()
    clean.SetTolerance(0)
    clean.SetInputConnection(reader.GetOutputPort())
    return clean


def read(path, form, repeated):
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    reader = READERS[form]()
    reader.SetFileName(path)
    # Of an OBJ file with normals, the reader makes points of their own for every corner.
    surface = merged(reader) if repeated or form == "obj" else reader
    edges, mass = vtkFeatureEdges(), vtkMassProperties()
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    for step in (edges, mass):
        step.SetInputConnection(surface.GetOutputPort())
        step.Update()
    return {"triangles": reader.GetOutput().GetNumberOfPolys(), "volume": mass.GetVolume(),
            "open_edges": edges.GetOutput().GetNumberOfCells(), "complaint": " ".join(window.GetOutput().split())}


answer(read)
