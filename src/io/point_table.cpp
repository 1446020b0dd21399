// SPDX-License-Identifier: MIT
#include "io/point_table.h"

#include <algorithm>

#include "freshet/units.h"

namespace freshet {

DataFields::DataFields(const Scene::Output& output) : half(output.precision == Precision::float16) {
  const auto has = [&](DataField field) {
    return std::find(output.fields.begin(), output.fields.end(), field) != output.fields.end();
  };
  velocity = has(DataField::velocity);
  density = has(DataField::density);
  pressure = has(DataField::pressure);
  id = has(DataField::id);
}

PointTable table_of(const Frame& frame, const DataFields& fields) {
  const Units units = units_in(frame.dimension);
  PointTable table{frame.time, frame.step, frame.dimension, frame.x, {}, fields.pscale};
  const auto add = [&](bool wanted, PointColumn column) {
    if (wanted) table.columns.push_back(column);
  };
  add(fields.velocity, {"velocity", units.speed, &frame.v, true, fields.half});
  add(fields.density, {"density", units.density, &frame.density, false, fields.half});
  add(fields.pressure, {"pressure", units.pressure, &frame.pressure, false, fields.half});
  add(fields.id, {"id", "1", &frame.id});
  add(!frame.liquid.empty(), {"liquid", "1", &frame.liquid});
  return table;
}

PointTable whitewater_table(const Frame& frame, float pscale) {
  const Units units = units_in(frame.dimension);
  const WhitewaterFrame& w = frame.whitewater;
  return {frame.time,
          frame.step,
          frame.dimension,
          w.x,
          {{"velocity", units.speed, &w.v, true},
           {"id", "1", &w.id},
           {"kind", "1", &w.kind},
           {"age", "s", &w.age}},
          0.4f * pscale};
}

}  // namespace freshet
