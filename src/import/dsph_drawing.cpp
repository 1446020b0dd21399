// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "import/dualsphysics.h"
#include "mesh/triangle_mesh.h"

namespace freshet {
namespace {

using DrawPoint = Vec<3, double>;
using Drawn = DsphShape;

constexpr double degree = std::numbers::pi / 180;
constexpr long most_places = 400'000'000;
constexpr long most_commands = 100'000;

/// Commands that change files, names and drawing tools only.
const std::set<std::string, std::less<>> silent_commands{
    "shapeout",    "setshapemode", "cellsout",  "pointsmkout", "debugout",        "setnormalinvert",
    "resetdraw",   "statesave",    "stateload", "setdpctes",   "dpctessave",      "dpctesload",
    "dpctesreset", "printf",       "exportvar", "setactive",   "setboxlimitmode", "setdrawmode"};

unsigned sides_of(const std::string& fill, bool& solid, const XmlElement& box) {
  unsigned sides = 0;
  solid = false;
  bool removes = false;
  std::string word;
  for (const char c : fill + "|") {
    if (c == ' ' || c == '\t' || c == '\n') continue;
    if (c != '|' && c != '^') {
      word += c;
      continue;
    }
    const std::pair<const char*, unsigned> names[] = {
        {"left", x_low}, {"right", x_high}, {"bottom", y_low},       {"top", y_high},
        {"back", z_low}, {"front", z_high}, {"all", all_dsph_sides}, {"solid", all_dsph_sides}};
    bool known = false;
    for (const auto& [name, side] : names)
      if (word == name) {
        known = true;
        if (removes) sides &= ~side;
        else sides |= side;
        if (word == "solid") solid = true;
      }
    if (!known)
      box.error(
          fmt::format("has the boxfill {}; it must be solid, all, or sides such as "
                      "bottom | left | right",
                      toml_string(word)));
    removes = c == '^';
    word.clear();
  }
  return sides;
}

/// Runs the commands of a case.
class DsphDrawing {
 public:
  DsphDrawing(const XmlElement& commands, DsphWorld& world)
      : world_(world), lists_(commands.children("list")) {}

  void run(const XmlElement& list) {
    for (const XmlElement& command : list.children()) {
      if (++commands_ > most_commands) {
        list.error(fmt::format("has more than {} commands; make it shorter", most_commands));
        return;
      }
      if (!draw(command) && !change(command) && !fill(command))
        command.missing("this command has no counterpart, and draws nothing");
    }
  }

 private:
  bool draw(const XmlElement& c) {
    const std::string& name = c.name();
    Drawn shape{c, Drawn::Kind::box, mark_, frame_};
    if (name == "drawbox") read_box(c, shape);
    else if (name == "drawsphere") read_sphere(c, shape);
    else if (name == "drawcylinder") read_cylinder(c, shape);
    else if (name == "drawprism" || name == "drawbeach") {
      if (!read_profile(c, shape)) return false;
    } else if (name == "drawfilestl" || name == "drawfileply") {
      if (!read_mesh_command(c, shape)) return true;
    } else return false;
    mark_dsph_shape(shape, world_);
    if (mark_ < 0) world_.shapes.push_back(shape);
    return true;
  }

  void read_box(const XmlElement& c, Drawn& shape) const {
    XmlElement point = c.child("point"), size = c.child("size"), end = c.child("endpoint");
    if (!point || (!size && !end)) c.error("needs <point> and <size>; add them");
    const DrawPoint a = point.point(), b = end ? end.point() : a + size.point();
    const DrawPoint p = from_dsph(a), q = from_dsph(b);
    shape.low = {std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)};
    shape.high = {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)};
    shape.sides = sides_of(c.child("boxfill").body(), shape.solid, c);
    c.child("layers").missing("boundaries have as many layers as the support reaches");
  }

  static void read_sphere(const XmlElement& c, Drawn& shape) {
    shape.kind = Drawn::Kind::sphere;
    shape.radius = shape.frame.scale * c.number("radius", 0, 0);
    shape.low = shape.frame(from_dsph(c.child("point").point()));
    c.child("layers").missing("boundaries have as many layers as the support reaches");
  }

  static void read_cylinder(const XmlElement& c, Drawn& shape) {
    shape.kind = Drawn::Kind::cylinder;
    shape.radius = shape.frame.scale * c.number("radius", 0, 0);
    const std::vector<XmlElement> ends = c.children("point");
    if (ends.size() != 2) {
      c.error("needs two <point>; set both ends");
      return;
    }
    shape.low = shape.frame(from_dsph(ends[0].point()));
    shape.high = shape.frame(from_dsph(ends[1].point()));
    c.text("mask", "");  // hidden ends: the inside is solid
    c.child("layers").missing("boundaries have as many layers as the support reaches");
  }

