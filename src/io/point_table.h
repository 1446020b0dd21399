// SPDX-License-Identifier: MIT
/// What a data file holds, whatever its format: points at one time, and columns of numbers.
#pragma once
#include <cstdint>
#include <type_traits>
#include <variant>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"

namespace freshet {

/// The fields of a data file in addition to the position.
struct DataFields {
  bool velocity = true, density = true, pressure = true, id = true;
  bool half = false;  ///< HDF5: velocity, density and pressure as 2-byte floats
  float pscale = 0;   ///< bgeo: the radius of a particle [m]; none if 0

  DataFields() = default;
  explicit DataFields(const Scene::Output& output);
  /// With half a spacing as radius.
  explicit DataFields(const Scene& scene) : DataFields(scene.output) {
    pscale = float(scene.particles.spacing / 2);
  }
};

struct PointColumn {
  const char* name;
  const char* unit;
  /// One number per point; a velocity has `dimension` of them.
  std::variant<const std::vector<float>*, const std::vector<std::int32_t>*,
               const std::vector<std::uint64_t>*>
      values;
  bool vectors = false, half = false;
};

/// It refers to the arrays of a frame.
struct PointTable {
  double time;  ///< [s]
  std::int64_t step;
  int dimension;
  const std::vector<float>& x;  ///< `dimension` numbers per point [m]
  std::vector<PointColumn> columns;
  float pscale = 0;  ///< bgeo: the radius of a point [m]; none if 0
  std::size_t size() const { return x.size() / std::size_t(dimension); }
};

PointTable table_of(const Frame& frame, const DataFields& fields);
/// The whitewater of a frame: velocity, id, kind and age. Its radius is 0.4 of the fluid's
/// `pscale`.
PointTable whitewater_table(const Frame& frame, float pscale = 0);

/// Calls use(value) for the numbers of point i: `of_vectors` of a vector, as many as there are
/// axes and then 0, else one.
template <class Use>
void numbers_at(const PointColumn& column, std::size_t i, std::size_t dimension,
                std::size_t of_vectors, const Use& use) {
  std::visit(
      [&](const auto* values) {
        using T = typename std::remove_cvref_t<decltype(*values)>::value_type;
        if (!column.vectors) return use((*values)[i]);
        for (std::size_t k = 0; k < of_vectors; ++k)
          use(k < dimension ? (*values)[i * dimension + k] : T(0));
      },
      column.values);
}

}  // namespace freshet
