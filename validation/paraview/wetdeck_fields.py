# SPDX-License-Identifier: BSD-3-Clause
"""Opens the fields of a run in ParaView 5.11: phases on top, pressure below, bodies and walls drawn as they are, with time.

In ParaView:   WETDECK_RUN=RUN_DIR paraview --script=wetdeck_fields.py
As a picture:  pvpython wetdeck_fields.py RUN_DIR --picture drop.png [--time 0.012]
As a film:     pvpython wetdeck_fields.py RUN_DIR --film drop.png       (drop.0000.png, drop.0001.png, ...)
Without a display, put `xvfb-run -a -s "-screen 0 1280x1024x24 -noreset"` in front of pvpython.
"""
import argparse
import os
import sys

import numpy
from paraview import servermanager, simple as pv
from paraview.vtk.util.numpy_support import vtk_to_numpy

WATER, AIR, WALL, FIRST_BODY = 0, 1, 2, 3
PHASE_COLOURS = {  # water, air, tank, bodies
    "water": (0.13, 0.40, 0.67), "air": (0.87, 0.92, 0.96), "wall": (0.45, 0.45, 0.45), "body": (0.84, 0.38, 0.10)}


def arrays(reader, time):
    """Places, phases and pressures of all particles at a time, as numpy arrays."""
    reader.UpdatePipeline(time)
    data = servermanager.Fetch(reader)
    points = data.GetPointData()
    return (vtk_to_numpy(data.GetPoints().GetData()),
            vtk_to_numpy(points.GetArray("phase")), vtk_to_numpy(points.GetArray("pressure")))


def spacing(places, phases):
    """Distance of the layers of the tank's walls, which lie on a lattice."""
    x = numpy.unique(numpy.round(places[phases == WALL][:, 0], 9))
    return float(numpy.median(numpy.diff(x)))


def pressure_range(reader, times):
    """What all but one in a thousand water particles read, over up to ten of the times."""
    chosen = times[:: max(1, len(times) // 10)] + [times[-1]]
    water = numpy.concatenate([p[phase == WATER] for _, phase, p in (arrays(reader, t) for t in chosen)])
    low, high = numpy.quantile(water, [0.001, 0.999])
    return float(low), float(max(high, low + 1e-9))


def particles(source, view, size, low, high):
    """Discs of one spacing for the particles whose phase lies from `low` to `high`."""
    part = pv.Threshold(Input=source)
    part.Scalars = ["POINTS", "phase"]
    part.ThresholdMethod = "Between"
    part.LowerThreshold, part.UpperThreshold = low, high
    shown = pv.Show(part, view)
    shown.Representation = "Point Gaussian"
    shown.ShaderPreset = "Plain circle"
    shown.GaussianRadius = 0.75 * size  # no gaps on a square lattice
    return shown


def draw(source, view, title, size, reach, places):
    view.OrientationAxesVisibility = 0
    view.InteractionMode = "2D"
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    for low, high, name in ((WALL, WALL, "wall"), (FIRST_BODY, FIRST_BODY + 999, "body")):
        shown = particles(source, view, size, low, high)
        pv.ColorBy(shown, None)
        shown.AmbientColor = shown.DiffuseColor = PHASE_COLOURS[name]
    if reach is None:
        for phase, name in ((AIR, "air"), (WATER, "water")):
            shown = particles(source, view, size, phase, phase)
            pv.ColorBy(shown, None)
            shown.AmbientColor = shown.DiffuseColor = PHASE_COLOURS[name]
    else:
        shown = particles(source, view, size, WATER, WATER)
        pv.ColorBy(shown, ("POINTS", "pressure"))
        colours = pv.GetColorTransferFunction("pressure")
        colours.ApplyPreset("Viridis (matplotlib)", True)
        colours.RescaleTransferFunction(*reach)
        bar = pv.GetScalarBar(colours, view)
        bar.Title, bar.ComponentTitle = "pressure [Pa]", ""
        bar.TitleColor = bar.LabelColor = [0, 0, 0]
        shown.SetScalarBarVisibility(view, True)
    clock = pv.AnnotateTimeFilter(Input=source, Format=title + ", t = {time:.4f} s")
    text = pv.Show(clock, view)
    text.Color, text.FontSize = [0, 0, 0], 10
    low, high = places.min(axis=0), places.max(axis=0)
    width, height = view.ViewSize
    # room for the clock above, for the colour bar on the right
    middle = 0.5 * (low + high) + [0.06 * (high[0] - low[0]), 0.04 * (high[1] - low[1]), 0]
    view.CameraPosition = [middle[0], middle[1], 10 * (high - low).max()]
    view.CameraFocalPoint = [middle[0], middle[1], 0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.57 * max(high[1] - low[1], (high[0] - low[0]) * height / width)


def open_run(directory):
    """Two views with the fields of a run: their layout, the times there are, and the size of both [pixels]."""
    file = os.path.join(directory, "fields.pvd")
    if not os.path.exists(file):
        sys.exit(f"{file}: no such file, expected the directory of a run")
    reader = pv.PVDReader(registrationName="fields of " + os.path.basename(os.path.abspath(directory)), FileName=file)
    times = list(reader.TimestepValues)
    places, phases, _ = arrays(reader, times[0])
    size, reach = spacing(places, phases), pressure_range(reader, times)
    layout = pv.CreateLayout("wetdeck")
    low, high = places.min(axis=0), places.max(axis=0)
    height = int(min(1000, max(200, 1200 * (high[1] - low[1]) / (high[0] - low[0]))))
    for title, limits in (("phases", None), ("pressure of the water", reach)):
        view = pv.CreateRenderView(ViewSize=[1200, height])
        draw(reader, view, title, size, limits, places)
        pv.AssignViewToLayout(view=view, layout=layout, hint=0 if limits is None else 2)
        if limits is None:
            layout.SplitVertical(0, 0.5)
    pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    return layout, times, [1200, 2 * height]


def main():
    options = argparse.ArgumentParser(description="Fields of a run in ParaView.")
    options.add_argument("run", nargs="?", default=os.environ.get("WETDECK_RUN"), help="directory of a run")
    options.add_argument("--picture", help="write this PNG")
    options.add_argument("--film", help="write a PNG per frame, named after this one")
    options.add_argument("--time", type=float, help="of the picture [s] (the last)")
    chosen = options.parse_args()
    if chosen.run is None:
        sys.exit("which run? name its directory, or set WETDECK_RUN")
    layout, times, size = open_run(chosen.run)
    scene = pv.GetAnimationScene()
    scene.AnimationTime = times[-1] if chosen.time is None else min(times, key=lambda t: abs(t - chosen.time))
    if chosen.picture:
        pv.SaveScreenshot(chosen.picture, layout, ImageResolution=size)
    if chosen.film:
        pv.SaveAnimation(chosen.film, layout, ImageResolution=size)


main()
