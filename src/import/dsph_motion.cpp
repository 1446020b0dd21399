// SPDX-License-Identifier: MIT
/// Motions of DualSPHysics as key frames.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "import/dualsphysics.h"

namespace freshet {
namespace {

using MotionPoint = Vec<3, double>;
constexpr double tau = 2 * std::numbers::pi;
constexpr std::size_t most_frames = 50'000;
constexpr int frames_of_period = 40;

/// The key frames of a body: displacement and angle [rad] at rising times.
struct DsphFrames {
  struct Frame {
    double time;
    MotionPoint shift;
    double angle;
  };
  std::vector<Frame> list;
  MotionPoint axis{}, pivot{};
  bool turns = false, smooth = false;

  void add(double time, const MotionPoint& shift, double angle) {
    if (list.size() >= most_frames || (!list.empty() && time <= list.back().time)) return;
    list.push_back({time, shift, angle});
  }
  double time() const { return list.back().time; }
  MotionPoint shift() const { return list.back().shift; }
  double angle() const { return list.back().angle; }
};

MotionPoint product3(const MotionPoint& a, const MotionPoint& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

double unit_of_angle(const XmlElement& move) {
  return move.text("anglesunits", "degrees") == "radians" ? 1 : std::numbers::pi / 180;
}

void read_axis(const XmlElement& move, DsphFrames& frames) {
  const MotionPoint a = from_dsph(move.child("axisp1").point()),
                    b = from_dsph(move.child("axisp2").point({0, 0, 1}));
  frames.pivot = a;
  frames.axis = a - b;  // its turns are left-handed about the way from axisp1 to axisp2
  frames.turns = true;
}

/// Straight motion, or a turn: value(s) at s seconds from the start, in units of the axis.
template <class Shift, class Angle>
void sample(DsphFrames& frames, double duration, double step, Shift shift, Angle angle) {
  const double start = frames.time(), a0 = frames.angle();
  const MotionPoint s0 = frames.shift();
  const auto n = std::size_t(std::clamp(std::ceil(duration / step), 1.0, double(most_frames)));
  for (std::size_t k = 1; k <= n; ++k) {
    const double s = duration * double(k) / double(n);
    frames.add(start + s, s0 + shift(s), a0 + angle(s));
  }
}

/// The rows of a file of numbers.
std::vector<std::vector<double>> rows_of_file(const XmlElement& file, const DsphWorld& world) {
  const std::string name = file.text("name", "");
  std::ifstream in(world.from / name);
  std::vector<std::vector<double>> rows;
  if (!in) {
    file.error(
        fmt::format("names {}, which cannot be read; put it beside the case", toml_string(name)));
    return rows;
  }
  for (std::string line; std::getline(in, line);) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ';' || c == ','; }, ' ');
    std::istringstream words(line);
    std::vector<double> row;
    for (double x; words >> x;) row.push_back(x);
    if (row.size() >= 2) rows.push_back(row);
  }
  return rows;
}

/// Motion by a file: columns of time and of displacements, or of an angle.
void read_file(const XmlElement& move, double duration, bool turns, const DsphWorld& world,
               DsphFrames& frames) {
  const XmlElement file = move.child("file");
  const auto rows = rows_of_file(file, world);
  file.integer("fields", 2);
  const long time = file.integer("fieldtime", 0);
  const long columns[] = {file.integer("fieldx", turns ? -1 : 1), file.integer("fieldy", -1),
                          file.integer("fieldz", -1)};
  const double unit = turns ? unit_of_angle(move) : 1;
  if (turns) read_axis(move, frames);
  const auto value = [](const std::vector<double>& row, long k) {
    return k >= 0 && std::size_t(k) < row.size() ? row[std::size_t(k)] : 0.0;
  };
  if (rows.empty()) return;
  const double start = frames.time(), first = value(rows[0], time), a0 = frames.angle();
  const MotionPoint s0 = frames.shift();
  const auto at = [&](const std::vector<double>& row) {
    return from_dsph({value(row, columns[0]), value(row, columns[1]), value(row, columns[2])});
  };
  const std::size_t each = rows.size() / 20'000 + 1;
  for (std::size_t k = 0; k < rows.size(); k += each) {
    const double s = value(rows[k], time) - first;
    if (s > duration) break;
    if (turns) frames.add(start + s, s0, a0 + unit * (value(rows[k], 1) - value(rows[0], 1)));
    else frames.add(start + s, s0 + at(rows[k]) - at(rows[0]), a0);
  }
  frames.smooth = true;
}

