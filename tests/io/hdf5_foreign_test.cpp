// SPDX-License-Identifier: MIT
// HDF5 files as other programs can make them: they must open no other file and take no memory
// beyond what their size allows.
#include <gtest/gtest.h>

#include <functional>

#include "cli/files.h"
#include "freshet/error.h"
#include "io/frame_files.h"
#include "io/hdf5.h"

namespace freshet::test {
namespace {

class ForeignHdf5 : public ::testing::Test {
 protected:
  using Properties = std::function<void(hid_t)>;

  /// An HDF5 file of that name that `fill` writes; returns its bytes.
  std::string file(const std::string& name, const std::function<void(hid_t)>& fill) {
    const Hdf5Lock lock;
    const Hdf5Handle made(
        H5Fcreate((folder_ / name).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    fill(made.get());
    H5Fflush(made.get(), H5F_SCOPE_GLOBAL);
    return read_text(folder_ / name);
  }
  /// Makes a table of rows × 2 floats. Without values, it takes no bytes in the file.
  static void table(hid_t to, const char* name, hsize_t rows, const Properties& set = {},
                    const std::vector<float>& values = {}) {
    const hsize_t extents[] = {rows, 2}, most[] = {H5S_UNLIMITED, 2};
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    if (set) set(creation.get());
    const bool grows = H5Pget_layout(creation.get()) == H5D_CHUNKED;
    const Hdf5Handle space(H5Screate_simple(2, extents, grows ? most : nullptr), H5Sclose);
    const Hdf5Handle data(
        H5Dcreate2(to, name, H5T_IEEE_F32LE, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
        H5Dclose);
    ASSERT_TRUE(data.good());
    if (values.empty()) return;
    const herr_t written =
        H5Dwrite(data.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    ASSERT_GE(written, 0);
  }
  static Properties chunked(hsize_t rows, const Properties& filter) {
    return [=](hid_t creation) {
      const hsize_t chunk[] = {rows, 2};
      H5Pset_chunk(creation, 2, chunk);
      filter(creation);
    };
  }
  static std::string refused(const std::string& bytes) {
    try {
      frame_in(bytes, "a.h5");
      return "read without an error";
    } catch (const Error& e) {
      return e.what();
    }
  }
  /// The message about a file with one table "position" of 4 × 2 numbers.
  std::string refused(const Properties& set) {
    return refused(file("a.h5", [&](hid_t f) { table(f, "position", 4, set, eight_); }));
  }

  TemporaryFolder folder_;
  const std::vector<float> eight_{1, 2, 3, 4, 5, 6, 7, 8};
};

TEST_F(ForeignHdf5, MayBeCompressedByGzip) {
  EXPECT_EQ("read without an error", refused(chunked(2, [](hid_t p) {
              H5Pset_shuffle(p);
              H5Pset_deflate(p, 9);
              H5Pset_fletcher32(p);
            })));
}

TEST_F(ForeignHdf5, IsRejectedWithALinkToAName) {
  const std::string other = (folder_ / "other.h5").string();
  file("other.h5", [&](hid_t f) { table(f, "position", 4, {}, eight_); });
  EXPECT_EQ(
      "a.h5: error: \"position\" is a link to another name or file; copy the data into this file",
      refused(file("a.h5", [&](hid_t f) {
        H5Lcreate_external(other.c_str(), "/position", f, "position", H5P_DEFAULT, H5P_DEFAULT);
      })));
  EXPECT_TRUE(contains(refused(file("a.h5",
                                    [&](hid_t f) {
                                      table(f, "real", 4, {}, eight_);
                                      H5Lcreate_soft("/real", f, "position", H5P_DEFAULT,
                                                     H5P_DEFAULT);
                                    })),
                       "is a link to another name"));
  const std::string group = file("a.h5", [&](hid_t f) {
    H5Lcreate_external(other.c_str(), "/", f, "fluid", H5P_DEFAULT, H5P_DEFAULT);
  });
  const Hdf5Reader reader(group, "a.h5");
  std::vector<float> values;
  EXPECT_THROW(reader.read("fluid/position", values), Error);
  EXPECT_THROW(reader.has_attribute("fluid/position", "unit"), Error);
  EXPECT_THROW(reader.read_text("fluid/position"), Error);
}

TEST_F(ForeignHdf5, IsRejectedWithDataInAnotherFile) {
  const std::string raw = (folder_ / "raw").string(), other = (folder_ / "other.h5").string();
  write_text(raw, std::string(32, '\1'));
  EXPECT_EQ("a.h5: error: the data of \"position\" are in another file; copy them into this file",
            refused(file("a.h5", [&](hid_t f) {
              table(f, "position", 4, [&](hid_t p) { H5Pset_external(p, raw.c_str(), 0, 32); });
            })));
  file("other.h5", [&](hid_t f) { table(f, "position", 4, {}, eight_); });
  EXPECT_TRUE(contains(
      refused(file("a.h5",
                   [&](hid_t f) {
                     table(f, "position", 4, [&](hid_t p) {
                       const hsize_t extents[] = {4, 2};
                       const Hdf5Handle space(H5Screate_simple(2, extents, nullptr), H5Sclose);
                       H5Pset_virtual(p, space.get(), other.c_str(), "/position", space.get());
                     });
                   })),
      "are in another file"));
}

TEST_F(ForeignHdf5, IsRejectedWithFiltersThatExpandWithoutBound) {
  const auto wrong = "\"position\" is compressed in an unknown way; save it with gzip";
  EXPECT_TRUE(contains(refused(chunked(2,
                                       [](hid_t p) {
                                         H5Pset_deflate(p, 9);
                                         H5Pset_deflate(p, 9);
                                       })),
                       wrong));
  EXPECT_TRUE(contains(
      refused(chunked(2, [](hid_t p) { H5Pset_scaleoffset(p, H5Z_SO_FLOAT_DSCALE, 2); })), wrong));
}

TEST_F(ForeignHdf5, TakesNoMoreMemoryThanItsSizeAllows) {
  const auto large = "\"position\" is larger than the file; it is damaged";
  // the bytes of a file with an unwritten table do not depend on its rows
  const auto with_rows = [&](hsize_t rows) {
    return file("a.h5", [=](hid_t f) { table(f, "position", rows); });
  };
  const std::size_t room = 1032 * with_rows(4).size();
  EXPECT_EQ("read without an error", refused(with_rows(room / 8)));
  EXPECT_TRUE(contains(refused(with_rows(room / 8 + 1)), large));
  EXPECT_TRUE(contains(refused(with_rows(hsize_t(1) << 40)), large));
  // two names of one table
  const auto twice = [&](hsize_t rows) {
    return file("a.h5", [=](hid_t f) {
      table(f, "position", rows);
      H5Lcreate_hard(f, "position", f, "velocity", H5P_DEFAULT, H5P_DEFAULT);
    });
  };
  EXPECT_EQ("read without an error", refused(twice(room / 16)));
  EXPECT_TRUE(contains(refused(twice(room / 8)), "\"velocity\" is larger than the file"));
  // a chunk is decompressed as a whole
  const Properties set = chunked(hsize_t(1) << 28, [](hid_t p) { H5Pset_deflate(p, 9); });
  EXPECT_TRUE(
      contains(refused(file("a.h5", [&](hid_t f) { table(f, "position", 4, set); })), large));
}

TEST_F(ForeignHdf5, IsRejectedWithSeveralTextsInPlaceOfOne) {
  const std::string bytes = file("a.h5", [](hid_t f) {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), 4);
    const hsize_t many = 100;
    const Hdf5Handle space(H5Screate_simple(1, &many, nullptr), H5Sclose);
    const Hdf5Handle data(
        H5Dcreate2(f, "scene.toml", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
  });
  const Hdf5Reader reader(bytes, "a.h5");
  EXPECT_THROW(reader.read_text("scene.toml"), Error);
}

}  // namespace
}  // namespace freshet::test
