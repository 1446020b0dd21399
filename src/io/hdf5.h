// SPDX-License-Identifier: MIT
/// HDF5 files that are written and read in memory. write_file() then writes them, so that no
/// partial file is left.
#pragma once
#include <hdf5.h>

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace freshet {

/// A lock of the library, which is not thread-safe. It also disables the library's messages. A
/// thread may hold it several times.
class Hdf5Lock {
 public:
  Hdf5Lock();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

/// Initialises the library: it crashes if memory runs out while it does so, which is unlikely at
/// the start of a run. Throws Error (kind run) if it fails.
void start_hdf5();

/// An identifier of the library, closed by the destructor.
class Hdf5Handle {
 public:
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  hid_t get() const { return id_; }
  bool good() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// The stored format of floats: 4 bytes, or IEEE 754 binary16, to which the library rounds.
enum class Hdf5Float { single, half };

/// Writes a file in memory. Equal data gives equal bytes. Groups in a name ("fluid/x") are created.
/// With `columns` > 1 the data is a table. Throws Error (kind run) if the library fails, for
/// example out of memory.
class Hdf5Writer {
 public:
  Hdf5Writer();

  void write(const std::string& name, std::span<const float> values, std::size_t columns = 1,
             Hdf5Float stored = Hdf5Float::single);
  void write(const std::string& name, std::span<const double> values, std::size_t columns = 1);
  void write(const std::string& name, std::span<const std::int32_t> values,
             std::size_t columns = 1);
  void write(const std::string& name, std::span<const std::int64_t> values,
             std::size_t columns = 1);
  void write(const std::string& name, std::span<const std::uint64_t> values,
             std::size_t columns = 1);

  void write_text(const std::string& name, const std::string& text);

  /// Adds an attribute to the file if `name` is "/", else to the data set `name`.
  void attribute(const std::string& name, const std::string& key, double value);
  void attribute(const std::string& name, const std::string& key, std::int64_t value);
  void attribute(const std::string& name, const std::string& key, const std::string& value);

  /// The bytes of the file.
  std::string bytes();

 private:
  void write(const std::string& name, hid_t memory, hid_t stored, const void* values,
             std::size_t count, std::size_t columns);
  void attribute(const std::string& name, const std::string& key, hid_t memory, hid_t stored,
                 const void* value);

  Hdf5Lock lock_;
  Hdf5Handle file_;
};

/// Reads a file whose bytes are in memory. It opens no other file: soft and external links, data in
/// other files and filters that are plugins are rejected. All data read from it together take at
/// most 1032 times its bytes, the maximum expansion of deflate. Throws Error (kind scene) at
/// `place`, with the remedy.
class Hdf5Reader {
 public:
  Hdf5Reader(std::string_view bytes, std::string place);

  bool has(const std::string& name) const;
  /// The number of columns: 1 for a list.
  std::size_t columns(const std::string& name) const;
  /// Reads the numbers of a data set and converts them to the type of `values`.
  void read(const std::string& name, std::vector<float>& values) const;
  void read(const std::string& name, std::vector<double>& values) const;
  void read(const std::string& name, std::vector<std::int32_t>& values) const;
  void read(const std::string& name, std::vector<std::int64_t>& values) const;
  void read(const std::string& name, std::vector<std::uint64_t>& values) const;
  std::string read_text(const std::string& name) const;
  bool has_attribute(const std::string& name, const std::string& key) const;
  double number(const std::string& name, const std::string& key) const;
  std::int64_t integer(const std::string& name, const std::string& key) const;
  std::string text(const std::string& name, const std::string& key) const;

 private:
  void check_links(const std::string& name) const;
  Hdf5Handle open_data(const std::string& name, const char* kind) const;
  void check_storage(const std::string& name, hid_t data) const;
  void take_room(const std::string& name, std::size_t count, std::size_t bytes) const;
  template <class T> void read_as(const std::string& name, hid_t memory, std::vector<T>& v) const;
  void read_attribute(const std::string& name, const std::string& key, hid_t memory,
                      void* value) const;
  [[noreturn]] void fail(const std::string& why) const;

  Hdf5Lock lock_;
  std::string place_;
  Hdf5Handle file_;
  mutable std::size_t room_;  // bytes that may still be read
};

}  // namespace freshet