/// Adds one motion. Returns false if it has no counterpart. `phase` goes on in the next one.
bool add_motion(const XmlElement& m, double duration, const DsphWorld& world, DsphFrames& frames,
                MotionPoint& phase) {
  const std::string& name = m.name();
  const auto still = [](double) { return MotionPoint{}; };
  const auto straight = [](double) { return 0.0; };
  if (name == "mvnull") {
    sample(frames, duration, duration, still, straight);
  } else if (name == "mvrect" || name == "mvrectace") {
    const MotionPoint v = from_dsph(m.child(name == "mvrect" ? "vel" : "velini").point()),
                      a = from_dsph(m.child("ace").point());
    sample(
        frames, duration, norm(a) > 0 ? duration / 50 : duration,
        [&](double s) { return s * v + (0.5 * s * s) * a; }, straight);
  } else if (name == "mvrectsinu") {
    const MotionPoint f = from_dsph(m.child("freq").point()),
                      a = from_dsph(m.child("ampl").point());
    if (m.child("phase")) phase = unit_of_angle(m) * m.child("phase").point();
    const MotionPoint from{phase.x, phase.z, phase.y},
        rate{std::abs(f.x), std::abs(f.y), std::abs(f.z)};
    const auto wave = [&](double s) {
      return MotionPoint{std::sin(tau * rate.x * s + from.x), std::sin(tau * rate.y * s + from.y),
                         std::sin(tau * rate.z * s + from.z)};
    };
    const double fastest = std::max({rate.x, rate.y, rate.z, 1e-6});
    sample(
        frames, duration, 1 / (fastest * frames_of_period),
        [&](double s) { return product3(a, wave(s) - wave(0)); }, straight);
    phase = {phase.x + tau * rate.x * duration, phase.y + tau * rate.z * duration,
             phase.z + tau * rate.y * duration};
    frames.smooth = true;
  } else if (name == "mvrot" || name == "mvrotace") {
    const double unit = unit_of_angle(m);
    const double v = unit * m.child(name == "mvrot" ? "vel" : "velini").number("ang", 0),
                 a = unit * m.child("ace").number("ang", 0);
    read_axis(m, frames);
    sample(frames, duration, a != 0 ? duration / 50 : duration, still,
           [&](double s) { return v * s + 0.5 * a * s * s; });
  } else if (name == "mvrotsinu") {
    const double unit = unit_of_angle(m), f = m.child("freq").number("v", 0),
                 a = unit * m.child("ampl").number("v", 0),
                 p = unit * m.child("phase").number("v", 0);
    read_axis(m, frames);
    sample(frames, duration, 1 / (std::max(std::abs(f), 1e-6) * frames_of_period), still,
           [&](double s) { return a * (std::sin(tau * f * s + p) - std::sin(p)); });
    frames.smooth = true;
  } else if (name == "mvfile" || name == "mvpredef" || name == "mvrectfile") {
    read_file(m, duration, false, world, frames);
  } else if (name == "mvrotfile") {
    read_file(m, duration, true, world, frames);
  } else return false;
  return true;
}

/// The stroke of a piston for a regular wave of first order (Biesel and Suquet 1951).
double stroke_of(double height, double depth, double period) {
  const double omega2 = tau * tau / (period * period) / 9.81;
  double k = omega2;
  for (int n = 0; n < 100; ++n) k = omega2 / std::tanh(std::max(k * depth, 1e-9)) * 0.5 + 0.5 * k;
  const double kd = k * depth, sh = std::sinh(kd), ch = std::cosh(kd);
  return height * (sh * ch + kd) / (2 * sh * sh);
}

/// A piston that makes regular waves, from the element <piston> of "wavepaddles".
void read_piston(const XmlElement& piston, double end, DsphFrames& frames) {
  const auto value = [&](const char* name, double fallback) {
    return piston.child(name).number("value", fallback);
  };
  const double period = std::max(1e-3, value("waveperiod", 1)), start = value("start", 0),
               ramp = value("ramp", 0) * period;
  const double half = stroke_of(value("waveheight", 0), value("depth", 1), period) / 2;
  const MotionPoint way = from_dsph(piston.child("pistondir").point({1, 0, 0}));
  const double length = norm(way), phase = value("phase", 0) * std::numbers::pi / 180;
  if (value("waveorder", 1) != 1)
    piston.child("waveorder").instead("taken instead: 1, a sinusoidal stroke");
  piston.child("mkbound").skip();
  piston.child("savemotion").display();
  if (!(length > 0)) return;
  const double duration =
      std::min(end, value("duration", 0) > 0 ? start + value("duration", 0) : end);
  for (double t = start; t < duration + period / frames_of_period; t += period / frames_of_period) {
    const double s = t - start, rise = ramp > 0 ? std::min(1.0, s / ramp) : 1;
    const double x =
        half * (rise * std::sin(tau * s / period + phase) - (ramp > 0 ? 0 : std::sin(phase)));
    if (t > start) frames.add(t, (x / length) * way, 0);
    else frames.add(t, {}, 0);
  }
  frames.smooth = true;
}

