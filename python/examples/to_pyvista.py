# SPDX-License-Identifier: MIT
"""Hands a frame over to PyVista, or to VTK alone if PyVista is missing.

The arrays of the frame are copied into the point cloud. usage: to_pyvista.py [PICTURE.png]
"""

import sys

import numpy as np

import freshet


def points_of(frame):
    """Positions (n, 3) [m]; z is 0 in 2D."""
    return np.pad(frame.x, ((0, 0), (0, 3 - frame.dimension)))


def vtk_cloud(frame):
    """A vtkPolyData with a vertex, the density [kg/m³] and the pressure [Pa] of each particle."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    points, vertices, cloud = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(points_of(frame), deep=True))
    cells = np.stack([np.ones(len(frame)), np.arange(len(frame))], axis=1).astype(np.int64)
    vertices.SetCells(len(frame), numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))
    cloud.SetPoints(points)
    cloud.SetVerts(vertices)
    for name in ("density", "pressure"):
        array = numpy_to_vtk(getattr(frame, name), deep=True)
        array.SetName(name)
        cloud.GetPointData().AddArray(array)
    return cloud


def main(picture=None):
    sim = freshet.Simulation("dam_break_2d")
    sim.run(until=0.1)
    frame = sim.frame()
    cloud = vtk_cloud(frame)
    try:
        import pyvista
    except ImportError:
        print(f"a vtkPolyData of {cloud.GetNumberOfPoints()} points; PyVista is not installed")
        return cloud
    mesh = pyvista.wrap(cloud)
    mesh["speed"] = np.linalg.norm(frame.v, axis=1)
    print(mesh)
    if picture:
        plotter = pyvista.Plotter(off_screen=True)
        plotter.add_mesh(mesh, scalars="speed", point_size=4, render_points_as_spheres=True)
        plotter.screenshot(picture)
    return mesh


if __name__ == "__main__":
    main(*sys.argv[1:2])
