// SPDX-License-Identifier: MIT
/// What keeps the fluid in a scene: reflecting walls, ghosts, periodic axes.
#pragma once
#include <vector>

#include "boundary/confinement.h"
#include "boundary/copy_rule.h"
#include "scene/solid_of.h"
#include "sim/engine.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Sides that push back what crosses them: the reflecting ones, and ghosts should they be crossed.
inline unsigned reflecting_sides(const Scene& s) {
  unsigned sides = 0;
  for (int side = 0; side < 2 * s.dimension(); ++side) {
    const WallMethod method = s.side_method(side);
    if (!s.periodic(side / 2) && (method == WallMethod::reflection || method == WallMethod::ghost))
      sides |= 1u << side;
  }
  return sides;
}

/// Everything of a confinement but the memory, which the engine has.
template <int D> Confinement<D> confinement(const Scene& s) {
  Confinement<D> c{};
  c.box = {vec_of<D, Real>(s.domain.min), vec_of<D, Real>(s.domain.max), Real(s.walls.restitution),
           reflecting_sides(s), s.solver.scheme == Scheme::article};
  for (int k = 0; k < D; ++k)
    if (s.periodic(k))
      component(c.period, k) = Real(s.domain.max[std::size_t(k)] - s.domain.min[std::size_t(k)]);
  return c;
}

/// The reflecting (and ghost) shapes, and the places of their names.
template <int D> std::vector<Reflector<D>> reflectors(const Scene& s, std::vector<int>& walls) {
  std::vector<Reflector<D>> all;
  for (std::size_t k = 0; k < s.wall.size(); ++k) {
    const WallMethod method = s.wall_method(k);
    if (method != WallMethod::reflection && method != WallMethod::ghost) continue;
    all.push_back({solid_of<D, Real>(s.wall[k]), Real(s.wall[k].restitution)});
    walls.push_back(2 * D + int(k));
  }
  return all;
}

/// A side's plane, facing inwards.
template <int D>
CopyRule<D> rule_of_side(const Vector& min, const Vector& max, int side, bool no_slip, int axis) {
  CopyRule<D> rule{};
  rule.mirror = true;
  rule.no_slip = no_slip;
  rule.axis = axis;
  rule.point = vec_of<D, Real>(side % 2 ? max : min);
  component(rule.normal, side / 2) = side % 2 ? Real(-1) : Real(1);
  return rule;
}

/// The copies that the fluid has: periodic images, and mirror images at ghost walls; `walls` gets
/// the place of each rule's name (-1: none).
template <int D> std::vector<CopyRule<D>> copy_rules(const Scene& s, std::vector<int>& walls) {
  std::vector<CopyRule<D>> rules;
  for (int side = 0; side < 2 * D; ++side) {
    const int axis = side / 2;
    const bool periodic = s.periodic(axis);
    if (!periodic && s.side_method(side) != WallMethod::ghost) continue;
    auto rule = rule_of_side<D>(s.domain.min, s.domain.max, side,
                                s.walls.slip == Slip::no_slip && !periodic, axis);
    if (periodic) {
      rule.mirror = false;
      const double length = s.domain.max[std::size_t(axis)] - s.domain.min[std::size_t(axis)];
      component(rule.shift, axis) = Real(side % 2 ? -length : length);
    }
    rules.push_back(rule);
    walls.push_back(periodic ? -1 : side);
  }
  int axis = D;
  for (std::size_t k = 0; k < s.wall.size(); ++k) {
    if (s.wall_method(k) != WallMethod::ghost) continue;
    const Scene::Wall& wall = s.wall[k];
    const bool no_slip = wall.slip == Slip::no_slip;
    if (wall.shape == Shape::plane) {
      CopyRule<D> rule{};
      rule.mirror = true;
      rule.no_slip = no_slip;
      rule.axis = axis++;
      const auto solid = solid_of<D, Real>(wall);
      rule.point = solid.center;
      rule.normal = solid.normal(solid.center);
      rules.push_back(rule);
      walls.push_back(2 * D + int(k));
      continue;
    }
    for (int side = 0; side < 2 * D; ++side) {
      rules.push_back(rule_of_side<D>(wall.min, wall.max, side, no_slip, axis + side / 2));
      walls.push_back(2 * D + int(k));
    }
    axis += D;
  }
  return rules;
}

}  // namespace FRESHET_ISA
}  // namespace freshet
