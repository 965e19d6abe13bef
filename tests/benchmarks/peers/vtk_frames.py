#!/usr/bin/env python3
"""Times what VTK takes for a picture like that of the benchmark `organ`: as many triangles in the middle of 1280 x 720
pixels and a ball on them, shaded physically under one light, off-screen, read back. It draws no shadows, no floor and no
outline, and has no look of tissue. Prints a row of Google Benchmark's form for each size and way to smooth edges."""

import json
import math
import statistics
import time

import vtk

WIDTH, HEIGHT = 1280, 720
ORGANS = (5000, 20000)  # triangles, as the benchmark `organ` has
PROBE = 1000
PICTURES = 40


def ball(radius, center, triangles, color):
    """As many triangles, by circles of latitude and longitude, of which there are as many as meridians are cut into."""
    around = round(math.sqrt(triangles / 2))
    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(radius)
    sphere.SetCenter(*center)
    sphere.SetThetaResolution(around)
    sphere.SetPhiResolution(around + 2)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToPBR()
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetRoughness(0.4)
    return actor


def scene(triangles, smoothing):
    renderer = vtk.vtkRenderer()
    renderer.AddActor(ball(0.03, (0, 0, 0.03), triangles, (0.7, 0.35, 0.3)))
    renderer.AddActor(ball(0.004, (0, 0, 0.064), PROBE, (0.6, 0.6, 0.6)))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.13, -0.13, 0.1)
    camera.SetFocalPoint(0, 0, 0.03)
    camera.SetViewUp(0, 0, 1)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(WIDTH, HEIGHT)
    window.SetMultiSamples(4 if smoothing == "msaa" else 0)
    if smoothing == "fxaa":
        renderer.UseFXAAOn()
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    return window


def seconds_of_a_picture(window):
    pixels = vtk.vtkUnsignedCharArray()
    taken = []
    for _ in range(PICTURES + 1):
        begin = time.monotonic()
        window.Render()
        window.GetPixelData(0, 0, WIDTH - 1, HEIGHT - 1, 1, pixels, 0)
        taken.append(time.monotonic() - begin)
    return statistics.median(taken[1:])  # the first compiles the shaders


def main():
    rows = [{"name": f"PeerPicture/vtk/{triangles}/{smoothing}", "real_time": 1e3 * seconds_of_a_picture(scene(triangles, smoothing)),
             "time_unit": "ms"} for triangles in ORGANS for smoothing in ("fxaa", "msaa")]
    print(json.dumps(rows))


if __name__ == "__main__":
    main()
