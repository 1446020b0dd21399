// SPDX-License-Identifier: MIT
#include "io/hdf5.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "freshet/error.h"

namespace freshet {
namespace {

constexpr std::size_t increment = 1 << 16;   // by which a file in memory grows [bytes]
constexpr std::size_t most_deflated = 1032;  // maximum expansion of a byte by deflate
// The name of files that exist in memory only. HDF5 opens none whose name a file has, in the
// working directory for example; no file can have this one.
constexpr const char* in_memory = "/dev/null/freshet";

std::recursive_mutex& library() {
  static std::recursive_mutex mutex;
  return mutex;
}

void require(bool good) {
  if (!good)
    throw Error(Error::Kind::run, "",
                "HDF5 cannot make a file, probably as memory is short; free memory, or make "
                "particles.spacing larger");
}

/// Throws std::bad_alloc if there is not so much memory, and some more. HDF5 itself may crash where
/// a small piece of memory is missing.
void require_memory(std::size_t bytes) {
  constexpr std::size_t more = 4 << 20;
  void* volatile memory = ::operator new(bytes + more);
  ::operator delete(memory);
}

/// Access to files that exist in memory only.
Hdf5Handle access_in_memory() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(access.good() && H5Pset_fapl_core(access.get(), increment, false) >= 0);
  return access;
}

hid_t create_file() {
  const Hdf5Handle access = access_in_memory();
  const hid_t file = H5Fcreate(in_memory, H5F_ACC_TRUNC, H5P_DEFAULT, access.get());
  require(file >= 0);
  return file;
}

/// Opens the bytes of a file. Returns a negative number if they are not an HDF5 file.
hid_t open_file(std::string_view bytes) {
  const Hdf5Handle access = access_in_memory();
  if (bytes.empty()) return -1;
  void* image = const_cast<char*>(bytes.data());  // copied, never written
  require(H5Pset_file_image(access.get(), image, bytes.size()) >= 0);
  return H5Fopen(in_memory, H5F_ACC_RDONLY, access.get());
}

/// IEEE 754 binary16: 1 sign bit, 5 exponent bits, 10 mantissa bits.
Hdf5Handle half_type() {
  Hdf5Handle type(H5Tcopy(H5T_IEEE_F32LE), H5Tclose);
  require(type.good() && H5Tset_fields(type.get(), 15, 10, 5, 0, 10) >= 0 &&
          H5Tset_size(type.get(), 2) >= 0 && H5Tset_ebias(type.get(), 15) >= 0);
  return type;
}

/// Creates a data set and the groups in its name. Without timestamps the bytes are reproducible.
Hdf5Handle make_data(const Hdf5Handle& file, const std::string& name, hid_t type,
                     const Hdf5Handle& space) {
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  require(links.good() && H5Pset_create_intermediate_group(links.get(), 1) >= 0);
  require(creation.good() && H5Pset_obj_track_times(creation.get(), false) >= 0);
  Hdf5Handle data(H5Dcreate2(file.get(), name.c_str(), type, space.get(), links.get(),
                             creation.get(), H5P_DEFAULT),
                  H5Dclose);
  require(data.good());
  return data;
}

Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(type.good() && H5Tset_size(type.get(), size + 1) >= 0 &&
          H5Tset_cset(type.get(), H5T_CSET_UTF8) >= 0);
  return type;
}

}  // namespace

