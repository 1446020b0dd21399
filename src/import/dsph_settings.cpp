// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "import/dualsphysics.h"

namespace freshet {
namespace {

/// "parameters" by their keys.
class DsphParameters {
 public:
  explicit DsphParameters(const XmlElement& parameters) {
    for (const XmlElement& p : parameters.children("parameter"))
      if (p.boolean("active", true)) all_.insert_or_assign(p.text("key", ""), p);
      else p.skip();
  }
  const XmlElement* find(const std::string& key) const {
    const auto found = all_.find(key);
    return found == all_.end() ? nullptr : &found->second;
  }
  double number(const std::string& key, double fallback) const {
    const XmlElement* p = find(key);
    return p ? p->number("value", fallback) : fallback;
  }
  long integer(const std::string& key, long fallback) const {
    const XmlElement* p = find(key);
    return p ? p->integer("value", fallback) : fallback;
  }
  void instead(const std::string& key, const std::string& message) const {
    if (const XmlElement* p = find(key)) p->instead(message);
  }
  void missing(const std::vector<const char*>& keys, const std::string& message) const {
    for (const char* key : keys)
      if (const XmlElement* p = find(key)) p->missing(message);
  }
  void display(const std::vector<const char*>& keys) const {
    for (const char* key : keys)
      if (const XmlElement* p = find(key)) p->display();
  }

 private:
  std::map<std::string, XmlElement> all_;
};

double value_of(const XmlElement& constants, const char* name, double fallback) {
  return constants.child(name).number("value", fallback);
}

/// A constant that GenCase computes if it is "auto".
std::optional<double> set_value(const XmlElement& constants, const char* name) {
  const XmlElement c = constants.child(name);
  const double value = c.number("value", 0);
  return c && !c.boolean("auto", false) && value > 0 ? std::optional(value) : std::nullopt;
}

/// The speed of sound: coefsound times the speed of a dam break, the root of g times the water's
/// height.
double sound_of(const XmlElement& constants, const DsphWorld& world) {
  const double height = set_value(constants, "hswl").value_or(world.water_height());
  const double flow =
      set_value(constants, "speedsystem").value_or(std::sqrt(norm(world.gravity) * height));
  if (const std::optional<double> b = set_value(constants, "b"))  // of the equation of state
    return std::sqrt(*b * value_of(constants, "gamma", 7) / world.rest_density);
  return set_value(constants, "speedsound").value_or(value_of(constants, "coefsound", 20) * flow);
}

void read_dsph_viscosity(const DsphParameters& p, double sound, DsphWorld& world,
                         TomlTable& solver) {
  const double visco = p.number("Visco", 0.01);
  const long treatment = p.integer("ViscoTreatment", 1);
  if (treatment == 1) {
    solver.set("artificial_viscosity", visco);
    return;
  }
  if (!world.moved.empty() || !world.floating.empty()) {  // bodies feel artificial viscosity only
    const double alpha =
        sound > 0 ? visco * 2 * (world.dimension + 2) / (world.support / 2 * sound) : 0;
    solver.set("artificial_viscosity", alpha);
    p.instead("ViscoTreatment", fmt::format("laminar, which bodies do not feel; taken instead: "
                                            "artificial viscosity of the same strength, {:.3g}",
                                            alpha));
    return;
  }
  solver.set("viscosity_method", "morris1997");
  world.viscosity = visco * world.rest_density;
  if (treatment == 2)
    p.instead("ViscoTreatment", "laminar with a turbulence model; taken instead: laminar");
}

void read_dsph_solver(const DsphParameters& p, const XmlElement& constants, DsphWorld& world,
                      TomlTable& solver) {
  const long diffusion = p.integer("DensityDT", 0);
  solver.set("name", diffusion == 0 ? "wcsph" : "delta_sph");
  if (diffusion > 0) {
    solver.set("delta", p.number("DensityDTvalue", 0.1));
    if (diffusion == 1) {
      solver.set("density_diffusion", "antuono2010");
      p.instead("DensityDT", "Molteni & Colagrossi 2009; taken instead: antuono2010");
    } else solver.set("density_diffusion", "fourtakas2019");
  } else p.display({"DensityDTvalue"});
  solver.set("kernel", p.integer("Kernel", 2) == 1 ? "cubic_spline" : "wendland_c2");
  const double sound = sound_of(constants, world);
  if (sound > 0) solver.set("sound_speed", sound);
  read_dsph_viscosity(p, sound, world, solver);
  if (p.integer("Shifting", 0) > 0) {
    solver.set("shifting_method", "lind2012");
    p.instead("Shifting", "taken instead: lind2012 with its own coefficient");
  }
  if (constants.child("gamma").number("value", 7) != 7)
    constants.child("gamma").instead("taken instead: 7, with the same speed of sound");
  p.instead("StepAlgorithm", "taken instead: the integrator of the solver");
}

void skip_parameters(const DsphParameters& p) {
  p.display({"VerletSteps",     "ShiftCoef",      "ShiftTFS",      "ShiftAdvCoef", "ShiftAdvALE",
             "ShiftAdvNCPress", "CoefDtMin",      "DtIni",         "DtMin",        "DtAllParticles",
             "SavePosDouble",   "PosDouble",      "WrnPartsOut",   "PartsOutMax",  "MinFluidStop",
             "TimeOutExtra",    "FtIgnoreRadius", "DtFixedFile",   "IncZ",         "NoPenetration",
             "XPeriodicIncY",   "YPeriodicIncX",  "ZPeriodicIncX", "ZPeriodicIncY"});
  if (p.number("DtFixed", 0) > 0) p.instead("DtFixed", "taken instead: adaptive steps");
  p.missing({"RhopOutMin", "RhopOutMax"},
            "particles stay whatever their density; health checks warn of it");
  if (p.number("ViscoBoundFactor", 1) != 1)
    p.instead("ViscoBoundFactor", "taken instead: 1, which is set by wall.slip");
  p.instead("Boundary", "taken instead: adami2012");
  p.instead("BoundaryMethod", "taken instead: adami2012");
  p.missing({"SlipMode"}, "walls are no_slip; set walls.slip and wall.slip");
  if (p.integer("RigidAlgorithm", 1) != 1)
    p.instead("RigidAlgorithm", "taken instead: contacts of Bullet");
  if (p.number("FtPause", 0) > 0) p.missing({"FtPause"}, "bodies move from the start");
}

/// A bound of "simulationdomain": "0.5", "default", "default + 10%" or "default - 2".
double bound_of(const XmlElement& corner, const char* axis, double fallback, double size) {
  std::string text = corner.text(axis, "default");
  std::erase(text, ' ');
  if (!text.starts_with("default")) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && *end == 0 && std::abs(value) < 1e15) return value;
  } else if (text.size() == 7) return fallback;
  else {
    char* end = nullptr;
    const double by = std::strtod(text.c_str() + 7, &end);
    if (end != text.c_str() + 7 && std::abs(by) < 1e15) {
      if (*end == 0) return fallback + by;
      if (std::string(end) == "%") return fallback + by / 100 * size;
    }
  }
  corner.error(fmt::format("has {} = {}; it must be a number, default, or such as default + 10%",
                           axis, toml_string(text)));
  return fallback;
}

}  // namespace

