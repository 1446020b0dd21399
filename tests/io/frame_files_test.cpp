// SPDX-License-Identifier: MIT
#include "io/frame_files.h"

#include <gtest/gtest.h>

#include "cli/files.h"
#include "freshet/error.h"
#include "io/frame_data.h"
#include "io/sample_frame.h"

namespace freshet::test {
namespace {

constexpr DataFormat formats[] = {DataFormat::vtp, DataFormat::ply, DataFormat::csv,
                                  DataFormat::hdf5};

std::string refused(const std::string& bytes, const std::string& file) {
  try {
    frame_in(bytes, file);
    return "read without an error";
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(ReadFrame, ReadsWhatWasWritten) {
  for (const DataFormat format : formats)
    for (const int dimension : {2, 3})
      for (const std::uint64_t first : {std::uint64_t(0), std::uint64_t(1) << 40}) {
        SCOPED_TRACE(data_file(format, dimension));
        const Frame f = sample_frame(dimension, 7, first);
        expect_same(f, frame_in(encode_points(format, table_of(f, {})), data_file(format, 0)));
      }
}

TEST(ReadFrame, ReadsTheLiquidsOfParticles) {
  for (const DataFormat format : formats) {
    Frame f = sample_frame(3, 3);
    f.liquid = {0, 2, 1};
    EXPECT_EQ(f.liquid,
              frame_in(encode_points(format, table_of(f, {})), data_file(format, 0)).liquid)
        << data_file(format, 0);
  }
}

TEST(ReadFrame, FillsMissingFieldsWithDefaults) {
  DataFields few;
  few.velocity = few.density = few.pressure = few.id = false;
  for (const DataFormat format : formats) {
    SCOPED_TRACE(data_file(format, 0));
    const Frame f = sample_frame(3, 4);
    Frame bare = f;
    bare.v.assign(12, 0);
    bare.density = bare.pressure = {0, 0, 0, 0};
    bare.id = {0, 1, 2, 3};
    expect_same(bare, frame_in(encode_points(format, table_of(f, few)), data_file(format, 0)));
  }
}

TEST(ReadFrame, ReadsAFrameWithoutParticles) {
  for (const DataFormat format : {DataFormat::vtp, DataFormat::ply, DataFormat::hdf5}) {
    SCOPED_TRACE(data_file(format, 0));
    const Frame f = sample_frame(2, 0);
    expect_same(f, frame_in(encode_points(format, table_of(f, {})), data_file(format, 0)));
  }
}

TEST(ReadFrame, RejectsTruncatedFiles) {
  for (const DataFormat format : formats) {
    const std::string whole = encode_points(format, table_of(sample_frame(2, 40), {}));
    for (std::size_t n = 1; n + 1 < whole.size(); n += 13) {
      if (format == DataFormat::csv && whole[n - 1] == '\n') continue;  // fewer rows, but valid
      EXPECT_THROW(frame_in(whole.substr(0, n), data_file(format, 0)), Error)
          << data_file(format, 0) << " cut to " << n << " of " << whole.size();
    }
  }
}

TEST(ReadFrame, ReportsPlaceAndRemedy) {
  EXPECT_EQ("a.txt: error: not *.h5, *.vtp, *.ply or *.csv; name a data file of a run",
            refused("x,y\n1,2\n", "a.txt"));
  EXPECT_EQ("a.csv:1: error: the columns x and y are missing; name a data file of a run",
            refused("", "a.csv"));
  EXPECT_EQ("a.csv:2: error: a number is inf; the file is damaged",
            refused("x,y\n1,inf\n", "a.csv"));
  EXPECT_EQ("a.csv: error: the last line has no end; the file is cut off",
            refused("x,y\n1,2.", "a.csv"));
  EXPECT_EQ("a.csv:1: error: y is named twice; name every column once",
            refused("x,y,y\n", "a.csv"));
  EXPECT_EQ(
      "a.csv:2: error: an id, step or liquid is -1 and must be a whole number; the file is "
      "damaged",
      refused("x,y,id\n1,2,-1\n", "a.csv"));
  EXPECT_EQ("a.ply:3: error: its dimension is neither 2 nor 3; the file is damaged",
            refused("ply\nformat ascii 1.0\ncomment dimension 4\n", "a.ply"));
  EXPECT_EQ("a.ply:7: error: the column z is missing; the file is damaged",
            refused("ply\nformat ascii 1.0\ncomment dimension 3\nelement vertex 0\n"
                    "property float x\nproperty float y\nend_header\n",
                    "a.ply"));
  EXPECT_EQ("a.h5: error: not a whole HDF5 file; is it cut off, or of another kind?",
            refused("x,y\n1,2\n", "a.h5"));
  EXPECT_EQ("a.h5: error: not a whole HDF5 file; is it cut off, or of another kind?",
            refused("", "a.h5"));
}

TEST(ReadFrame, RejectsAMissingFileAndAFolder) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_frame(folder / "frame_0000.vtp"), Error);
  EXPECT_THROW(read_frame(folder.path()), Error);
  write_text(folder / "a.ply", encode_ply(sample_frame(2, 3)));
  expect_same(sample_frame(2, 3), read_frame(folder / "a.ply"));
}

TEST(FrameFiles, AreOfThePreferredFormatInOrder) {
  const TemporaryFolder folder;
  EXPECT_TRUE(frame_files(folder.path()).empty());
  const auto put = [&](const std::string& name) { write_text(folder / ("data/" + name), "x"); };
  const auto file = [&](const std::string& name, std::int64_t number) {
    return FrameFile{folder / ("data/" + name), number};
  };
  put("frame_0000.csv");
  EXPECT_EQ(std::vector{file("frame_0000.csv", 0)}, frame_files(folder.path()));
  for (const char* name : {"frame_10000.vtp", "frame_0002.vtp", "frame_9999.vtp", "frames.pvd",
                           "other.vtp", "frame_0001.ply", "frame_3.vtp", "frame_00004.vtp",
                           "frame_old.vtp", "frame_0005 (copy).vtp", "frame_-001.vtp"})
    put(name);
  EXPECT_EQ((std::vector{file("frame_0002.vtp", 2), file("frame_9999.vtp", 9999),
                         file("frame_10000.vtp", 10000)}),
            frame_files(folder.path()));
  put("frame_0003.h5");
  EXPECT_EQ(std::vector{file("frame_0003.h5", 3)}, frame_files(folder.path()));
}

// In the order of ids, as a run writes it.
TEST(ReadFrame, ReadsTheWhitewaterBesideIt) {
  TemporaryFolder folder;
  for (const int dimension : {2, 3})
    for (const DataFormat format : formats) {
      Frame frame = sample_frame(dimension, 3);
      WhitewaterFrame& w = frame.whitewater;
      w.id = {1, 5};
      w.kind = {0, 2};
      w.age = {0.25f, 1.5f};
      for (int k = 0; k < 2 * dimension; ++k) {
        w.x.push_back(0.5f * float(k));
        w.v.push_back(-0.25f * float(k));
      }
      const auto file = folder / data_file(format, 7);
      write_text(file, encode_points(format, table_of(frame, {})));
      EXPECT_EQ(read_frame(file).whitewater.size(), 0u);
      write_text(folder / whitewater_file(format, 7),
                 encode_points(format, whitewater_table(frame)));
      const Frame read = read_frame(file);
      expect_same(frame, read);
      EXPECT_EQ(w.id, read.whitewater.id);
      EXPECT_EQ(w.x, read.whitewater.x);
      EXPECT_EQ(w.v, read.whitewater.v);
      EXPECT_EQ(w.kind, read.whitewater.kind);
      EXPECT_EQ(w.age, read.whitewater.age);
      Frame other = frame;
      other.step = frame.step + 1;
      write_text(folder / whitewater_file(format, 7),
                 encode_points(format, whitewater_table(other)));
      EXPECT_THROW(read_frame(file), Error) << "of another step";
      std::filesystem::remove(folder / whitewater_file(format, 7));
    }
}

}  // namespace
}  // namespace freshet::test