  /// A prism along y of DualSPHysics. The faces 1 and 2 are its ends; those of `mask` are hidden.
  bool read_profile(const XmlElement& c, Drawn& shape) const {
    const bool beach = c.name() == "drawbeach";
    std::vector<DrawPoint> points;
    for (const XmlElement& p : c.children("point"))
      points.push_back(shape.frame(from_dsph(p.point())));
    const std::size_t n = beach ? points.size() : points.size() / 2;
    bool good = n >= 3 && (beach ? world_.flat() : points.size() == 2 * n);
    for (std::size_t k = 0; good && k < n; ++k) {
      const DrawPoint &a = points[k], &b = points[beach ? k : k + n];
      good = std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - points[0].z) < 1e-6;
    }
    if (!good) return false;
    shape.kind = Drawn::Kind::profile;
    shape.z_low = beach ? -1e9 : std::min(points[0].z, points[n].z);
    shape.z_high = beach ? 1e9 : std::max(points[0].z, points[n].z);
    std::string mask = c.text("mask", "");
    std::replace(mask.begin(), mask.end(), '|', ',');
    std::erase(mask, ' ');
    const std::vector<long> hidden = numbers_of_list(mask);
    const auto is_shown = [&](std::size_t face) {
      return std::find(hidden.begin(), hidden.end(), long(face)) == hidden.end();
    };
    for (std::size_t k = 0; k < n; ++k) {
      const DrawPoint &a = points[k], &b = points[(k + 1) % n];
      if (std::abs(a.x - b.x) + std::abs(a.y - b.y) < 1e-9) continue;  // a side without a length
      shape.points.push_back(a);
      shape.shown.push_back(is_shown(k + 3));
    }
    if (shape.points.size() < 3) return false;
    shape.solid = std::all_of(shape.shown.begin(), shape.shown.end(), [](bool b) { return b; }) &&
                  is_shown(1) && is_shown(2);
    return true;
  }

  bool read_mesh_command(const XmlElement& c, Drawn& shape) const {
    shape.kind = Drawn::Kind::mesh;
    shape.file = c.text("file", "");
    DsphFrame own;
    const XmlElement scale = c.child("drawscale"), turn = c.child("drawrotate"),
                     move = c.child("drawmove");
    const DrawPoint s = scale.point({1, 1, 1});
    if (s.x != s.y || s.x != s.z || !(s.x > 0)) {
      scale.error("must be three equal numbers > 0; apply the scale to the file");
      return false;
    }
    own.scale = s.x;
    const std::tuple<const char*, DrawPoint> turns[] = {
        {"angy", {0, 1, 0}}, {"angx", {1, 0, 0}}, {"angz", {0, 0, 1}}};  // right-handed, in order
    for (const auto& [angle, axis] : turns)
      own = DsphFrame::turned_by(from_dsph(axis), turn.number(angle, 0) * degree, {}).of(own);
    own = DsphFrame::moved(from_dsph(move.point())).of(own);
    shape.frame = frame_.of(own);
    if (c.boolean("autofill", false)) c.child("autofill").missing("a closed mesh is solid");
    if (mark_ > 0) {
      c.missing("liquid that fills a mesh is not drawn; set [[fluid]] with shape = \"mesh\"");
      return false;
    }
    try {
      read_mesh(world_.from / shape.file);
    } catch (const Error& e) {
      c.error(
          fmt::format("names {}: {}", toml_string(shape.file), e.diagnostics().front().message));
      return false;
    }
    return true;
  }

  void set_mark(const XmlElement& c, long mk, bool fluid) {
    if (mk < 0 || mk > 30000) c.error(fmt::format("has mk {}; it must be 0 to 30000", mk));
    else mark_ = std::int16_t(fluid ? mk + 1 : -mk - 1);
    c.text("name", "");
  }

  bool change(const XmlElement& c) {
    const std::string& name = c.name();
    if (name == "setmkfluid") set_mark(c, c.integer("mk", 0), true);
    else if (name == "setmkbound") set_mark(c, c.integer("mk", 0), false);
    else if (name == "setmkvoid") mark_ = 0;
    else if (name == "setmknextfluid" || name == "setmknextbound") {
      if (c.boolean("next", true) && mark_ != 0) mark_ = std::int16_t(mark_ + (mark_ > 0 ? 1 : -1));
    } else if (name == "runlist") run_list(c);
    else if (name == "list") c.skip();
    else if (silent_commands.contains(name)) c.display();
    else return transform(c);
    return true;
  }

  /// Turns about a line are left-handed, as JMatrix4 of DualSPHysics computes them.
  bool transform(const XmlElement& c) {
    const std::string& name = c.name();
    if (name == "matrixreset") frame_ = {};
    else if (name == "matrixsave") saved_.push_back(frame_);
    else if (name == "matrixload") {
      if (!saved_.empty()) {
        frame_ = saved_.back();
        saved_.pop_back();
      }
    } else if (name == "move") frame_ = frame_.of(DsphFrame::moved(from_dsph(c.point())));
    else if (name == "rotate")
      frame_ =
          frame_.of(DsphFrame::turned_by(from_dsph(c.point()), -c.number("ang", 0) * degree, {}));
    else if (name == "rotateline") {
      const std::vector<XmlElement> line = c.children("point");
      if (line.size() != 2) c.error("needs two <point>; set both");
      else {
        const DrawPoint a = from_dsph(line[0].point()), b = from_dsph(line[1].point());
        frame_ = frame_.of(DsphFrame::turned_by(a - b, c.number("ang", 0) * degree, a));
      }
    } else if (name == "scale") {
      const DrawPoint s = c.point({1, 1, 1});
      if (s.x != s.y || s.x != s.z || !(s.x > 0))
        c.error("must be three equal numbers > 0; write the lengths scaled");
      else {
        DsphFrame scaled;
        scaled.scale = s.x;
        frame_ = frame_.of(scaled);
      }
    } else return false;
    return true;
  }

  void run_list(const XmlElement& c) {
    const std::string name = c.text("name", "");
    const long times = c.integer("times", 1);
    for (const XmlElement& list : lists_)
      if (list.text("name", "") == name) {
        list.text("printcall", "");
        if (++depth_ > 20) list.error("runs itself; remove its <runlist>");
        else
          for (long k = 0; k < times && commands_ <= most_commands; ++k) run(list);
        --depth_;
        return;
      }
    c.error(fmt::format("names the list {}, which does not exist; add it", toml_string(name)));
  }

  bool fill(const XmlElement& c) {
    const bool box = c.name() == "fillbox";
    if (!box && c.name() != "fillvoidpoint" && c.name() != "fillpoint") return false;
    const std::string mode = c.child("modefill").body();
    if (!mode.empty() && mode != "void") return false;
    Bounds bounds;
    bounds.low = {-1e15, -1e15, -1e15};
    bounds.high = {1e15, 1e15, 1e15};
    if (box) {
      const DrawPoint a = c.child("point").point();
      const XmlElement end = c.child("endpoint");
      const DrawPoint p = from_dsph(a),
                      q = from_dsph(end ? end.point() : a + c.child("size").point());
      bounds = {};
      bounds.add(p);
      bounds.add(q);
      bounds.low = frame_(bounds.low);
      bounds.high = frame_(bounds.high);
    }
    c.text("mkbound", "");
    if (mark_ != 0 && world_.lattice->fill(frame_(from_dsph(c.point())), bounds, mark_) == 0)
      c.missing("its point is not in a void, so it fills nothing");
    return true;
  }

  DsphWorld& world_;
  std::vector<XmlElement> lists_;
  DsphFrame frame_;
  std::vector<DsphFrame> saved_;
  std::int16_t mark_ = -1;
  long commands_ = 0;
  int depth_ = 0;
};

}  // namespace

