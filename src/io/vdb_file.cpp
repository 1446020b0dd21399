// SPDX-License-Identifier: MIT
#include "io/vdb_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>

#include "core/sha256.h"

namespace freshet {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they stand");

constexpr int upper_log = 5, lower_log = 4;  // edge of a node in children, as powers of 2
constexpr int lower_blocks = 1 << lower_log, upper_blocks = lower_blocks << upper_log;
constexpr std::uint32_t mask_compression = 2;
/// How the inactive values of a node are stored.
constexpr char all_background = 0, mask_of_background = 3;

class Bytes {
 public:
  template <class T> void put(T value) {
    all.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const std::string& value) {
    put(std::uint32_t(value.size()));
    all += value;
  }
  /// An entry of the metadata of a file or a grid.
  template <class T> void entry(const char* name, const char* type, const T& value) {
    text(name);
    text(type);
    put(std::uint32_t(sizeof value));
    put(value);
  }
  void entry(const char* name, const std::string& value) {
    text(name);
    text("string");
    text(value);
  }
  std::string all;
};

/// The bits of the children or values of a node.
template <int count> struct Mask {
  std::array<std::uint64_t, std::size_t(count) / 64> words{};
  void set(int k) { words[std::size_t(k) / 64] |= std::uint64_t(1) << (k % 64); }
  bool has(int k) const { return words[std::size_t(k) / 64] >> (k % 64) & 1; }
  void write(Bytes& out) const {
    for (const std::uint64_t word : words) out.put(word);
  }
};

/// Where a block is in the tree.
struct Leaf {
  Place root;        ///< of the upper node, in upper nodes
  int upper, lower;  ///< index of the lower node in the upper one, of the block in the lower one
  int block;         ///< index in VdbGrid::blocks; -1: a block inside
  auto key() const { return std::tuple(root.x, root.y, root.z, upper, lower); }
  bool same_upper(const Leaf& o) const {
    return root.x == o.root.x && root.y == o.root.y && root.z == o.root.z;
  }
};

/// The index of a child in its node; z is fastest.
constexpr int child_index(Place p, int log) {
  const int mask = (1 << log) - 1;
  return ((p.x & mask) << log | (p.y & mask)) << log | (p.z & mask);
}
Place divided(Place p, int by) {
  return {floor_div(p.x, by), floor_div(p.y, by), floor_div(p.z, by)};
}

std::vector<Leaf> leaves_of(const VdbGrid& grid) {
  std::vector<Leaf> leaves;
  const auto add = [&](Place p, int block) {
    leaves.push_back({divided(p, upper_blocks), child_index(divided(p, lower_blocks), upper_log),
                      child_index(p, lower_log), block});
  };
  for (std::size_t k = 0; k < grid.blocks.size(); ++k) add(grid.blocks[k].place, int(k));
  for (const Place& p : grid.inside) add(p, -1);
  std::sort(leaves.begin(), leaves.end(),
            [](const Leaf& a, const Leaf& b) { return a.key() < b.key(); });
  return leaves;
}

/// Writes the tree of a grid: nodes first, then the values of the blocks.
class TreeWriter {
 public:
  TreeWriter(const VdbGrid& grid, Bytes& out) : grid_(grid), out_(out), leaves_(leaves_of(grid)) {
    for (const VdbGrid::Block& block : grid.blocks) active_.push_back(active_points(block));
  }
  void write_nodes() {
    out_.put(std::uint32_t(1));  // buffers per block
    for (int k = 0; k < grid_.components; ++k) out_.put(grid_.scale * grid_.background);
    out_.put(std::uint32_t(0));  // tiles of the root
    const auto next_upper = [&](std::size_t from) {
      while (from < leaves_.size() && leaves_[from].same_upper(leaves_[start_])) ++from;
      return from;
    };
    std::uint32_t count = 0;
    for (start_ = 0; start_ < leaves_.size(); start_ = next_upper(start_)) ++count;
    out_.put(count);
    for (start_ = 0; start_ < leaves_.size();) {
      const std::size_t end = next_upper(start_);
      write_upper(start_, end);
      start_ = end;
    }
  }
  void write_values() {
    for (const Leaf& leaf : leaves_)
      if (leaf.block >= 0) write_block(std::size_t(leaf.block));
  }

 private:
  using BlockMask = Mask<block_points>;

