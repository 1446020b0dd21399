// SPDX-License-Identifier: MIT
/// The definitions of cpu_sets.h. Included by the file that compiles them, and by tests.
#pragma once
#include <atomic>
#include <cstring>
#include <utility>

#include "backend/cpu/cpu_sets.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> CpuSets<D>::CpuSets(int threads) : threads_(threads) {}
template <int D> CpuSets<D>::CpuSets(CpuSets&&) noexcept = default;
template <int D> CpuSets<D>::~CpuSets() = default;

template <int D>
void CpuSets<D>::add_set(Particles<D>& set, int n, typename Copies<D>::Rules rules) {
  set.n = n;
  set.set = int(sets_.size());
  sets_.push_back(std::make_unique<Set>(std::move(rules)));
  sets_.back()->room = n;
}

template <int D> void CpuSets<D>::add_field(const Particles<D>& set, FieldOfSet field) {
  Memory& m = of(set).memory.emplace_back();
  m.field = field;
  m.field.point(m.field.field, m.data.reserve(bytes_for(of(set).room, of(set), m)));
  clear(m, 0, set.n + lanes);
}

template <int D> std::size_t CpuSets<D>::bytes_for(int room, const Set& set, const Memory& m) {
  return (std::size_t(room) * std::size_t(set.copies.room()) + lanes) * m.field.bytes;
}
/// Moves the first n values of a field to memory of this size. Returns the memory of before.
template <int D> Buffer<std::byte> CpuSets<D>::move(Memory& m, int n, std::size_t bytes) {
  Buffer<std::byte> other;
  other.reserve(bytes);
  threads_.blocks(n, [&](int b, int e) {
    const std::size_t first = std::size_t(b) * m.field.bytes;
    std::memcpy(other.get() + first, m.data.get() + first, std::size_t(e - b) * m.field.bytes);
  });
  std::swap(m.data, other);
  m.field.point(m.field.field, m.data.get());
  return other;
}
template <int D>
std::shared_ptr<const void> CpuSets<D>::keep(const Particles<D>& p, const void* data) {
  const Set& set = of(p);
  for (Memory& m : of(p).memory) {
    if (m.data.get() != data) continue;
    auto kept = std::make_shared<Buffer<std::byte>>();
    *kept = move(m, p.n + p.copies + lanes, bytes_for(set.room, set, m));
    return kept;
  }
  return nullptr;
}
/// Zeroes a range in parallel, so that each thread first touches the pages that it will use.
template <int D> void CpuSets<D>::clear(Memory& m, int begin, int end) {
  threads_.blocks(end - begin, [&](int b, int e) {
    std::memset(m.data.get() + std::size_t(begin + b) * m.field.bytes, 0,
                std::size_t(e - b) * m.field.bytes);
  });
}

template <int D> void CpuSets<D>::copy_kept(const char* name, const Particles<D>& p, bool save) {
  const auto timer = timings_.time(name, p.n);
  if (!save) of(p).sorted = false;
  for (Memory& m : of(p).memory) {
    if (m.field.keep != Keep::kept) continue;
    const std::size_t bytes = m.field.bytes;
    std::byte *saved = m.saved.reserve(std::size_t(p.n) * bytes), *data = m.data.get();
    threads_.blocks(p.n, [&](int b, int e) {
      const std::size_t first = std::size_t(b) * bytes;
      std::memcpy((save ? saved : data) + first, (save ? data : saved) + first,
                  std::size_t(e - b) * bytes);
    });
  }
}

template <int D>
void CpuSets<D>::edit(const char* name, Particles<D>& p, std::span<const int> gone, int more) {
  const auto timer = timings_.time(name, p.n);
  Set& set = of(p);
  const int left = p.n - int(gone.size()), n = left + more;
  // All memory grows before anything changes, so that the fluid stays whole if memory runs out.
  if (n > set.room) {
    const int room = roomier(n, set.room);
    for (Memory& m : set.memory) move(m, p.n, bytes_for(room, set, m));
    set.room = room;
  }
  for (Memory& m : set.memory) {
    fill_gaps(m.data.get(), m.field.bytes, gone, p.n);
    clear(m, left, n + lanes);
  }
  p.n = n;
  p.copies = 0;
  set.copies.forget();
  set.sorted = false;
}

template <int D>
void CpuSets<D>::search(const char* name, Real support_radius, Particles<D>& moving,
                        std::initializer_list<const Particles<D>*> fixed) {
  const auto timer = timings_.time(name, moving.n);
  const Real reach = support_radius + moving.skin;
  if (must_sort(moving)) {
    Particles<D> listed = moving.as_listed();
    sort(reach, listed);
    copy(reach, listed);
    moving.copies = listed.copies;
  }
  if (moving.x_listed.data) of(moving).copies.place(moving);
  for (const Particles<D>* set : fixed) sort_if_needed(reach, *set);
  list(reach, moving, moving);
  for (const Particles<D>* set : fixed) list(reach, moving, *set);
}

