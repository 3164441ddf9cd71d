# SPDX-License-Identifier: MIT
"""A VTK program as its users write it: translucent balls by depth peeling, the camera going round them.

  vtk_scene.py IMAGE.png FRAMES

VTK asks after every peeled layer how many samples it had (SAMPLES_PASSED) and waits for the answer: that ends
the peeling.
"""
import sys

import vtkmodules.all as vtk

renderer = vtk.vtkRenderer()
renderer.SetUseDepthPeeling(1)
renderer.SetMaximumNumberOfPeels(12)
renderer.SetOcclusionRatio(0.0)
for i in range(5):
    ball = vtk.vtkSphereSource()
    ball.SetCenter(0.4 * i, 0.0, 0.3 * i)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(32)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(ball.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(i / 4, 1 - i / 4, 0.5)
    actor.GetProperty().SetOpacity(0.4)
    renderer.AddActor(actor)
window = vtk.vtkRenderWindow()
window.SetSize(320, 240)
window.SetMultiSamples(0)
window.SetAlphaBitPlanes(1)
window.AddRenderer(renderer)

renderer.ResetCamera()
for frame in range(int(sys.argv[2])):
    renderer.GetActiveCamera().Azimuth(10)
    window.Render()
print("peeled" if renderer.GetLastRenderingUsedDepthPeeling() else "not peeled", window.GetClassName())

picture = vtk.vtkWindowToImageFilter()
picture.SetInput(window)
picture.ReadFrontBufferOff()
writer = vtk.vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