void draw_dsph_case(const XmlElement& geometry, DsphWorld& world, ImportFindings& findings) {
  const XmlElement definition = geometry.child("definition"), commands = geometry.child("commands");
  world.dp = definition.number("dp", 0);
  const XmlElement low = definition.child("pointmin"), high = definition.child("pointmax");
  if (!definition || !low || !high) geometry.error("needs <definition> with pointmin and pointmax");
  else if (!(world.dp > 0)) definition.error("needs dp > 0, the distance of particles [m]");
  findings.throw_errors();
  const DrawPoint a = from_dsph(low.point()), b = from_dsph(high.point());
  world.dimension = a.z == b.z ? 2 : 3;
  world.plane_z = a.z;
  const DrawPoint first{a.x, a.y, b.z}, last{b.x, b.y, a.z};
  double places = 1;
  for (const double size : {last.x - first.x, last.y - first.y, last.z - first.z})
    places *= std::max(0.0, size) / world.dp + 1;
  if (!(last.x > first.x) || !(last.y > first.y) || !(last.z >= first.z))
    definition.error("needs a pointmax above its pointmin in x and z; write both corners");
  else if (places > double(most_places))
    definition.error(fmt::format("has {:.2g} places; make dp larger, for at most {:.2g}", places,
                                 double(most_places)));
  findings.throw_errors();
  const XmlElement reference = definition.child("pointref");
  world.lattice = std::make_unique<DsphLattice>(reference ? from_dsph(reference.point()) : first,
                                                first, last, world.dp, world.dimension);
  DsphDrawing(commands, world).run(commands.child("mainlist"));
  findings.throw_errors();
}

}  // namespace freshet
