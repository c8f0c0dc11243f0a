# SPDX-License-Identifier: MIT
"""Prints the size of a PNG file and the colours of some of its pixels as text, for pictures_test.cpp.

Usage: read_picture.py FOLDER, which holds picture.png and pixels.txt (lines `x y` from the lower left). Writes
colours.txt there: `width height`, then a line `r g b` a pixel. Exit 77: no VTK.
"""
import os
import sys

try:
    from vtkmodules.vtkIOImage import vtkPNGReader
except ImportError:
    sys.exit(77)

folder = sys.argv[1]
reader = vtkPNGReader()
reader.SetFileName(os.path.join(folder, "picture.png"))
reader.Update()
image = reader.GetOutput()
width, height, _ = image.GetDimensions()
with open(os.path.join(folder, "pixels.txt")) as file:
    pixels = [[int(number) for number in line.split()] for line in file]
with open(os.path.join(folder, "colours.txt"), "w") as file:
    print(width, height, file=file)
    for x, y in pixels:
        print(*(int(image.GetScalarComponentAsDouble(x, y, 0, c)) for c in range(3)), file=file)
