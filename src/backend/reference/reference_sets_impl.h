// SPDX-License-Identifier: MIT
/// The definitions of reference_sets.h. Included by the file that compiles them, and by tests.
#pragma once
#include <algorithm>
#include <utility>

#include "backend/reference/reference_sets.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D>
ReferenceSets<D>::ReferenceSets(Search search, NeighborOrder order)
    : search_(search), order_(order) {}
template <int D> ReferenceSets<D>::ReferenceSets(ReferenceSets&&) noexcept = default;
template <int D> ReferenceSets<D>::~ReferenceSets() = default;

template <int D>
void ReferenceSets<D>::add_set(Particles<D>& set, int n, typename Copies<D>::Rules rules) {
  set.n = n;
  set.set = int(copies_.size());
  copies_.emplace_back(std::move(rules));
  room_.push_back(n);
}

template <int D> void ReferenceSets<D>::add_field(const Particles<D>& set, FieldOfSet field) {
  Memory memory{set.set, field, {}, {}};
  memory.data = room_for(room_[std::size_t(set.set)], memory);
  field.point(field.field, memory.data.get());
  memory_.push_back(std::move(memory));
}
template <int D>
std::unique_ptr<std::byte[]> ReferenceSets<D>::room_for(int particles, const Memory& m) const {
  const std::size_t each = std::size_t(copies_[std::size_t(m.set)].room()) * m.field.bytes;
  return std::make_unique<std::byte[]>(std::size_t(particles) * each);
}

/// Moves the first n values of a field to memory for `room` particles. Returns the memory of
/// before.
template <int D> std::unique_ptr<std::byte[]> ReferenceSets<D>::move(Memory& m, int n, int room) {
  auto other = room_for(room, m);
  std::copy_n(m.data.get(), std::size_t(n) * m.field.bytes, other.get());
  std::swap(m.data, other);
  m.field.point(m.field.field, m.data.get());
  return other;
}
template <int D>
std::shared_ptr<const void> ReferenceSets<D>::keep(const Particles<D>& p, const void* data) {
  for (Memory& m : memory_)
    if (m.set == p.set && m.data.get() == data)
      return std::shared_ptr<std::byte[]>(move(m, p.n + p.copies, room_[std::size_t(p.set)]));
  return nullptr;
}

template <int D> void ReferenceSets<D>::save(const char* name, const Particles<D>& p) {
  const auto timer = timings_.time(name, p.n);
  for (Memory& m : memory_)
    if (m.set == p.set && m.field.keep == Keep::kept)
      m.saved.assign(m.data.get(), m.data.get() + std::size_t(p.n) * m.field.bytes);
}
template <int D> void ReferenceSets<D>::restore(const char* name, const Particles<D>& p) {
  const auto timer = timings_.time(name, p.n);
  for (Memory& m : memory_)
    if (m.set == p.set && m.field.keep == Keep::kept)
      std::copy(m.saved.begin(), m.saved.end(), m.data.get());
}

template <int D>
void ReferenceSets<D>::edit(const char* name, Particles<D>& p, std::span<const int> gone,
                            int more) {
  const auto timer = timings_.time(name, p.n);
  const int left = p.n - int(gone.size()), n = left + more;
  int& room = room_[std::size_t(p.set)];
  // All memory grows before anything changes, so that the fluid stays whole if memory runs out.
  if (n > room) {
    const int more_room = roomier(n, room);
    for (Memory& m : memory_)
      if (m.set == p.set) move(m, p.n, more_room);
    room = more_room;
  }
  for (Memory& m : memory_) {
    if (m.set != p.set) continue;
    const std::size_t bytes = m.field.bytes;
    close_gaps(m.data.get(), bytes, gone, p.n);
    std::fill_n(m.data.get() + std::size_t(left) * bytes, std::size_t(more) * bytes, std::byte(0));
  }
  p.n = n;
  p.copies = 0;
  copies_[std::size_t(p.set)].forget();
}

template <int D>
void ReferenceSets<D>::search(const char* name, Real support_radius, Particles<D>& moving,
                              std::initializer_list<const Particles<D>*> fixed) {
  const auto timer = timings_.time(name, moving.n);
  const Real reach = support_radius + moving.skin;
  if (moving.x_listed.data) follow(moving);
  Particles<D> listed = moving.as_listed();
  Copies<D>& copies = copies_[std::size_t(moving.set)];
  copies.make(listed, reach);
  copies.place(listed);
  remember_positions(listed);
  for (const Particles<D>* set : fixed)
    if (set->moves) remember_positions(*set);
  list(reach, listed, listed);
  for (const Particles<D>* set : fixed) list(reach, listed, *set);
  copies.place(moving);
}

/// Where a particle has left its lists, all are listed at their present positions.
template <int D> void ReferenceSets<D>::follow(const Particles<D>& p) {
  bool left = false;
  for (int i = 0; i < p.n; ++i) left |= p.left_its_lists(i);
  if (left) std::copy_n(p.x.data, p.n, p.x_listed.data);
}

template <int D>
void ReferenceSets<D>::list_neighbors(const char* name, Real support_radius,
                                      const Particles<D>& targets, const Particles<D>& sources) {
  const auto timer = timings_.time(name, targets.n);
  const bool known = std::size_t(targets.set) < searched_.size() &&
                     searched_[std::size_t(targets.set)].size() >= std::size_t(targets.n);
  if (targets.moves || !known) remember_positions(targets);
  Particles<D> target_positions = targets, source_positions = sources;
  target_positions.x.data = searched_[std::size_t(targets.set)].data();
  source_positions.x.data = searched_.at(std::size_t(sources.set)).data();
  list(support_radius + sources.skin, target_positions, source_positions);
}

template <int D> void ReferenceSets<D>::remember_positions(const Particles<D>& p) {
  searched_.resize(copies_.size());
  searched_[std::size_t(p.set)].assign(p.x.data, p.x.data + p.n + p.copies);
}

template <int D>
void ReferenceSets<D>::list(Real h, const Particles<D>& targets, const Particles<D>& sources) {
  if (targets.n == 0 || sources.n == 0) return;
  lists_[{targets.set, sources.set}].build(search_, order_, h, targets, sources);
}

}  // namespace FRESHET_ISA
}  // namespace freshet
