// SPDX-License-Identifier: MIT
#include "io/hdf5.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "cli/files.h"
#include "freshet/error.h"
#include "io/frame_data.h"
#include "io/frame_files.h"
#include "io/sample_frame.h"

namespace freshet::test {
namespace {

/// A dataset of a file, read by the HDF5 library alone.
struct Stored {
  Stored(const fs::path& path, const char* name)
      : file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose),
        data(H5Dopen2(file.get(), name, H5P_DEFAULT), H5Dclose),
        type(H5Dget_type(data.get()), H5Tclose),
        space(H5Dget_space(data.get()), H5Sclose) {
    rank = H5Sget_simple_extent_dims(space.get(), extents, nullptr);
  }
  std::vector<float> floats(std::size_t n) const {
    std::vector<float> values(n);
    EXPECT_GE(H5Dread(data.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
              0);
    return values;
  }
  Hdf5Lock lock;
  Hdf5Handle file, data, type, space;
  hsize_t extents[2] = {0, 0};
  int rank = 0;
};

TEST(EncodeHdf5, HasTypedTables) {
  const TemporaryFolder folder;
  const Frame f = sample_frame(3, 4);
  write_text(folder / "a.h5", encode_hdf5(f));
  const Stored position(folder / "a.h5", "position"), id(folder / "a.h5", "id");
  EXPECT_EQ(2, position.rank);
  EXPECT_EQ(4u, position.extents[0]);
  EXPECT_EQ(3u, position.extents[1]);
  EXPECT_GT(H5Tequal(position.type.get(), H5T_IEEE_F32LE), 0);
  EXPECT_GT(H5Tequal(id.type.get(), H5T_STD_U64LE), 0);
  EXPECT_EQ(1, id.rank);
  EXPECT_EQ(f.x, position.floats(12));
  EXPECT_EQ(f.pressure, Stored(folder / "a.h5", "pressure").floats(4));
  const Hdf5Reader file(encode_hdf5(f), "a.h5");
  EXPECT_EQ("m/s", file.text("velocity", "unit"));
  EXPECT_EQ(0.1, file.number("/", "time"));
  EXPECT_EQ(1234, file.integer("/", "step"));
  EXPECT_EQ(3, file.integer("/", "dimension"));
}

TEST(EncodeHdf5, NamesTheSameUnitsIn2DAndIn3D) {
  for (const int dimension : {2, 3}) {
    const Hdf5Reader file(encode_hdf5(sample_frame(dimension, 4)), "a.h5");
    EXPECT_EQ("kg/m^3", file.text("density", "unit"));
    EXPECT_EQ("Pa", file.text("pressure", "unit"));
  }
}

TEST(EncodeHdf5, RoundsToTheNearest16BitNumber) {
  const TemporaryFolder folder;
  Frame f = sample_frame(2, 6);
  f.density = {1000.24f, 1000.25f, 1.0f / 3, 65504, 1023.9f, -1000.25f};
  DataFields half;
  half.half = true;
  write_text(folder / "a.h5", encode_hdf5(f, half));
  const Stored density(folder / "a.h5", "density");
  EXPECT_EQ(2u, H5Tget_size(density.type.get()));
  // 10 bits after the leading one: steps of 0.5 at 1000; the library rounds halves away from 0
  const auto read = density.floats(6);
  EXPECT_EQ(1000.0f, read[0]);
  EXPECT_EQ(1000.5f, read[1]);
  EXPECT_EQ(0.333251953125f, read[2]);
  EXPECT_EQ(65504.0f, read[3]);
  EXPECT_EQ(1024.0f, read[4]);
  EXPECT_EQ(-1000.5f, read[5]);
  EXPECT_EQ(4u, H5Tget_size(Stored(folder / "a.h5", "position").type.get()));
  const Frame back = read_frame(folder / "a.h5");
  EXPECT_EQ(f.x, back.x);
  EXPECT_EQ(read, back.density);
  for (std::size_t k = 0; k < f.v.size(); ++k) EXPECT_NEAR(f.v[k], back.v[k], 5e-4f);
}

TEST(EncodeHdf5, Keeps4BytesForAFieldBeyondTheRangeOf16Bits) {
  const TemporaryFolder folder;
  Frame f = sample_frame(2, 2);
  f.pressure = {65505, 1};
  DataFields half;
  half.half = true;
  write_text(folder / "a.h5", encode_hdf5(f, half));
  EXPECT_EQ(4u, H5Tget_size(Stored(folder / "a.h5", "pressure").type.get()));
  EXPECT_EQ(f.pressure, read_frame(folder / "a.h5").pressure);
}

TEST(Hdf5, ReadsEveryNumberTypeThatItWrites) {
  Hdf5Writer out;
  const std::vector<double> doubles{0.1, -1e300};
  const std::vector<std::int32_t> ints{-5, 7, 9};
  const std::vector<std::int64_t> longs{std::numeric_limits<std::int64_t>::min()};
  const std::vector<std::uint64_t> ids{std::numeric_limits<std::uint64_t>::max()};
  out.write("doubles", doubles);
  out.write("ints", ints, 3);
  out.write("longs", longs);
  out.write("ids", ids);
  out.attribute("/", "scene", std::string("title = \"Flüsse\"\n"));
  const Hdf5Reader in(out.bytes(), "a.h5");  // one thread may hold a reader and a writer at once
  std::vector<double> d;
  std::vector<std::int32_t> i;
  std::vector<std::int64_t> l;
  std::vector<std::uint64_t> u;
  in.read("doubles", d);
  in.read("ints", i);
  in.read("longs", l);
  in.read("ids", u);
  EXPECT_EQ(doubles, d);
  EXPECT_EQ(ints, i);
  EXPECT_EQ(longs, l);
  EXPECT_EQ(ids, u);
  EXPECT_EQ(3u, in.columns("ints"));
  EXPECT_FALSE(in.has("nothing"));
  EXPECT_EQ("title = \"Flüsse\"\n", in.text("/", "scene"));
}

TEST(Hdf5, ReportsMissingListsAndAttributes) {
  Hdf5Writer out;
  out.write("three", std::span<const float>(std::vector<float>{1, 2, 3}));
  out.attribute("/", "name", std::string("value"));
  const Hdf5Reader in(out.bytes(), "a.h5");
  const auto said = [&](auto f) -> std::string {
    try {
      f();
      return "no error";
    } catch (const Error& e) {
      return e.what();
    }
  };
  std::vector<float> v;
  EXPECT_EQ("a.h5: error: there is no list or table \"velocity\" in it; is it the right file?",
            said([&] { in.read("velocity", v); }));
  EXPECT_EQ("a.h5: error: there is no \"time\" in it that can be read; is it the right file?",
            said([&] { in.number("/", "time"); }));
  EXPECT_EQ("a.h5: error: there is no text \"time\" in it; is it the right file?",
            said([&] { in.text("/", "time"); }));
  EXPECT_NE("no error", said([&] { in.number("/", "name"); }));
}

TEST(Hdf5, RejectsFramesWithInconsistentFields) {
  const auto refused = [](auto fill) -> std::string {
    Hdf5Writer out;
    fill(out);
    try {
      frame_in(out.bytes(), "a.h5");
      return "no error";
    } catch (const Error& e) {
      return e.what();
    }
  };
  const std::vector<float> six(6), four(4);
  EXPECT_EQ("a.h5: error: there is no list or table \"position\" in it; is it the right file?",
            refused([](Hdf5Writer&) {}));
  EXPECT_EQ("a.h5: error: \"position\" has 1 columns; 2 or 3 are allowed, is it the right file?",
            refused([&](Hdf5Writer& f) { f.write("position", std::span<const float>(six)); }));
  EXPECT_EQ(
      "a.h5: error: \"velocity\" is not 3 × 2 numbers, as the positions ask for; the file is "
      "damaged",
      refused([&](Hdf5Writer& f) {
        f.write("position", std::span<const float>(six), 2);
        f.write("velocity", std::span<const float>(four), 2);
      }));
  const std::string not_per_particle =
      " is not one number for each of the 3 particles; the file is damaged";
  const std::vector<std::uint64_t> one(1), three(3);
  for (const auto* ids : {&one, &three})
    EXPECT_EQ("a.h5: error: \"id\"" + not_per_particle, refused([&](Hdf5Writer& f) {
                f.write("position", std::span<const float>(six), 2);
                f.write("id", std::span<const std::uint64_t>(*ids), ids->size());
              }));
  EXPECT_EQ("a.h5: error: \"liquid\"" + not_per_particle, refused([&](Hdf5Writer& f) {
              f.write("position", std::span<const float>(six), 2);
              f.write("liquid", std::span<const std::int32_t>(std::vector<std::int32_t>(2)));
            }));
  EXPECT_EQ("a.h5: error: a number of \"liquid\" is negative; the file is damaged",
            refused([&](Hdf5Writer& f) {
              f.write("position", std::span<const float>(six), 2);
              f.write("liquid", std::span<const std::int32_t>(std::vector<std::int32_t>(3, -1)));
            }));
  EXPECT_EQ("a.h5: error: its dimension is 3, and \"position\" has 2 columns; the file is damaged",
            refused([&](Hdf5Writer& f) {
              f.write("position", std::span<const float>(six), 2);
              f.attribute("/", "dimension", std::int64_t(3));
            }));
  EXPECT_EQ("a.h5: error: its time is inf and its step 0; the file is damaged",
            refused([&](Hdf5Writer& f) {
              f.write("position", std::span<const float>(six), 2);
              f.attribute("/", "time", std::numeric_limits<double>::infinity());
            }));
}

// As in the other formats, whose readers are tested in frame_files_test.cpp.
TEST(Hdf5Frames, AreRejectedWithNanAndInfinity) {
  for (const float wrong :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()})
    for (const bool half : {false, true})
      for (const char* name : {"position", "velocity", "density", "pressure"}) {
        Frame f = test::sample_frame(2, 3);
        const std::string field = name;
        (field == "position"   ? f.x
         : field == "velocity" ? f.v
         : field == "density"  ? f.density
                               : f.pressure)[2] = wrong;
        DataFields fields;
        fields.half = half;
        try {
          frame_in(encode_hdf5(f, fields), "a.h5");
          ADD_FAILURE() << name << " is " << wrong;
        } catch (const Error& e) {
          EXPECT_TRUE(std::string(e.what()).starts_with("a.h5: error: a number of \"" + field))
              << e.what();
        }
      }
}

TEST(Hdf5, CanBeUsedByFourThreadsAtOnce) {
  const Frame f = sample_frame(3, 500);
  std::vector<std::string> files(4);
  std::vector<std::thread> threads;
  for (std::string& file : files)
    threads.emplace_back([&] {
      for (int k = 0; k < 20; ++k) file = encode_hdf5(f);
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& file : files) expect_same(f, frame_in(file, "a.h5"));
}

}  // namespace
}  // namespace freshet::test
