// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "scene/check/findings.h"
#include "scene/check/names.h"
#include "scene/model/body_shape.h"
#include "scene/model/solid_of.h"

namespace freshet {

void check_body_names(const Scene& s, Findings& out) {
  std::set<std::string> taken;
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const std::string name = s.body_name(k), key = fmt::format("body[{}].name", k);
    if (!names_column(name))
      out.error(key,
                "body.name has a comma, a quote or an invisible character, which tables do not "
                "allow; use letters, digits and _");
    else if (!taken.insert(name).second)
      out.error(key, fmt::format("body.name is \"{}\", which another body has; choose another name",
                                 name));
  }
}

bool check_body_reach(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Body& b = s.body[k];
  const BodyShape shape = body_shape(b);
  const double center[] = {shape.center.x, shape.center.y, shape.center.z};
  double gap = 0, domain = 0;
  for (std::size_t d = 0; d < s.domain.max.size(); ++d) {
    const bool box = b.shape == Shape::box && !is_turned_box(b);
    const double low = box ? b.min[d] : center[d] - shape.reach,
                 high = box ? b.max[d] : center[d] + shape.reach;
    domain = std::max(domain, s.domain.max[d] - s.domain.min[d]);
    if (!s.periodic(int(d))) gap = std::max({gap, low - s.domain.max[d], s.domain.min[d] - high});
  }
  if (!(gap > 0)) return true;
  out.error(fmt::format("body[{}]", k),
            fmt::format("{} is outside the domain{}; move it inside", s.body_name(k),
                        gap > 10 * domain
                            ? fmt::format(", {:.4g} m away from it; all lengths are in metres", gap)
                            : ""));
  return false;
}

const Scene::Body* find_body(const Scene& s, const std::string& name, const std::string& at,
                             const std::string& key, Findings& out) {
  std::string names;
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    if (s.body_name(b) == name) return &s.body[b];
    names += (b ? ", " : "") + s.body_name(b);
  }
  out.error(at, fmt::format("{} is \"{}\", which is not the name of a body; {}", key, name,
                            names.empty() ? "the scene has no bodies" : "there are: " + names));
  return nullptr;
}

}  // namespace freshet
