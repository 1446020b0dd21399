# SPDX-License-Identifier: MIT
"""read_vdb.py FILE: OpenVDB reads the grids of a file of `freshet surface --format vdb`."""
import sys

import pyopenvdb as vdb

grids, about = vdb.readAll(sys.argv[1])
assert about["creator"] == "Freshet", about
surface, density, velocity = (next(g for g in grids if g.name == name) for name in ("surface", "density", "v"))
assert surface.gridClass == vdb.GridClass.LEVEL_SET and density.gridClass == vdb.GridClass.FOG_VOLUME
assert density.saveFloatAsHalf and velocity.saveFloatAsHalf and not surface.saveFloatAsHalf
cell = surface.transform.voxelSize()[0]
assert abs(surface.background - 3 * cell) < 1e-6 * cell, surface.background

# Each piece of water in the file is a ball or a box; a level set grows by a cell per cell along its gradient.
inside = outside = 0
values = surface.getConstAccessor()
flows, full = velocity.getConstAccessor(), density.getConstAccessor()
for item in surface.citerOnValues():
    x, y, z = item.min
    assert abs(item.value) < surface.background
    slope = sum((values.getValue((x + a, y + b, z + c)) - values.getValue((x - a, y - b, z - c))) ** 2
                for a, b, c in ((1, 0, 0), (0, 1, 0), (0, 0, 1))) ** 0.5 / (2 * cell)
    if abs(item.value) < cell:
        assert 0.5 < slope < 1.1, (item.min, slope)
    inside += item.value < 0
    outside += item.value > 0
    if item.value < 0:
        assert full.isValueOn((x, y, z)) and flows.isValueOn((x, y, z))
        assert full.getValue((x, y, z)) > 0.4
assert inside > 100 and outside > 100, (inside, outside)
print("OpenVDB reads the grids:", inside, "points inside,", outside, "outside")