/// The motions of <objreal>, from its <begin> on, each followed by its `next`.
void read_chain(const XmlElement& object, const DsphWorld& world, DsphFrames& frames) {
  const XmlElement begin = object.child("begin");
  long id = begin.integer("mov", 1);
  const double start = begin.number("start", 0, 0);
  const double end = std::min(world.duration, begin.number("finish", 1e15));
  frames.add(0, {}, 0);
  frames.add(start, {}, 0);
  MotionPoint phase{};
  for (int steps = 0; id > 0 && frames.time() < end - 1e-9 && steps < 1000; ++steps) {
    const std::vector<XmlElement> all = object.children();
    const auto motion = std::find_if(all.begin(), all.end(), [&](const XmlElement& m) {
      return m.has("id") && m.integer("id", 0) == id;
    });
    if (motion == all.end()) break;
    double duration = motion->number("duration", 0);
    if (!(duration > 0)) duration = end;
    duration = std::min(duration, end - frames.time());
    const double before = frames.time();
    if (!add_motion(*motion, duration, world, frames, phase)) {
      motion->missing(
          "this motion has no counterpart: the body stands; set body.position, "
          "body.angle or body.path");
      break;
    }
    id = motion->integer("next", 0);
    if (frames.time() <= before) break;
  }
}

}  // namespace

void read_dsph_bodies(const XmlElement& definition, const XmlElement& special, DsphWorld& world) {
  for (const XmlElement& object : definition.child("motion").children("objreal")) {
    const long mk = object.integer("ref", -1);
    const std::vector<XmlElement> parts = object.children();
    const bool moves = std::any_of(parts.begin(), parts.end(), [](const XmlElement& m) {
      return m.name().starts_with("mv") && m.name() != "mvnull";
    });
    if (moves) world.moved.insert_or_assign(mk, object);
    else object.skip();
  }
  for (const XmlElement& paddle : special.child("wavepaddles").children())
    if (paddle.name() == "piston")
      world.moved.insert_or_assign(paddle.child("mkbound").integer("value", -1), paddle);
    else paddle.missing("this wave maker has no counterpart: it stands; set body.path");
  for (const XmlElement& floating : definition.child("floatings").children("floating"))
    for (const long mk : numbers_of_list(floating.text("mkbound", "")))
      world.floating.insert_or_assign(mk, floating);
}

std::string write_dsph_motion(long mk, const DsphWorld& world, TomlTable& body) {
  if (const auto floating = world.floating.find(mk); floating != world.floating.end()) {
    const XmlElement& f = floating->second;
    body.set("motion", "free");
    const double mass = f.child("massbody").number("value", f.number("massbody", 0));
    const double density = f.number("rhopbody", f.number("relativeweight", 0) * world.rest_density);
    if (mass > 0) body.set("mass", mass);
    else body.set("density", density > 0 ? density : world.rest_density);
    if (!(mass > 0) && !(density > 0))
      f.error("needs rhopbody, relativeweight or massbody; set one");
    return "";
  }
  const XmlElement& object = world.moved.at(mk);
  DsphFrames frames;
  if (object.name() == "piston") read_piston(object, world.duration, frames);
  else read_chain(object, world, frames);
  body.set("motion", "moved");
  if (frames.list.size() < 2) frames.add(1, {}, 0);
  body.set("interpolation", frames.smooth ? "smooth" : "linear");
  double sign = 1;
  if (frames.turns) {
    if (world.flat()) sign = frames.axis.z >= 0 ? 1 : -1;
    else body.set("turn_axis", frames.axis, 3);
    body.set("pivot", frames.pivot, world.dimension);
  }
  std::string keys;
  for (const DsphFrames::Frame& frame : frames.list) {
    TomlTable key;
    key.set("time", frame.time);
    key.set("translation", frame.shift, world.dimension);
    if (frames.turns) key.set("angle", sign * frame.angle * 180 / std::numbers::pi);
    keys += key.item("body.key");
  }
  return keys;
}

}  // namespace freshet
