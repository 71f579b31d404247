# SPDX-License-Identifier: BSD-3-Clause
"""Two pictures of the same views at two times: what must be in each, and what must have changed between them."""
import sys

import numpy
from paraview.vtk.util.numpy_support import vtk_to_numpy
from paraview.vtk.vtkIOImage import vtkPNGReader


def pixels(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].astype(int)


def share(image, colour):
    """Of pixels that have nearly this colour (0 to 1)."""
    return float(numpy.mean(numpy.abs(image - 255 * numpy.array(colour)).max(axis=2) < 12))


first, last = (pixels(file) for file in sys.argv[1:3])
half = first.shape[0] // 2
# Shares of one view: of 2.6 m x 1.45 m of tank, 2.6 m x 1.05 m are water, the wedge has 0.036 m2 (1 % of the tank).
expected = {"water": ((0.13, 0.40, 0.67), 0.3), "air": ((0.87, 0.92, 0.96), 0.1),
            "walls": ((0.45, 0.45, 0.45), 0.02), "wedge": ((0.84, 0.38, 0.10), 0.003)}
failures = [f"{name}: {share(last[:half], colour):.4f} of the picture, expected more than {least}"
            for name, (colour, least) in expected.items() if share(last[:half], colour) < least]
if share(last[half:], expected["water"][0]) > 0.05:
    failures.append("the lower view shows phases instead of the pressure")
if len(numpy.unique(last[half:].reshape(-1, 3), axis=0)) < 100:
    failures.append("the lower view has no range of colours")
if numpy.mean(numpy.any(first != last, axis=2)) < 0.01:
    failures.append("the two times give the same picture")
print("\n".join(failures) or "all there")
sys.exit(1 if failures else 0)
