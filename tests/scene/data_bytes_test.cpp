// SPDX-License-Identifier: MIT
#include "scene/model/data_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "freshet/derived.h"
#include "freshet/simulation.h"
#include "io/frame_data.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

/// A dam break of several thousand particles, after 10 steps.
Frame dam(const std::string& domain, const std::string& max, double spacing) {
  Simulation sim(scene_with(domain, spacing,
                            "fluid = { min = [0, 0" + std::string(domain == "[1, 1]" ? "" : ", 0") +
                                "], max = " + max + " }"));
  for (int k = 0; k < 10; ++k) sim.step();
  Frame frame = sim.frame();
  for (float& p : frame.pressure) p = std::clamp(p, -65504.0f, 65504.0f);  // range of 16 bits
  return frame;
}

void expect_size(const Frame& frame, DataFormat format, const std::vector<DataField>& fields,
                 Precision precision) {
  Scene scene;
  scene.domain.max = Vector(std::size_t(frame.dimension), 1.0);
  scene.particles.spacing = 0.006;
  scene.output.data = {format};
  scene.output.fields = fields;
  scene.output.precision = precision;
  const double size = double(encode_points(format, table_of(frame, DataFields(scene))).size());
  EXPECT_NEAR(1, data_bytes(scene, double(frame.size())) / size,
              format == DataFormat::csv ? 0.15 : 0.01)
      << data_file(format, 0) << " of " << frame.size() << " particles in " << frame.dimension
      << "D, " << fields.size() << " fields: " << size << " bytes";
}

TEST(DataBytes, PredictTheSizeOfFiles) {
  const std::vector<DataField> all{DataField::velocity, DataField::density, DataField::pressure,
                                   DataField::id};
  for (const Frame& frame :
       {dam("[1, 1]", "[0.5, 0.8]", 0.006), dam("[1, 1, 1]", "[0.5, 0.8, 0.8]", 0.03)})
    for (const auto& fields : {all, std::vector{DataField::velocity}, std::vector<DataField>()}) {
      for (const DataFormat format :
           {DataFormat::vtp, DataFormat::ply, DataFormat::csv, DataFormat::hdf5, DataFormat::bgeo})
        expect_size(frame, format, fields, Precision::float32);
      expect_size(frame, DataFormat::hdf5, fields, Precision::float16);
    }
}

TEST(DataBytes, OfARunCountFramesAndFormats) {
  const std::string text =
      "fluid = { min = [0, 0], max = [0.5, 0.5] }\noutput.frame_every_steps = 50\noutput.data = ";
  const auto derived = [&](const std::string& data) {
    return derive(scene_with("[1, 1]", 0.05, text + data));
  };
  EXPECT_EQ(3, derived("['ply']").data_frames);
  EXPECT_EQ(0, derived("[]").data_frames);
  EXPECT_EQ(0, derived("[]").data_bytes);
  EXPECT_EQ(derived("['ply']").data_bytes + derived("['csv']").data_bytes,
            derived("['ply', 'csv']").data_bytes);
}

}  // namespace
}  // namespace freshet::test