Hdf5Lock::Hdf5Lock() : lock_(library()) {
  require_memory(0);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void start_hdf5() {
  const Hdf5Lock lock;
  require(H5open() >= 0);
}

Hdf5Writer::Hdf5Writer() : file_(create_file(), H5Fclose) {}

void Hdf5Writer::write(const std::string& name, hid_t memory, hid_t stored, const void* values,
                       std::size_t count, std::size_t columns) {
  require_memory(2 * sizeof(double) * count);  // the file in memory, and its growth
  const hsize_t extents[] = {count / columns, columns};
  const Hdf5Handle space(H5Screate_simple(columns > 1 ? 2 : 1, extents, nullptr), H5Sclose);
  require(space.good());
  const Hdf5Handle data = make_data(file_, name, stored, space);
  if (count > 0) require(H5Dwrite(data.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
}

void Hdf5Writer::write(const std::string& name, std::span<const float> values, std::size_t columns,
                       Hdf5Float stored) {
  if (stored == Hdf5Float::single)
    return write(name, H5T_NATIVE_FLOAT, H5T_IEEE_F32LE, values.data(), values.size(), columns);
  const Hdf5Handle half = half_type();
  write(name, H5T_NATIVE_FLOAT, half.get(), values.data(), values.size(), columns);
}
void Hdf5Writer::write(const std::string& name, std::span<const double> values,
                       std::size_t columns) {
  write(name, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, values.data(), values.size(), columns);
}
void Hdf5Writer::write(const std::string& name, std::span<const std::int32_t> values,
                       std::size_t columns) {
  write(name, H5T_NATIVE_INT32, H5T_STD_I32LE, values.data(), values.size(), columns);
}
void Hdf5Writer::write(const std::string& name, std::span<const std::int64_t> values,
                       std::size_t columns) {
  write(name, H5T_NATIVE_INT64, H5T_STD_I64LE, values.data(), values.size(), columns);
}
void Hdf5Writer::write(const std::string& name, std::span<const std::uint64_t> values,
                       std::size_t columns) {
  write(name, H5T_NATIVE_UINT64, H5T_STD_U64LE, values.data(), values.size(), columns);
}

void Hdf5Writer::write_text(const std::string& name, const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  require(space.good());
  const Hdf5Handle data = make_data(file_, name, type.get(), space);
  require(H5Dwrite(data.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0);
}

void Hdf5Writer::attribute(const std::string& name, const std::string& key, hid_t memory,
                           hid_t stored, const void* value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  require(space.good());
  const Hdf5Handle attribute(H5Acreate_by_name(file_.get(), name.c_str(), key.c_str(), stored,
                                               space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  require(attribute.good() && H5Awrite(attribute.get(), memory, value) >= 0);
}

void Hdf5Writer::attribute(const std::string& name, const std::string& key, double value) {
  attribute(name, key, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, &value);
}
void Hdf5Writer::attribute(const std::string& name, const std::string& key, std::int64_t value) {
  attribute(name, key, H5T_NATIVE_INT64, H5T_STD_I64LE, &value);
}
void Hdf5Writer::attribute(const std::string& name, const std::string& key,
                           const std::string& value) {
  const Hdf5Handle type = text_type(value.size());
  attribute(name, key, type.get(), type.get(), value.c_str());
}

std::string Hdf5Writer::bytes() {
  require(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0);
  const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
  require(size > 0);
  std::string all(std::size_t(size), '\0');
  require(H5Fget_file_image(file_.get(), all.data(), all.size()) == size);
  return all;
}

Hdf5Reader::Hdf5Reader(std::string_view bytes, std::string place)
    : place_(std::move(place)),
      file_(open_file(bytes), H5Fclose),
      room_(bytes.size() * most_deflated) {
  if (!file_.good()) fail("not a whole HDF5 file; is it cut off, or of another kind?");
}

void Hdf5Reader::fail(const std::string& why) const {
  throw Error(Error::Kind::scene, place_, why);
}

bool Hdf5Reader::has(const std::string& name) const {
  return H5Lexists(file_.get(), name.c_str(), H5P_DEFAULT) > 0;
}

namespace {

/// The extents of a list or a table; empty for any other object.
std::vector<hsize_t> extents_of(hid_t data) {
  const Hdf5Handle space(H5Dget_space(data), H5Sclose);
  const int rank = space.good() ? H5Sget_simple_extent_ndims(space.get()) : -1;
  if (rank != 1 && rank != 2) return {};
  std::vector<hsize_t> extents(std::size_t(rank), 0);
  H5Sget_simple_extent_dims(space.get(), extents.data(), nullptr);
  return extents;
}

bool holds_numbers(hid_t data) {
  const Hdf5Handle type(H5Dget_type(data), H5Tclose);
  if (!type.good()) return false;
  const H5T_class_t kind = H5Tget_class(type.get());
  return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

}  // namespace

/// Fails if a part of the path is a link to a name, which may be in another file.
void Hdf5Reader::check_links(const std::string& name) const {
  for (std::size_t end = 0; end != std::string::npos;) {
    end = name.find('/', end + 1);
    const std::string part = name.substr(0, end);
    H5L_info_t link;
    if (part.empty() || part == "/") continue;
    if (H5Lget_info(file_.get(), part.c_str(), &link, H5P_DEFAULT) < 0) return;  // it is missing
    if (link.type != H5L_TYPE_HARD)
      fail(fmt::format("\"{}\" is a link to another name or file; copy the data into this file",
                       part));
  }
}

/// Fails if the data are in another file, or need a filter that does more than deflate.
void Hdf5Reader::check_storage(const std::string& name, hid_t data) const {
  const Hdf5Handle creation(H5Dget_create_plist(data), H5Pclose);
  const H5D_layout_t layout = creation.good() ? H5Pget_layout(creation.get()) : H5D_LAYOUT_ERROR;
  if (layout == H5D_LAYOUT_ERROR || layout == H5D_VIRTUAL ||
      (layout == H5D_CONTIGUOUS && H5Pget_external_count(creation.get()) != 0))
    fail(fmt::format("the data of \"{}\" are in another file; copy them into this file", name));
  int deflated = 0;
  for (int k = 0; k < H5Pget_nfilters(creation.get()); ++k) {
    unsigned flags = 0, settings = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(creation.get(), unsigned(k), &flags, &values,
                                               nullptr, 0, nullptr, &settings);
    deflated += filter == H5Z_FILTER_DEFLATE;
    const bool known = filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_SHUFFLE ||
                       filter == H5Z_FILTER_FLETCHER32;
    if (!known || deflated > 1)
      fail(
          fmt::format("\"{}\" is compressed in an unknown way; save it with gzip, or without "
                      "compression",
                      name));
  }
  if (layout != H5D_CHUNKED) return;
  hsize_t extents[2] = {1, 1};  // the library has memory for a whole chunk
  const Hdf5Handle type(H5Dget_type(data), H5Tclose);
  const int rank = H5Pget_chunk(creation.get(), 2, extents);
  const std::size_t bytes = type.good() ? H5Tget_size(type.get()) : 0;
  if (rank < 1 || rank > 2 || bytes == 0 ||
      extents[0] > room_ / bytes / std::max<hsize_t>(1, extents[1]))
    fail(fmt::format("\"{}\" is larger than the file; it is damaged", name));
}

/// Counts data that are about to be read, and fails if they are too large to be in the file.
void Hdf5Reader::take_room(const std::string& name, std::size_t count, std::size_t bytes) const {
  if (bytes == 0 || count > room_ / bytes)
    fail(fmt::format("\"{}\" is larger than the file; it is damaged", name));
  room_ -= count * bytes;
}

/// Opens data and checks where they are; `kind` is for the message.
Hdf5Handle Hdf5Reader::open_data(const std::string& name, const char* kind) const {
  check_links(name);
  Hdf5Handle data(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.good())
    fail(fmt::format("there is no {} \"{}\" in it; is it the right file?", kind, name));
  check_storage(name, data.get());
  return data;
}

std::size_t Hdf5Reader::columns(const std::string& name) const {
  constexpr const char* kind = "list or table";
  const auto extents = extents_of(open_data(name, kind).get());
  if (extents.empty())
    fail(fmt::format("there is no {} \"{}\" in it; is it the right file?", kind, name));
  return extents.size() == 2 ? extents[1] : 1;
}

template <class T>
void Hdf5Reader::read_as(const std::string& name, hid_t memory, std::vector<T>& v) const {
  const std::size_t per = columns(name);
  const Hdf5Handle data = open_data(name, "list or table");
  if (!holds_numbers(data.get()))
    fail(fmt::format("\"{}\" does not hold numbers; is it the right file?", name));
  const std::size_t rows = extents_of(data.get())[0];
  const Hdf5Handle type(H5Dget_type(data.get()), H5Tclose);
  const std::size_t bytes = std::max(sizeof(T), H5Tget_size(type.get()));
  if (per > 0 && rows > room_ / per)
    fail(fmt::format("\"{}\" is larger than the file; it is damaged", name));
  take_room(name, rows * per, bytes);
  v.resize(rows * per);
  if (v.empty()) return;
  if (H5Dread(data.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, v.data()) < 0)
    fail(fmt::format("\"{}\" cannot be read; the file is damaged or cut off", name));
}

void Hdf5Reader::read(const std::string& name, std::vector<float>& v) const {
  read_as(name, H5T_NATIVE_FLOAT, v);
}
void Hdf5Reader::read(const std::string& name, std::vector<double>& v) const {
  read_as(name, H5T_NATIVE_DOUBLE, v);
}
void Hdf5Reader::read(const std::string& name, std::vector<std::int32_t>& v) const {
  read_as(name, H5T_NATIVE_INT32, v);
}
void Hdf5Reader::read(const std::string& name, std::vector<std::int64_t>& v) const {
  read_as(name, H5T_NATIVE_INT64, v);
}
void Hdf5Reader::read(const std::string& name, std::vector<std::uint64_t>& v) const {
  read_as(name, H5T_NATIVE_UINT64, v);
}

std::string Hdf5Reader::read_text(const std::string& name) const {
  const Hdf5Handle data = open_data(name, "text");
  const Hdf5Handle type(H5Dget_type(data.get()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(data.get()), H5Sclose);
  const bool is_text = type.good() && H5Tget_class(type.get()) == H5T_STRING &&
                       H5Tis_variable_str(type.get()) == 0 && space.good() &&
                       H5Sget_simple_extent_npoints(space.get()) == 1;
  if (!is_text) fail(fmt::format("there is no text \"{}\" in it; is it the right file?", name));
  take_room(name, 1, H5Tget_size(type.get()));
  std::string text(H5Tget_size(type.get()), '\0');
  if (H5Dread(data.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
    fail(fmt::format("\"{}\" cannot be read; the file is damaged or cut off", name));
  return text.substr(0, text.find('\0'));
}

bool Hdf5Reader::has_attribute(const std::string& name, const std::string& key) const {
  check_links(name);
  return H5Aexists_by_name(file_.get(), name.c_str(), key.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5Reader::read_attribute(const std::string& name, const std::string& key, hid_t memory,
                                void* value) const {
  check_links(name);
  const Hdf5Handle attribute(
      H5Aopen_by_name(file_.get(), name.c_str(), key.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle space(attribute.good() ? H5Aget_space(attribute.get()) : -1, H5Sclose);
  if (!space.good() || H5Sget_simple_extent_npoints(space.get()) != 1 ||
      H5Aread(attribute.get(), memory, value) < 0)
    fail(fmt::format("there is no \"{}\" in it that can be read; is it the right file?", key));
}

double Hdf5Reader::number(const std::string& name, const std::string& key) const {
  double value = 0;
  read_attribute(name, key, H5T_NATIVE_DOUBLE, &value);
  return value;
}

std::int64_t Hdf5Reader::integer(const std::string& name, const std::string& key) const {
  std::int64_t value = 0;
  read_attribute(name, key, H5T_NATIVE_INT64, &value);
  return value;
}

std::string Hdf5Reader::text(const std::string& name, const std::string& key) const {
  constexpr std::size_t longest = 1 << 20;
  check_links(name);
  const Hdf5Handle attribute(
      H5Aopen_by_name(file_.get(), name.c_str(), key.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(attribute.good() ? H5Aget_type(attribute.get()) : -1, H5Tclose);
  const bool is_text = type.good() && H5Tget_class(type.get()) == H5T_STRING &&
                       H5Tis_variable_str(type.get()) == 0 && H5Tget_size(type.get()) <= longest;
  std::string value(is_text ? H5Tget_size(type.get()) : 0, '\0');
  if (!is_text) fail(fmt::format("there is no text \"{}\" in it; is it the right file?", key));
  read_attribute(name, key, type.get(), value.data());
  return value.substr(0, value.find('\0'));
}

}  // namespace freshet