void read_dsph_constants(const XmlElement& constants, DsphWorld& world) {
  world.gravity = from_dsph(constants.child("gravity").point({0, 0, -9.81}));
  world.rest_density = constants.child("rhop0").number("value", 1000, 1e-6);
  world.hydrostatic = value_of(constants, "rhopgradient", 2) >= 2 && world.gravity.y < 0;
  const double root = std::sqrt(double(world.dimension));
  const std::optional<double> h = set_value(constants, "h"), hdp = set_value(constants, "hdp");
  const double length = h     ? *h
                        : hdp ? *hdp * world.dp
                              : value_of(constants, "coefh", 1) * root * world.dp;
  world.support = 2 * length;
  constants.child("cflnumber").missing("the time step has safety factors of its own");
  for (const char* name : {"massbound", "massfluid"})
    if (set_value(constants, name))
      constants.child(name).missing("follows from the density, the spacing and the speed of sound");
    else constants.child(name).skip();
  constants.child("lattice").display();
}

void read_dsph_axes(const XmlElement& parameters, DsphWorld& world) {
  const DsphParameters p(parameters);
  const std::pair<const char*, unsigned> keys[] = {
      {"XPeriodicIncZ", 1}, {"XPeriodicIncY", 1}, {"YPeriodicIncX", 4},
      {"YPeriodicIncZ", 4}, {"ZPeriodicIncX", 2}, {"ZPeriodicIncY", 2},
      {"XYPeriodic", 5},    {"XZPeriodic", 3},    {"YZPeriodic", 6}};
  for (const auto& [key, axes] : keys)
    if (p.find(key)) {
      world.periodic |= axes & (world.flat() ? 3u : 7u);
      if (p.number(key, 0) != 0)
        p.instead(key, "particles also rise at the end of the axis; taken instead: they do not");
    }
  world.duration = std::max(1e-6, p.number("TimeMax", 1));
}

Bounds dsph_room(const XmlElement& parameters, const DsphWorld& world) {
  Bounds room = world.lattice->extent(false);
  if (room.empty()) return room;
  const Vec<3, double> size = room.size(), half = (world.dp / 2) * Vec<3, double>{1, 1, 1};
  room.low = room.low - half;
  room.high = room.high + half;
  const XmlElement domain = parameters.child("simulationdomain");
  const XmlElement low = domain.child("posmin"), high = domain.child("posmax");
  if (low) {
    room.low.x = bound_of(low, "x", room.low.x, size.x);
    room.low.y = bound_of(low, "z", room.low.y, size.y);
    room.high.z = -bound_of(low, "y", -room.high.z, size.z);
  }
  if (high) {
    room.high.x = bound_of(high, "x", room.high.x, size.x);
    room.high.y = bound_of(high, "z", room.high.y, size.y);
    room.low.z = -bound_of(high, "y", -room.low.z, size.z);
  }
  return room;
}

DsphSettings read_dsph_settings(const XmlElement& constants, const XmlElement& parameters,
                                DsphWorld& world) {
  DsphSettings s;
  const DsphParameters p(parameters);
  s.particles.set("spacing", world.dp);
  s.particles.set("support_radius", world.support);
  read_dsph_solver(p, constants, world, s.solver);
  s.time.set("end", world.duration);
  s.time.set("step", "adaptive");
  const double interval = std::max(1e-9, p.number("TimeOut", 0.01));
  s.time.set("step_max", interval);
  s.output.set("frame_every", interval);
  s.output.line("data", "[\"vtp\"]");
  skip_parameters(p);
  return s;
}

}  // namespace freshet
