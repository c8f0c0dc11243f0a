# SPDX-License-Identifier: MIT
"""Reads a snapshot series with VTK's own reader and compares it with what the test says it wrote.

Usage: read_snapshot.py FOLDER, which holds blast.hdf.series and expected.json. Exit 0: equal. 1: not. 77: no VTK.
"""
import json
import os
import sys

try:
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError:
    sys.exit(77)


def rows(array, count):
    return [list(array.GetTuple(i)) for i in range(count)]


def read(path):
    reader = vtkHDFReader()
    assert reader.CanReadFile(path), path + " is refused by vtkHDFReader"
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    cells = grid.GetNumberOfCells()
    data = grid.GetCellData()
    return {
        "class": grid.GetClassName(),
        "points": [list(grid.GetPoint(i)) for i in range(grid.GetNumberOfPoints())],
        "types": [grid.GetCellType(i) for i in range(cells)],
        "cells": [[grid.GetCell(i).GetPointId(k) for k in range(grid.GetCell(i).GetNumberOfPoints())]
                  for i in range(cells)],
        "fields": {data.GetArrayName(f): rows(data.GetArray(f), cells) for f in range(data.GetNumberOfArrays())},
        "point_fields": grid.GetPointData().GetNumberOfArrays(),
    }


folder = sys.argv[1]
with open(os.path.join(folder, "expected.json")) as file:
    expected = json.load(file)
with open(os.path.join(folder, "blast.hdf.series")) as file:
    series = json.load(file)

assert series["file-series-version"] == "1.0", series
assert [entry["time"] for entry in series["files"]] == [step["time"] for step in expected], series
assert [entry["name"] for entry in series["files"]] == ["blast_%06d.hdf" % i for i in range(len(expected))], series
for entry, step in zip(series["files"], expected):
    found = read(os.path.join(folder, entry["name"]))
    assert found["class"] == "vtkUnstructuredGrid", found["class"]
    assert found["point_fields"] == 0
    for what in ("points", "types", "cells", "fields"):
        assert found[what] == step[what], "%s: %s: read %s, written %s" % (
            entry["name"], what, found[what], step[what])
print("read %d snapshots" % len(expected))
