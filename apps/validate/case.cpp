// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/input_file.h"
#include "freshet/error.h"
#include "scene/keys/keys.h"
#include "scene/keys/parse_toml.h"
#include "validate/validate.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

constexpr InputFile case_file{.noun = "validation case", .remedy = "name a folder with case.toml"};

/// Reads a table of case.toml; what it was not asked for is an error at the end.
class CaseReader {
 public:
  CaseReader(const toml::table& table, const fs::path& file) : table_(table), file_(file) {}

  [[noreturn]] void fail(const toml::node& node, const std::string& why) const {
    const auto at = node.source().begin;
    throw Error(Error::Kind::scene, fmt::format("{}:{}:{}", file_.string(), at.line, at.column),
                why);
  }
  std::string text(const char* key, const std::string& fallback = "") {
    return value<std::string>(key, "a string in quotes").value_or(fallback);
  }
  std::string needed(const char* key) {
    const std::string found = text(key);
    if (found.empty()) fail(table_, fmt::format("{} is missing; set it to a string", key));
    return found;
  }
  std::optional<double> number(const char* key) { return value<double>(key, "a number"); }
  std::vector<double> numbers(const char* key) { return values<double>(key, "numbers"); }
  std::vector<std::string> texts(const char* key) {
    return values<std::string>(key, "strings in quotes");
  }
  const toml::table* table(const char* key) {
    const toml::node* node = find(key);
    if (node && !node->is_table())
      fail(*node, fmt::format("{} must be a table; write [{}]", key, key));
    return node ? node->as_table() : nullptr;
  }
  const toml::array* tables(const char* key) {
    const toml::node* node = find(key);
    if (node && !node->is_array_of_tables())
      fail(*node, fmt::format("{} must be a list of tables; write [[{}]]", key, key));
    return node ? node->as_array() : nullptr;
  }
  void finish() const {
    for (const auto& [key, node] : table_)
      if (!known_.contains(std::string(key)))
        fail(node, fmt::format("unknown key {}; the keys are {}", std::string(key),
                               fmt::join(known_, ", ")));
  }
  const fs::path& file() const { return file_; }

 private:
  const toml::node* find(const char* key) {
    known_.insert(key);
    return table_.get(key);
  }
  template <class T> std::optional<T> value(const char* key, const char* what) {
    const toml::node* node = find(key);
    if (!node) return {};
    const auto found = node->value<T>();
    if (!found) fail(*node, fmt::format("{} must be {}", key, what));
    return found;
  }
  template <class T> std::vector<T> values(const char* key, const char* what) {
    std::vector<T> all;
    const toml::node* node = find(key);
    if (!node) return all;
    if (!node->is_array()) fail(*node, fmt::format("{} must be a list; write [{}]", key, what));
    for (const toml::node& element : *node->as_array()) {
      const auto found = element.value<T>();
      if (!found) fail(element, fmt::format("{} must be a list of {}", key, what));
      all.push_back(*found);
    }
    return all;
  }

  const toml::table& table_;
  const fs::path& file_;
  std::set<std::string> known_;
};

std::string as_text(const toml::node& node) {
  std::ostringstream out;
  if (const auto text = node.value<std::string>(); text && node.is_string()) return *text;
  out << toml::node_view<const toml::node>(node);
  return out.str();
}

ValidationMeasure measure_in(const toml::table& table, const fs::path& file) {
  CaseReader in(table, file);
  ValidationMeasure m;
  m.name = in.needed("name");
  m.table = in.text("table", "observables.csv");
  m.beside = in.text("beside");
  m.x = in.text("x", "time");
  m.y = in.needed("y");
  m.when = in.text("when");
  m.since = in.text("since");
  m.since_when = in.text("since_when");
  m.from = in.number("from");
  m.to = in.number("to");
  m.statistic = in.text("statistic");
  m.expected = in.text("expected");
  m.reference = in.text("reference");
  m.rx = in.text("rx", "x");
  m.ry = in.text("ry", "y");
  m.norm = in.text("norm", "max");
  m.scale = in.number("scale");
  m.align = in.number("align");
  m.bound = in.number("bound");
  m.short_bound = in.number("short_bound");
  m.order = in.number("order");
  m.reason = in.text("reason");
  in.finish();
  if ((m.bound || m.order) && m.reason.empty())
    in.fail(table, fmt::format("measure {} has a bound without a reason; add one", m.name));
  if (m.since.empty() != m.since_when.empty())
    in.fail(table,
            fmt::format("measure {} needs both since and since_when: a table, and the formula "
                        "that starts the time",
                        m.name));
  if (m.statistic.empty() && m.expected.empty() == m.reference.empty())
    in.fail(table, fmt::format("measure {} needs one of expected, reference and statistic; set the "
                               "one that applies",
                               m.name));
  return m;
}

