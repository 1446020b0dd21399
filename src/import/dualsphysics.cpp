// SPDX-License-Identifier: MIT
#include "import/dualsphysics.h"

#include <algorithm>

#include "core/input_file.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

std::string dsph_periodic_axes(const DsphWorld& world) {
  std::string axes;
  for (int k = 0; k < 3; ++k)
    if (world.periodic >> k & 1u) axes += "xyz"[k];
  return axes;
}

}  // namespace

ImportedScene import_dualsphysics(const std::string& xml, const fs::path& file,
                                  const fs::path& folder) {
  const XmlNode root = parse_xml(xml, file.string());
  XmlFindings findings(xml, root, file.string());
  const XmlElement scene(&root, findings);
  const XmlElement definition = scene.child("casedef"), execution = scene.child("execution");
  if (root.name != "case" || !definition) {
    findings.error("",
                   "is not a case of DualSPHysics: it needs <case> with <casedef>; name a "
                   "file such as Case_Def.xml");
    findings.throw_errors();
  }
  const XmlElement constants = definition.child("constantsdef"),
                   parameters = execution.child("parameters");
  DsphWorld world;
  world.from = file.parent_path();
  world.to = folder;
  draw_dsph_case(definition.child("geometry"), world, findings);
  read_dsph_constants(constants, world);
  read_dsph_axes(parameters, world);
  read_dsph_bodies(definition, execution.child("special"), world);
  const DsphSettings settings = read_dsph_settings(constants, parameters, world);
  const std::string fluids =
      write_dsph_fluids(definition.child("initials"), definition.child("geometry"), world);
  DsphWalls walls = write_dsph_walls(dsph_room(parameters, world), world);
  definition.child("mkconfig").display();
  execution.child("particles").display();  // what GenCase adds
  execution.child("constants").display();
  for (const char* attribute : {"app", "date"}) scene.text(attribute, "");
  definition.text("requiredversion", "");
  finish_xml(root, findings);
  findings.throw_errors();

  TomlTable title;
  title.set("title", file.stem().string());
  walls.domain.set("gravity", world.gravity, world.dimension);
  if (world.periodic != 0) walls.domain.set("periodic", dsph_periodic_axes(world));
  ImportedScene result;
  result.notes = std::move(findings.notes);
  result.toml = comments_of(file.filename().string(), "DualSPHysics", result.notes) + "\n" +
                title.lines() + walls.domain.table("domain") +
                settings.particles.table("particles") + fluids + walls.tables +
                settings.solver.table("solver") + walls.walls.table("walls") +
                settings.time.table("time") + settings.output.table("output");
  return result;
}

ImportedScene import_dualsphysics(const fs::path& file, const fs::path& folder) {
  constexpr InputFile rules{.noun = "case file",
                            .remedy = "name a case of DualSPHysics (*.xml)",
                            .may_be_empty = true,
                            .largest = 16u << 20};
  return import_dualsphysics(read_input(file, rules), file, folder);
}

}  // namespace freshet
