// SPDX-License-Identifier: MIT
/// The meshes of fluids, walls and bodies.
#include <algorithm>
#include <cmath>

#include "scene/check/findings.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

/// The remedy for a mesh of the wrong size or place: a power of ten as the scale that makes it
/// about as large as the domain, or `otherwise` if its size is right.
std::string scale_remedy(const Scene::Region& r, const std::string& name, double size,
                         double domain, const std::string& otherwise) {
  const double off = std::log10(size / domain);
  if (std::abs(off) < 1.2) return otherwise;
  const double scale = r.scale * std::pow(10, -std::round(off));
  const char* unit = std::round(off) == 3   ? " (is the file in millimetres?)"
                     : std::round(off) == 2 ? " (is the file in centimetres?)"
                                            : "";
  return fmt::format("try {}.scale = {:.3g}{}", name, scale, unit);
}

bool check_place(const Scene& s, const RegionAt& at, const MeshDistance& mesh, Findings& out) {
  auto low = mesh.low(), high = mesh.high();
  double size = 0, domain = 0;
  bool meets = true;
  for (int k = 0; k < 3; ++k) {
    const auto j = std::size_t(k);
    size = std::max(size, component(high, k) - component(low, k));
    domain = std::max(domain, s.domain.max[j] - s.domain.min[j]);
    meets &= component(high, k) > s.domain.min[j] && component(low, k) < s.domain.max[j];
  }
  const auto reaches = [&] {
    return fmt::format(
        "{}.file is \"{}\", a mesh from [{:.4g}, {:.4g}, {:.4g}] to [{:.4g}, "
        "{:.4g}, {:.4g}]",
        at.name, at.region.file, low.x, low.y, low.z, high.x, high.y, high.z);
  };
  if (!meets)
    out.error(at.path + "file",
              fmt::format("{}, which misses the domain; {}", reaches(),
                          scale_remedy(at.region, at.name, size, domain,
                                       fmt::format("move it with {}.translation", at.name))));
  else if (size > 100 * domain)
    out.error(at.path + "file",
              fmt::format("{}, {:.0f} times as large as the domain; {}", reaches(), size / domain,
                          scale_remedy(at.region, at.name, size, domain, "make it smaller")));
  else if (size < s.particles.spacing)
    out.error(at.path + "file",
              fmt::format("{}, smaller than a spacing of {}; {}", reaches(), s.particles.spacing,
                          scale_remedy(at.region, at.name, size, domain,
                                       "make particles.spacing smaller")));
  else return true;
  return false;
}

}  // namespace

std::string hole_words(const MeshHole& h) {
  return fmt::format("a hole of {} edges near [{:.4g}, {:.4g}, {:.4g}], {:.3g} m wide", h.edges,
                     h.middle.x, h.middle.y, h.middle.z, h.width);
}

bool check_mesh(const Scene& s, const RegionAt& at, Findings& out) {
  const bool encloses = at.name != "wall" || at.region.side == Side::inside;
  std::shared_ptr<const LoadedMesh> loaded = at.region.loaded;
  try {
    if (!loaded) loaded = load_mesh(at.region, encloses ? s.particles.spacing : 0);
  } catch (const Error& e) {
    for (const Diagnostic& d : e.diagnostics())
      out.error(at.path + "file",
                fmt::format("{}.file is \"{}\": {}", at.name, at.region.file, d.message));
    return false;
  }
  const MeshCondition& c = loaded->condition;
  if (encloses && !c.closed()) {
    out.error(at.path + "file",
              fmt::format(
                  "{}.file is \"{}\", which is not closed, so it has no inside: {}; only "
                  "holes narrower than the spacing, {:.4g} m, are filled; close it in a "
                  "modelling program{}",
                  at.name, at.region.file, hole_words(c.widest_open()), s.particles.spacing,
                  at.name != "wall" ? "" : ", or use it as a sheet with wall.side = \"outside\""));
    return false;
  }
  return check_place(s, at, loaded->distance, out);
}

}  // namespace freshet
