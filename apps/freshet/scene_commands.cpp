// SPDX-License-Identifier: MIT
/// Commands that only look at scenes: check, scenes, schema.
#include <fmt/format.h>

#include "command.h"
#include "freshet/scene_documents.h"
#include "print.h"
#include "volume_row.h"

namespace freshet::cli {
namespace {

/// A build without some library lists the scenes that want it as well.
std::string title_of(const std::string& name, const std::filesystem::path& file) {
  try {
    return load_scene(file).title;
  } catch (const std::exception&) {
    return fmt::format("(not with this build; `freshet check {}` tells why)", name);
  }
}

}  // namespace

void add_check(Program& program) {
  const auto a = std::make_shared<SceneArguments>();
  const Command check = program.add("check", "Check a scene without running it");
  a->add_to(check);
  check.footer("Example:\n  freshet check my_scene.toml");
  check.action([a] {
    const Scene scene = a->load();
    const auto warnings = scene_warnings(scene);
    print_diagnostics(warnings);
    print_out("{}: {}\n", a->name,
              warnings.empty() ? "a good scene"
                               : fmt::format("valid, with {} warning{}", warnings.size(),
                                             warnings.size() == 1 ? "" : "s"));
    const Derived d = derive(scene);
    for (std::size_t k = 0; k < d.fluids.size(); ++k)
      print_out("  {}: {}\n", volume_name(d, k), volume_row(scene, d.fluids[k]));
    return done;
  });
}

void add_scenes(Program& program) {
  const auto names_only = std::make_shared<bool>(false);
  const Command scenes = program.add("scenes", "List the bundled scenes");
  scenes.flag("--names", *names_only, "print the names only");
  scenes.footer("Example:\n  freshet scenes");
  scenes.action([names_only] {
    for (const auto& [name, file] : scenes_that_come_along()) {
      if (*names_only) print_out("{}\n", name);
      else print_out("{:<20} {}\n", name, printable(title_of(name, file)));
    }
    return done;
  });
}

void add_schema(Program& program) {
  const auto markdown = std::make_shared<bool>(false);
  const Command schema = program.add("schema", "Print the JSON Schema of scenes, for editors");
  schema.flag("--markdown", *markdown, "print the reference of all keys instead");
  schema.footer("Example:\n  freshet schema > scene.schema.json");
  schema.action([markdown] {
    put(*markdown ? scene_reference() : scene_schema());
    return done;
  });
}

}  // namespace freshet::cli
