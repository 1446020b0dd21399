// SPDX-License-Identifier: MIT
/// The parts of a case of DualSPHysics. Each part reads its elements of the XML and returns tables
/// of TOML.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/dsph_frame.h"
#include "import/dsph_lattice.h"
#include "import/toml_text.h"
#include "import/xml_element.h"

namespace freshet {

/// A side of a box: low and high x, y, z. y points up.
enum DsphSide : unsigned { x_low = 1, x_high = 2, y_low = 4, y_high = 8, z_low = 16, z_high = 32 };
constexpr unsigned all_dsph_sides = 63;

/// What a drawing command drew, in the coordinates of Freshet.
struct DsphShape {
  enum class Kind { box, sphere, cylinder, profile, mesh };
  using Point = Vec<3, double>;

  XmlElement element;
  Kind kind;
  std::int16_t mark;  ///< as in the lattice
  DsphFrame frame;
  Point low{}, high{};  ///< of a box, before the frame; ends of a cylinder; `low`: of a sphere
  double radius = 0;    ///< of a sphere or a cylinder
  bool solid = true;    ///< a box or a profile has an inside
  unsigned sides = all_dsph_sides;  ///< of a box, if it is not solid
  std::vector<Point> points{};      ///< of a profile, which is a prism along z
  std::vector<bool> shown{};        ///< its sides, from each point to the next
  double z_low = 0, z_high = 0;
  std::string file{};  ///< of a mesh

  /// "mk" of the case.
  long mk() const { return (mark > 0 ? mark : -mark) - 1; }
};

/// What all parts need to know.
struct DsphWorld {
  using Point = Vec<3, double>;

  std::filesystem::path from;  ///< folder of the XML file
  std::filesystem::path to;    ///< folder of the TOML
  int dimension = 3;
  double dp = 0;       ///< [m]
  double support = 0;  ///< [m]
  double plane_z = 0;  ///< of a case in 2D
  double duration = 1;
  Point gravity{0, -9.81, 0};
  double rest_density = 1000;
  bool hydrostatic = true;
  std::optional<double> viscosity;  ///< [Pa s]; artificial viscosity without
  unsigned periodic = 0;            ///< 1: x, 2: y, 4: z
  std::unique_ptr<DsphLattice> lattice;
  std::vector<DsphShape> shapes;               ///< boundaries
  std::map<long, XmlElement> moved, floating;  ///< by mk

  bool flat() const { return dimension == 2; }
  /// The level of the fluid above its lowest place [m].
  double water_height() const;
  /// Whether places of fluid are inside a shape.
  bool holds_fluid(const DsphShape& shape) const;
};

/// "definition", and the commands that draw.
void draw_dsph_case(const XmlElement& geometry, DsphWorld& world, ImportFindings& findings);
/// Marks the places of a shape.
void mark_dsph_shape(const DsphShape& shape, DsphWorld& world);
/// Whether a point is in a shape, or closer to it than `beyond`.
bool is_in_dsph_shape(const DsphShape& shape, const Vec<3, double>& p, double beyond);

/// "constantsdef": gravity, density and the smoothing length.
struct DsphSettings {
  TomlTable particles, solver, time, output;
};
void read_dsph_constants(const XmlElement& constants, DsphWorld& world);
/// The constants and "parameters" after the geometry is drawn.
DsphSettings read_dsph_settings(const XmlElement& constants, const XmlElement& parameters,
                                DsphWorld& world);
/// "parameters" that the geometry needs: periodic axes and the end of the run.
void read_dsph_axes(const XmlElement& parameters, DsphWorld& world);
/// The box of "simulationdomain".
Bounds dsph_room(const XmlElement& parameters, const DsphWorld& world);

/// The tables [domain], [walls], [[wall]] and [[body]].
struct DsphWalls {
  TomlTable domain, walls;
  std::string tables;
};
DsphWalls write_dsph_walls(const Bounds& room, DsphWorld& world);
/// The shape of a prism: tables without a name.
std::vector<TomlTable> tables_of_profile(const DsphShape& shape, const DsphWorld& world);
/// "[[x, y], ...]"
std::string polygon_of(const std::vector<Vec<3, double>>& points);
/// The tables [[fluid]].
std::string write_dsph_fluids(const XmlElement& initials, const XmlElement& geometry,
                              const DsphWorld& world);

/// "motion", "floatings" and "wavepaddles": which mk moves.
void read_dsph_bodies(const XmlElement& definition, const XmlElement& special, DsphWorld& world);
/// The motion of a body, after its shape. Returns its key frames.
std::string write_dsph_motion(long mk, const DsphWorld& world, TomlTable& body);

}  // namespace freshet
