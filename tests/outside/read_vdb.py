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

# A distance grows by a cell per cell, except halfway between two surfaces.
inside = outside = near = steep = 0
values = surface.getConstAccessor()
flows, full = velocity.getConstAccessor(), density.getConstAccessor()
for item in surface.citerOnValues():
    x, y, z = item.min
    assert abs(item.value) < surface.background
    if abs(item.value) < cell:
        slope = sum((values.getValue((x + a, y + b, z + c)) - values.getValue((x - a, y - b, z - c))) ** 2
                    for a, b, c in ((1, 0, 0), (0, 1, 0), (0, 0, 1))) ** 0.5 / (2 * cell)
        assert slope < 1.2, (item.min, slope)
        near += 1
        steep += slope > 0.8
    inside += item.value < 0
    outside += item.value > 0
    if item.value < -0.5 * cell:
        assert full.getValue((x, y, z)) > 0.4, (item.min, full.getValue((x, y, z)))
        assert flows.isValueOn((x, y, z)) and len(flows.getValue((x, y, z))) == 3
assert steep > 0.8 * near, (steep, near)
assert inside > 100 and outside > 100, (inside, outside)
print("OpenVDB reads the grids:", inside, "points inside,", outside, "outside")