void check_solvers(CaseReader& in, const toml::table& table,
                   const std::vector<std::string>& names) {
  const Words solvers = solver_words();
  for (const std::string& name : names)
    if (std::find(solvers.begin(), solvers.end(), name) == solvers.end())
      in.fail(table,
              fmt::format("unknown solver {}; the solvers are {}", name, fmt::join(solvers, ", ")));
}

/// How often a run is repeated: `repeats`, or the usual number.
int repeats_in(CaseReader& in, const toml::table& table, int usual) {
  const auto repeats = in.number("repeats");
  if (!repeats) return usual;
  if (!(*repeats >= 1 && *repeats <= 99 && *repeats == std::floor(*repeats)))
    in.fail(table, "repeats must be a whole number from 1 to 99");
  return int(*repeats);
}

/// spacings, time steps, or values of what `vary` names: what the runs of a case differ by.
std::vector<double> resolutions_in(CaseReader& in) {
  std::vector<double> all;
  for (const char* list : {"spacings", "steps", "values"})
    for (const double x : in.numbers(list)) all.push_back(x);
  return all;
}

void read_resolutions(ValidationCase& c, CaseReader& in, const toml::table& root) {
  const bool steps = root.contains("steps"), values = root.contains("values");
  c.varied = in.text("vary", steps ? "time.step" : "particles.spacing");
  c.unit = in.text("unit", steps ? "s" : "m");
  c.resolutions = resolutions_in(in);
  if (c.resolutions.empty() || int(root.contains("spacings")) + int(steps) + int(values) != 1)
    in.fail(root,
            "set exactly one of spacings, steps and values, to a list of at least one number");
  if (values != root.contains("vary"))
    in.fail(root, "set vary and values together: a key of the scene, and its values");
  std::sort(c.resolutions.begin(), c.resolutions.end(), std::greater<>());
}

ValidationMiss miss_in(const toml::table& table, const ValidationCase& c, const fs::path& file) {
  CaseReader in(table, file);
  ValidationMiss miss{in.texts("solvers"), in.texts("measures"), resolutions_in(in),
                      in.needed("reason")};
  check_solvers(in, table, miss.solvers);
  for (const std::string& name : miss.measures)
    if (std::none_of(c.measures.begin(), c.measures.end(), [&](const ValidationMeasure& m) {
          return name == m.name || (m.order && name == order_of(m));
        }))
      in.fail(table, fmt::format("unknown measure {}; name a measure of this case", name));
  in.finish();
  return miss;
}

}  // namespace

ValidationCase read_validation_case(const fs::path& folder) {
  const fs::path file = folder / "case.toml";
  const toml::table root = parse_toml(read_input(file, case_file), file.string(), case_file.noun);
  CaseReader in(root, file);
  ValidationCase c;
  c.name = folder.filename().string();
  c.folder = folder;
  c.title = in.needed("title");
  c.text = in.text("text");
  c.source = in.needed("source");
  c.scene = folder / in.text("scene", "scene.toml");
  c.solvers = in.texts("solvers");
  check_solvers(in, root, c.solvers);
  if (c.solvers.empty()) in.fail(root, "solvers must list at least one solver");
  read_resolutions(c, in, root);
  c.repeats = repeats_in(in, root, 1);
  if (const toml::table* set = in.table("set"))
    for (const auto& [solver, keys] : *set) {
      if (!keys.is_table()) in.fail(keys, "write [set.all] or [set.SOLVER], with keys below it");
      auto& group = c.set.emplace_back(solver == "all" ? "" : std::string(solver.str()),
                                       std::vector<std::pair<std::string, std::string>>{});
      for (const auto& [key, value] : *keys.as_table())
        group.second.emplace_back(std::string(key), as_text(value));
    }
  if (const toml::table* shorter = in.table("short")) {
    CaseReader s(*shorter, file);
    c.short_form = {s.texts("solvers"), resolutions_in(s), s.number("end"), s.text("cost"),
                    repeats_in(s, *shorter, c.repeats)};
    check_solvers(s, *shorter, c.short_form->solvers);
    s.finish();
  }
  if (const toml::array* measures = in.tables("measure"))
    for (const toml::node& m : *measures) c.measures.push_back(measure_in(*m.as_table(), file));
  if (c.measures.empty()) in.fail(root, "no [[measure]]; add at least one");
  if (const toml::array* misses = in.tables("fails"))
    for (const toml::node& m : *misses) c.misses.push_back(miss_in(*m.as_table(), c, file));
  in.finish();
  return c;
}

std::vector<ValidationCase> validation_cases(const fs::path& folder) {
  std::vector<ValidationCase> all;
  std::error_code ec;
  for (const auto& entry : fs::directory_iterator(folder, ec))
    if (fs::is_regular_file(entry.path() / "case.toml", ec))
      all.push_back(read_validation_case(entry.path()));
  std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.name < b.name; });
  return all;
}

}  // namespace freshet
