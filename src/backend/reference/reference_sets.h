// SPDX-License-Identifier: MIT
#pragma once
#include <initializer_list>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "backend/copies.h"
#include "backend/edit.h"
#include "backend/reference/neighbor_lists.h"
#include "backend/timings.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The particle sets of the reference backend: their memory, their copies and the neighbour search.
/// Particles stay in the order of their ids. The members are defined in reference_sets_impl.h and
/// compiled once.
template <int D> class ReferenceSets {
 public:
  explicit ReferenceSets(Search search = Search::grid, NeighborOrder order = NeighborOrder::cell);
  ReferenceSets(ReferenceSets&&) noexcept;
  ~ReferenceSets();

  /// Adds a set of n particles and sets its index; allocate() adds its fields. The rules define the
  /// copies of its particles.
  void add_set(Particles<D>& set, int n, typename Copies<D>::Rules rules = {});
  /// Allocates memory for one T per particle and copy, zeroed. The backend owns it. `field` must
  /// not move, because `edit` changes its pointer.
  template <class T> void allocate(const Particles<D>& set, Keep keep, Field<T>& field) {
    add_field(set, FieldOfSet::of(keep, field));
  }
  const std::vector<VerbTiming>& timings() const { return timings_.list(); }

  /// Copies the kept fields, for a step that may be rolled back.
  void save(const char* name, const Particles<D>& p);
  void restore(const char* name, const Particles<D>& p);
  /// Between steps: removes the particles with the indices `gone` (ascending) and appends `more`
  /// new ones, zeroed. The others keep all fields. Copies and lists are invalid until the next
  /// search.
  void edit(const char* name, Particles<D>& p, std::span<const int> gone, int more);

  /// Between steps: moves the field that starts at `data` to other memory. The memory of before
  /// stays valid and unchanged as long as the returned object lives. Null if no field starts there.
  std::shared_ptr<const void> keep(const Particles<D>& p, const void* data);

  /// Lists the neighbours of each particle of `moving` in every set.
  template <class... Fixed>
  void find_neighbors(const char* name, Real support_radius, Particles<D>& moving,
                      const Fixed&... fixed) {
    search(name, support_radius, moving, {static_cast<const Particles<D>*>(&fixed)...});
  }
  /// Lists the neighbours of `targets` among `sources` by the positions of both at the last search.
  /// Targets that move are taken at their present positions.
  void list_neighbors(const char* name, Real support_radius, const Particles<D>& targets,
                      const Particles<D>& sources);

  /// Updates these fields at the copies of particles.
  template <class... Fields> void share(const char*, const Particles<D>& p, Fields... fields) {
    if (p.copies == 0) return;
    const auto timer = timings_.time("share", p.copies);
    (copies_[std::size_t(p.set)].share(p, fields), ...);
  }

 protected:
  std::vector<Copies<D>> copies_;                          // by set
  std::map<std::pair<int, int>, NeighborLists<D>> lists_;  // by targets and sources
  Timings timings_;

 private:
  struct Memory {
    int set;
    FieldOfSet field;
    std::unique_ptr<std::byte[]> data;
    std::vector<std::byte> saved;
  };
  void add_field(const Particles<D>& set, FieldOfSet field);
  std::unique_ptr<std::byte[]> room_for(int particles, const Memory& m) const;
  std::unique_ptr<std::byte[]> move(Memory& m, int n, int room);
  void search(const char* name, Real support_radius, Particles<D>& moving,
              std::initializer_list<const Particles<D>*> fixed);
  static void follow(const Particles<D>& p);
  void remember_positions(const Particles<D>& p);
  void list(Real h, const Particles<D>& targets, const Particles<D>& sources);

  Search search_;
  NeighborOrder order_;
  std::vector<std::vector<Vec<D>>> searched_;  // by set: positions at the last search
  std::vector<int> room_;                      // by set: particles that fit into the memory
  std::vector<Memory> memory_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
