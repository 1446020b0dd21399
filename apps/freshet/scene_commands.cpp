// SPDX-License-Identifier: MIT
/// Commands that only look at scenes: check, scenes, schema.
#include <fmt/format.h>

#include "command.h"

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

void add_check(CLI::App& app, int& code) {
  const auto a = std::make_shared<SceneArguments>();
  CLI::App* check = app.add_subcommand("check", "Is it a good scene? Nothing is run");
  a->add_to(*check);
  check->footer("Example:\n  freshet check my_scene.toml");
  check->callback([a, &code] {
    const Scene scene = a->load();
    const auto warnings = scene_warnings(scene);
    print_diagnostics(warnings);
    fmt::print("{}: a good scene{}\n", a->name,
               warnings.empty() ? ""
                                : fmt::format(", with {} warning{}", warnings.size(),
                                              warnings.size() == 1 ? "" : "s"));
    code = done;
  });
}

void add_scenes(CLI::App& app, int& code) {
  const auto names_only = std::make_shared<bool>(false);
  CLI::App* scenes = app.add_subcommand("scenes", "List the scenes that come along");
  scenes->add_flag("--names", *names_only, "the names only");
  scenes->footer("Example:\n  freshet scenes");
  scenes->callback([names_only, &code] {
    for (const auto& [name, file] : scenes_that_come_along()) {
      if (*names_only) fmt::print("{}\n", name);
      else fmt::print("{:<20} {}\n", name, title_of(name, file));
    }
    code = done;
  });
}

void add_schema(CLI::App& app, int& code) {
  const auto markdown = std::make_shared<bool>(false);
  CLI::App* schema = app.add_subcommand("schema", "Print the JSON Schema of scenes, for editors");
  schema->add_flag("--markdown", *markdown, "print the reference of all keys instead");
  schema->footer("Example:\n  freshet schema > scene.schema.json");
  schema->callback([markdown, &code] {
    fmt::print("{}", *markdown ? scene_reference() : scene_schema());
    code = done;
  });
}

}  // namespace freshet::cli