/// Where a particle has left its lists, all are listed at their present positions.
template <int D> bool CpuSets<D>::must_sort(const Particles<D>& p) const {
  if (!p.x_listed.data) return true;
  std::atomic<bool> left = false;
  threads_.blocks(p.n, [&](int b, int e) {
    bool any = false;
    for (int i = b; i < e; ++i) any |= p.left_its_lists(i);
    if (any) left = true;
  });
  if (left)
    threads_.blocks(p.n, [&](int b, int e) {
      for (int i = b; i < e; ++i) p.x_listed[i] = p.x[i];
    });
  return left || !sets_[std::size_t(p.set)]->sorted;
}

template <int D>
void CpuSets<D>::list_neighbors(const char* name, Real support_radius, const Particles<D>& targets,
                                const Particles<D>& sources) {
  const auto timer = timings_.time(name, targets.n);
  const Real reach = support_radius + sources.skin;
  sort_if_needed(reach, targets);
  list(reach, targets, sources);
}

template <int D>
template <class T>
void CpuSets<D>::share_blocks(const Particles<D>& p, Field<T> field) {
  const auto timer = timings_.time("share", p.copies);
  const Copies<D>& copies = of(p).copies;
  threads_.blocks(p.copies, [&](int b, int e) { copies.share(p, field, b, e); });
}
template <int D> void CpuSets<D>::share_field(const Particles<D>& p, Field<Real> field) {
  share_blocks(p, field);
}
template <int D> void CpuSets<D>::share_field(const Particles<D>& p, Field<int> field) {
  share_blocks(p, field);
}
template <int D> void CpuSets<D>::share_field(const Particles<D>& p, Field<Vec<D>> field) {
  share_blocks(p, field);
}

template <int D> void CpuSets<D>::sort(Real h, const Particles<D>& p) {
  Set& set = of(p);
  set.grid.build(threads_, h, p);
  set.grid.write(threads_, p);
  for (const Memory& m : set.memory) {
    std::byte* data = m.data.get();
    if (m.field.keep != Keep::kept || data == static_cast<void*>(p.x.data) ||
        data == static_cast<void*>(p.id.data))
      continue;               // the grid has written x and id
    switch (m.field.bytes) {  // copies of a known size are single moves
      case 4:
        permute<4>(set.grid.order(), p.n, data);
        break;
      case 8:
        permute<8>(set.grid.order(), p.n, data);
        break;
      case 12:
        permute<12>(set.grid.order(), p.n, data);
        break;
      case 16:
        permute<16>(set.grid.order(), p.n, data);
        break;
      default:
        permute<24>(set.grid.order(), p.n, data);
        break;
    }
  }
  set.sorted = true;
  ++set.sorts;
}
template <int D> void CpuSets<D>::sort_if_needed(Real h, const Particles<D>& p) {
  if (p.moves || !of(p).sorted) sort(h, p);
}

/// Creates the copies of a set and sorts them by cell and id. They follow the particles.
template <int D> void CpuSets<D>::copy(Real h, Particles<D>& p) {
  Set& set = of(p);
  if (set.copies.none()) return;
  set.copies.make(p, h);
  set.copies.place(p);
  Particles<D> all;
  all.n = set.copies.size();
  all.id.data = p.id.data + p.n;
  all.x.data = p.x.data + p.n;
  set.copy_grid.build(threads_, h, all);
  set.copies.permute(set.copy_grid.order());
  set.copies.place(p);
}

template <int D>
template <std::size_t bytes>
void CpuSets<D>::permute(const int* order, int n, std::byte* data) {
  struct Value {
    std::byte b[bytes];
  };
  auto* field = reinterpret_cast<Value*>(data);
  auto* spare = reinterpret_cast<Value*>(spare_.reserve(std::size_t(n) * bytes));
  threads_.blocks(n, [&](int b, int e) {
    for (int i = b; i < e; ++i) spare[i] = field[order[i]];
  });
  threads_.blocks(
      n, [&](int b, int e) { std::memcpy(field + b, spare + b, std::size_t(e - b) * bytes); });
}

template <int D>
void CpuSets<D>::list(Real h, const Particles<D>& targets, const Particles<D>& sources) {
  if (targets.n == 0 || sources.n == 0) return;
  auto& lists = of(targets).lists;
  if (lists.size() < sets_.size()) lists.resize(sets_.size());
  auto& one = lists[std::size_t(sources.set)];
  if (!one) one = std::make_unique<typename Set::Lists>();
  const Set& set = of(sources);
  const std::int64_t target_sorts = of(targets).sorts;
  if (one->target_sorts == target_sorts && one->source_sorts == set.sorts) return;
  const Source<D> all[] = {{&set.grid, 0}, {&set.copy_grid, sources.n}};
  one->sliced.build(threads_, h, of(targets).grid,
                    std::span(all, sources.copies > 0 ? std::size_t(2) : std::size_t(1)));
  one->target_sorts = target_sorts;  // after the build: it may run out of memory
  one->source_sorts = set.sorts;
}

}  // namespace FRESHET_ISA
}  // namespace freshet
