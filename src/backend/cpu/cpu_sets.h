// SPDX-License-Identifier: MIT
#pragma once
#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

#include "backend/copies.h"
#include "backend/cpu/neighbor_lists.h"
#include "backend/edit.h"
#include "backend/timings.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The particle sets of the cpu backend: their memory, their copies and the neighbour search.
/// The members are defined in cpu_sets_impl.h and compiled once per instruction set.
template <int D> class CpuSets {
 public:
  explicit CpuSets(int threads);
  CpuSets(CpuSets&&) noexcept;
  ~CpuSets();

  /// Adds a set of n particles and sets its index; allocate() adds its fields. The rules define the
  /// copies of its particles.
  void add_set(Particles<D>& set, int n, typename Copies<D>::Rules rules = {});
  /// Allocates memory for one T per particle and copy, zeroed. The backend owns it and sorts kept
  /// fields. `field` must not move, because `edit` changes its pointer.
  template <class T> void allocate(const Particles<D>& set, Keep keep, Field<T>& field) {
    add_field(set, FieldOfSet::of(keep, field));
  }
  const std::vector<VerbTiming>& timings() const { return timings_.list(); }

  /// Copies the kept fields, for a step that may be rolled back.
  void save(const char* name, const Particles<D>& p) { copy_kept(name, p, true); }
  void restore(const char* name, const Particles<D>& p) { copy_kept(name, p, false); }

  /// Between steps: removes the particles with the indices `gone` (ascending) and appends `more`
  /// new ones, zeroed. The others keep all fields. Copies and lists are invalid until the next
  /// search.
  void edit(const char* name, Particles<D>& p, std::span<const int> gone, int more);

  /// Between steps: moves the field that starts at `data` to other memory. The memory of before
  /// stays valid and unchanged as long as the returned object lives. Null if no field starts there.
  std::shared_ptr<const void> keep(const Particles<D>& p, const void* data);

  /// Sorts `moving` and every other set that moves; sorts sets at rest the first time. Then lists
  /// the neighbours of each particle of `moving` in every set. With a skin, sorts and lists only
  /// when a particle has left its lists.
  template <class... Fixed>
  void find_neighbors(const char* name, Real support_radius, Particles<D>& moving,
                      const Fixed&... fixed) {
    search(name, support_radius, moving, {static_cast<const Particles<D>*>(&fixed)...});
  }
  /// Lists the neighbours of `targets` among `sources`, which must be sorted already.
  void list_neighbors(const char* name, Real support_radius, const Particles<D>& targets,
                      const Particles<D>& sources);

  /// Updates these fields at the copies of particles.
  template <class... Fields> void share(const char*, const Particles<D>& p, Fields... fields) {
    if (p.copies > 0) (share_field(p, fields), ...);
  }

 protected:
  struct Memory {
    FieldOfSet field;
    Buffer<std::byte> data, saved;
  };
  struct Set {
    explicit Set(typename Copies<D>::Rules rules) : copies(std::move(rules)) {}
    Copies<D> copies;
    int room = 0;  // particles that fit into the memory
    std::vector<Memory> memory;
    CpuCellGrid<D> grid, copy_grid;
    bool sorted = false;
    std::int64_t sorts = 0;  // so far
    struct Lists {
      SlicedLists<D> sliced;
      std::int64_t target_sorts = 0, source_sorts = 0;  // that they follow from
    };
    std::vector<std::unique_ptr<Lists>> lists;  // by index of the source set
  };
  Set& of(const Particles<D>& p) { return *sets_[std::size_t(p.set)]; }

  Threads threads_;
  Timings timings_;

 private:
  void add_field(const Particles<D>& set, FieldOfSet field);
  void copy_kept(const char* name, const Particles<D>& p, bool save);
  void search(const char* name, Real support_radius, Particles<D>& moving,
              std::initializer_list<const Particles<D>*> fixed);
  void share_field(const Particles<D>& p, Field<Real> field);
  void share_field(const Particles<D>& p, Field<int> field);
  void share_field(const Particles<D>& p, Field<Vec<D>> field);
  template <class T> void share_blocks(const Particles<D>& p, Field<T> field);
  /// Of a field, for `room` particles and their copies.
  static std::size_t bytes_for(int room, const Set& set, const Memory& m);
  Buffer<std::byte> move(Memory& m, int n, std::size_t bytes);
  void clear(Memory& m, int begin, int end);
  bool must_sort(const Particles<D>& p) const;
  void sort(Real h, const Particles<D>& p);
  void sort_if_needed(Real h, const Particles<D>& p);
  void copy(Real h, Particles<D>& p);
  template <std::size_t bytes> void permute(const int* order, int n, std::byte* data);
  void list(Real h, const Particles<D>& targets, const Particles<D>& sources);

  std::vector<std::unique_ptr<Set>> sets_;
  Buffer<std::byte> spare_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
