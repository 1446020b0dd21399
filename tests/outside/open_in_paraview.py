# SPDX-License-Identifier: MIT
"""pvpython tests/outside/open_in_paraview.py DIR: ParaView opens the files that drop.toml wrote."""
import csv
import os
import sys

from paraview import servermanager, simple

folder = os.path.join(sys.argv[1], "data")
reader = simple.PVDReader(FileName=os.path.join(folder, "frames.pvd"))
reader.UpdatePipeline()
times = list(reader.TimestepValues)
print("times:", times)
assert len(times) == 3 and times == sorted(times), times
assert abs(times[0] - 0.0002) < 1e-9 and abs(times[-1] - 0.1) < 1e-9, times

for k, time in enumerate(times):
    reader.UpdatePipeline(time)
    information = reader.GetDataInformation()
    print("time", time, "points", information.GetNumberOfPoints())
    assert information.GetNumberOfPoints() == 512
    assert information.GetNumberOfCells() == 512
    arrays = reader.PointData
    assert sorted(arrays.keys()) == ["density", "id", "pressure", "velocity"], arrays.keys()
    data = servermanager.Fetch(reader)
    velocity = data.GetPointData().GetArray("velocity")
    ids = data.GetPointData().GetArray("id")
    with open(os.path.join(folder, "frame_%04d.csv" % k)) as file:  # the same frame as text
        rows = list(csv.DictReader(file))
    for i, row in enumerate(rows):
        assert float(row["time"]) == time and int(row["id"]) == ids.GetValue(i)
        for a in range(3):
            point, speed = data.GetPoint(i)[a], velocity.GetComponent(i, a)
            assert abs(point - float(row["xyz"[a]])) < 1e-6, (i, a, point, row)
            assert abs(speed - float(row["v" + "xyz"[a]])) < 1e-6 * (1 + abs(speed)), (i, a, row)
low, high = reader.PointData["velocity"].GetRange(1)
print("velocity along y: %g to %g m/s" % (low, high))
assert abs(low + 0.981) < 0.01, low
table = simple.CSVReader(FileName=[os.path.join(folder, "frame_0000.csv")])
table.UpdatePipeline()
assert table.GetDataInformation().GetNumberOfRows() == 512
print("ParaView reads the PVD, the VTP and the CSV files")