  /// The index of a point in OpenVDB's order, in which z is fastest, to ours.
  static std::size_t ours(int k) {
    return std::size_t(point_index(k / (block_cells * block_cells), k / block_cells % block_cells,
                                   k % block_cells));
  }
  BlockMask active_points(const VdbGrid::Block& block) const {
    BlockMask mask;
    for (int k = 0; k < block_points; ++k)
      for (int c = 0; c < grid_.components; ++c)
        if (block.active ? block.active[ours(k)] != 0
                         : std::abs(block.values[c][ours(k)]) != grid_.background)
          mask.set(k);
    return mask;
  }
  void write_upper(std::size_t first, std::size_t end) {
    const Leaf& any = leaves_[first];
    constexpr int edge = upper_blocks * block_cells;
    for (const int k : {any.root.x, any.root.y, any.root.z}) out_.put(std::int32_t(edge * k));
    Mask<1 << (3 * upper_log)> children;
    for (std::size_t k = first; k < end; ++k) children.set(leaves_[k].upper);
    children.write(out_);
    decltype(children){}.write(out_);  // active tiles
    out_.put(all_background);
    for (std::size_t k = first; k < end;) {
      std::size_t next = k;
      while (next < end && leaves_[next].upper == leaves_[k].upper) ++next;
      write_lower(k, next);
      k = next;
    }
  }
  void write_lower(std::size_t first, std::size_t end) {
    Mask<1 << (3 * lower_log)> children, outside;
    for (std::uint64_t& word : outside.words) word = ~std::uint64_t(0);
    bool has_inside = false;
    for (std::size_t k = first; k < end; ++k) {
      if (leaves_[k].block >= 0) children.set(leaves_[k].lower);
      else {
        outside.words[std::size_t(leaves_[k].lower) / 64] &=
            ~(std::uint64_t(1) << (leaves_[k].lower % 64));
        has_inside = true;
      }
    }
    children.write(out_);
    decltype(children){}.write(out_);  // active tiles
    out_.put(has_inside ? mask_of_background : all_background);
    if (has_inside) outside.write(out_);
    for (std::size_t k = first; k < end; ++k)
      if (leaves_[k].block >= 0) active_[std::size_t(leaves_[k].block)].write(out_);
  }
  void write_block(std::size_t block) {
    const VdbGrid::Block& of = grid_.blocks[block];
    const BlockMask& active = active_[block];
    active.write(out_);
    BlockMask outside;
    bool has_inside = false;
    for (int k = 0; k < block_points; ++k)
      if (active.has(k) || of.values[0][ours(k)] >= 0) outside.set(k);
      else has_inside = true;
    out_.put(has_inside ? mask_of_background : all_background);
    if (has_inside) outside.write(out_);
    for (int k = 0; k < block_points; ++k)
      if (active.has(k))
        for (int c = 0; c < grid_.components; ++c) write_value(grid_.scale * of.values[c][ours(k)]);
  }
  void write_value(float value) {
    if (grid_.half) out_.put(half_float(value));
    else out_.put(value);
  }

  const VdbGrid& grid_;
  Bytes& out_;
  std::vector<Leaf> leaves_;
  std::vector<BlockMask> active_;
  std::size_t start_ = 0;
};

void write_transform(Bytes& out, const double (&origin)[3], double cell) {
  out.text("UniformScaleTranslateMap");
  for (const double x : origin) out.put(x);
  for (const double x : {cell, cell, 1 / cell, 1 / (cell * cell), 1 / (2 * cell)})
    for (int k = 0; k < 3; ++k) out.put(x);
}

void write_grid(Bytes& out, const VdbGrid& grid, const double (&origin)[3], double cell,
                std::size_t shift) {
  constexpr const char* classes[] = {"level set", "fog volume", "unknown"};
  out.text(grid.name);
  out.text(fmt::format("Tree_{}_5_4_3{}", grid.components == 3 ? "vec3s" : "float",
                       grid.half ? "_HalfFloat" : ""));
  out.text("");  // no other grid has this tree
  const std::size_t places = out.all.size();
  for (int k = 0; k < 3; ++k) out.put(std::int64_t(0));
  std::int64_t place[3];  // of the grid, of its values, of its end
  const auto here = [&] { return std::int64_t(out.all.size() + shift); };
  place[0] = here();
  out.put(mask_compression);
  out.put(std::uint32_t(grid.components == 3 ? 4 : 3));
  out.entry("class", classes[int(grid.kind)]);
  out.entry("is_saved_as_half_float", "bool", grid.half);
  out.entry("name", grid.name);
  if (grid.components == 3) out.entry("vector_type", "contravariant relative");
  write_transform(out, origin, cell);
  TreeWriter tree(grid, out);
  tree.write_nodes();
  place[1] = here();
  tree.write_values();
  place[2] = here();
  out.all.replace(places, sizeof place, reinterpret_cast<const char*>(place), sizeof place);
}

/// A UUID: OpenVDB takes two files with the same one for the same file.
std::string uuid_of(const std::string& bytes) {
  Sha256 digest;
  digest.add(bytes.data(), bytes.size());
  const std::string hex = digest.hex();
  return fmt::format("{}-{}-{}-{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(12, 4),
                     hex.substr(16, 4), hex.substr(20, 12));
}

}  // namespace

std::uint16_t half_float(float number) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  const auto sign = std::uint16_t(bits >> 16 & 0x8000);
  const float size = std::abs(number);
  if (!(size < 65520)) return sign | 0x7BFF;
  if (size < 6.103515625e-5f)  // subnormal: a multiple of 2^-24
    return std::uint16_t(sign | std::uint16_t(std::nearbyint(size * 16777216.0f)));
  const std::uint32_t rounded = (bits & 0x7FFFFFFF) + 0xFFF + (bits >> 13 & 1);
  return std::uint16_t(sign | std::uint16_t((rounded - (112u << 23)) >> 13));
}

std::string encode_vdb(const std::vector<VdbGrid>& grids, const double (&origin)[3], double cell,
                       double time, std::int64_t step) {
  Bytes head;
  head.put(std::int64_t(0x56444220));  // "VDB "
  head.put(std::uint32_t(224));        // version of the format
  head.put(std::uint32_t(10));         // the OpenVDB that writes it
  head.put(std::uint32_t(0));
  head.put(char(1));  // grids have their places
  constexpr std::size_t uuid_length = 36;
  const std::size_t shift = head.all.size() + uuid_length;
  Bytes body;
  body.put(std::uint32_t(3));
  body.entry("creator", "Freshet");
  body.entry("time", "double", time);
  body.entry("step", "int64", step);
  body.put(std::int32_t(grids.size()));
  for (const VdbGrid& grid : grids) write_grid(body, grid, origin, cell, shift);
  return head.all + uuid_of(body.all) + body.all;
}

}  // namespace freshet
