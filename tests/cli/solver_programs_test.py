#!/usr/bin/env python3
"""What solvers' own programs say of our meshes: gmsh fills a surface and reads tetrahedra, OpenFOAM checks both.
Each is skipped where it is not installed; exit code 77 if none is. Usage: solver_programs_test.py DUPIN
    apt-get install --no-install-recommends gmsh openfoam"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

DOCUMENT = {"units": "mm", "tolerance": 0.05, "parts": [
    {"name": "run", "pipe": {"from": [0, 0, 0], "to": [80, 0, 0], "radius": 10}},
    {"name": "branch", "pipe": {"from": [30, 2, 0], "to": [45, 2, 40], "radius": 6}}]}
HEAD = "FoamFile {{ version 2.0; format ascii; class dictionary; object {0}; }}\n"
CASE = {"controlDict": "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; "
                       "writeInterval 1;",
        "fvSchemes": "gradSchemes {} divSchemes {} laplacianSchemes {}",
        "fvSolution": "solvers {}",
        "surfaceFeatureExtractDict":
            "tee.stl { extractionMethod extractFromSurface; writeObj no; "
            "extractFromSurfaceCoeffs { includedAngle 140; } }",
        "blockMeshDict": """scale 1; edges (); mergePatchPairs ();
            vertices ((-4 -14 -14) (84 -14 -14) (84 14 -14) (-4 14 -14) (-4 -14 46) (84 -14 46) (84 14 46) (-4 14 46));
            blocks (hex (0 1 2 3 4 5 6 7) (44 14 30) simpleGrading (1 1 1));
            boundary (outside { type patch; faces ((0 3 2 1) (4 5 6 7) (0 1 5 4) (2 3 7 6) (1 2 6 5) (0 4 7 3)); });""",
        "snappyHexMeshDict": """castellatedMesh true; snap true; addLayers false; mergeTolerance 1e-6;
            geometry { tee.stl { type triSurfaceMesh; name tee; } }
            castellatedMeshControls { maxLocalCells 100000; maxGlobalCells 1000000; minRefinementCells 0;
              nCellsBetweenLevels 2; resolveFeatureAngle 40; allowFreeStandingZoneFaces true;
              features ({ file "tee.eMesh"; level 1; }); refinementSurfaces { tee { level (1 1); } }
              refinementRegions {} locationInMesh (INSIDE); }
            snapControls { nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; nFeatureSnapIter 10; }
            addLayersControls { relativeSizes true; layers {} expansionRatio 1; finalLayerThickness 0.3;
              minThickness 0.1; nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3; nSmoothThickness 10;
              maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; nBufferCellsNoExtrude 0;
              nLayerIter 50; }
            meshQualityControls { maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80;
              minVol 1e-13; minTetQuality 1e-15; minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05;
              minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75; }"""}
PATCHES = ("run", "run.start", "run.end", "branch", "branch.end")


def run(*command, folder, code=0):
    environment = {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ}
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == code, done.stdout[-2000:] + done.stderr[-2000:]
    return done.stdout + done.stderr


class SolverPrograms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = cls.scratch_folder = pathlib.Path(cls.scratch.name)
        (cls.folder / "tee.json").write_text(json.dumps(DOCUMENT), encoding="utf-8")
        run(TOOL, "build", "tee.json", "-o", "tee.stl", "--quality", "cfd", "--size", "6mm", "--patches", "tee.patches",
            folder=cls.folder)
        run(TOOL, "build", "tee.json", "-o", "tee.msh", "--size", "6mm", folder=cls.folder)

    @unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
    def test_gmsh_fills_the_surface(self):
        (self.folder / "tee.geo").write_text('Merge "tee.stl";\nSurface Loop(1) = Surface{:};\nVolume(1) = {1};\n',
                                             encoding="utf-8")
        said = run("gmsh", "tee.geo", "-3", "-format", "msh22", "-o", "filled.msh", folder=self.folder)
        self.assertNotIn("Error", said)
        self.assertIn("No ill-shaped tets in the mesh", said)
        self.assertIn("$Elements", (self.folder / "filled.msh").read_text(encoding="utf-8"))

    @unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
    def test_gmsh_reads_the_tetrahedra(self):
        said = run("gmsh", "tee.msh", "-check", "-", folder=self.folder)
        self.assertNotIn("Error", said)
        self.assertNotIn("Warning", said)

    @unittest.skipUnless(shutil.which("checkMesh"), "OpenFOAM is not installed")
    def test_openfoam_takes_surface_and_tetrahedra(self):
        self.write_case()
        surface = run("surfaceCheck", "tee.stl", folder=self.folder)
        self.assertIn("Surface is closed. All edges connected to two faces.", surface)
        run("gmshToFoam", "tee.msh", folder=self.folder)
        patches = (self.folder / "constant" / "polyMesh" / "boundary").read_text(encoding="utf-8")
        for name in ("run.start", "run.end", "branch.end"):
            self.assertIn(name, patches)
        self.assertIn("Mesh OK.", run("checkMesh", folder=self.folder))

    @unittest.skipUnless(shutil.which("snappyHexMesh"), "OpenFOAM is not installed")
    def test_openfoam_snaps_hexahedra_to_the_patches(self):
        self.folder = self.folder / "hexahedra"
        surfaces = self.folder / "constant" / "triSurface"
        surfaces.mkdir(parents=True)
        report = json.loads(run(TOOL, "build", "../tee.json", "-o", surfaces / "tee.stl", "--format", "stl-ascii",
                                "--quality", "cfd", "--size", "6mm", "--json", "--quiet", folder=self.folder))
        self.write_case()
        run("surfaceFeatureExtract", folder=self.folder)
        edges = re.search(r"// edges:\s+(\d+)", (surfaces / "tee.eMesh").read_text(encoding="utf-8"))
        self.assertGreater(int(edges.group(1)), 200, "three rims and the curve where the pipes meet")
        run("blockMesh", folder=self.folder)
        self.assertIn("Finished meshing without any errors", run("snappyHexMesh", "-overwrite", folder=self.folder))
        said = run("checkMesh", folder=self.folder)
        self.assertIn("Mesh OK.", said)
        boundary = (self.folder / "constant" / "polyMesh" / "boundary").read_text(encoding="utf-8")
        for name in PATCHES:
            faces = re.search(r"tee_%s\s*\{[^}]*nFaces\s+(\d+)" % re.escape(name), boundary)
            self.assertGreater(int(faces.group(1)), 50, name)
        volume = float(re.search(r"Total volume = ([0-9.]+)\.  ", said).group(1))
        self.assertLess(abs(volume - report["output"]["check"]["volume"]), 0.01 * volume)

    def write_case(self):
        (self.folder / "system").mkdir()
        listed = json.loads((self.scratch_folder / "tee.patches").read_text(encoding="utf-8"))
        inside = " ".join(map(str, listed["components"][0]["inside"]))
        for name, text in CASE.items():
            (self.folder / "system" / name).write_text(HEAD.format(name) + text.replace("INSIDE", inside),
                                                       encoding="utf-8")


if __name__ == "__main__":
    TOOL = os.path.abspath(sys.argv.pop(1))
    if not shutil.which("gmsh") and not shutil.which("checkMesh"):
        print("neither gmsh nor OpenFOAM is installed")
        sys.exit(77)
    unittest.main(verbosity=2)
