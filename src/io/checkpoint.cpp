// SPDX-License-Identifier: MIT
#include "io/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>

#include "core/check_checkpoint.h"
#include "core/input_file.h"
#include "core/sha256.h"
#include "freshet/error.h"
#include "freshet/version.h"
#include "io/check_record.h"
#include "io/hdf5.h"

namespace freshet {

// The contents of run.json. A change here is a change of the format.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TimeSteps, last, last_ruled, min, max, ruled, retried)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SolveStatistics, name, tolerance, solves, iterations,
                                   most_iterations, not_converged, last_iterations, last_error,
                                   worst_error)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Warning, kind, message, first_step, last_step, worst_step,
                                   first_time, looks, worst, bound, cannot_be_right)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WatchRecord::Track, lasting, fatal, steps)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WatchRecord::Particle, id, x, value)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WatchRecord, warnings, tracks, steps_watched, first_step,
                                   first_compression, first_bound, first_densest, last_step,
                                   last_fastest, not_converged)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Flow, kind, name, particles, volume, rate, waiting)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TableRecord, header, bytes, scheduled, sha256, scheduled_sha256)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SeriesRecord, times, scheduled)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Simulation::Moment, time, impulses, passed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunRecord, scene_name, seconds, observed, wall_forces, flows,
                                   tables, series, written)

namespace {

using JsonHeader = nlohmann::json;

// The format changes with whatever makes an older program misread a newer file, or the reverse.
constexpr int format = 5;
constexpr std::string_view magic = "Freshet checkpoint\n";
constexpr std::size_t block = 512;  // HDF5 searches its signature at 0, 512, 1024 ...
const std::string no_digest(64, '0');

/// Replaces infinity and NaN by the largest double, because JSON has neither.
double finite(double x) {
  constexpr double most = std::numeric_limits<double>::max();
  return std::isnan(x) ? most : std::clamp(x, -most, most);
}

constexpr const char* number_words[] = {"int32", "uint64", "float32", "float64"};

StateArray::Number number_of(const std::string& word) {
  const auto it = std::find(std::begin(number_words), std::end(number_words), word);
  if (it == std::end(number_words)) throw std::runtime_error("no such numbers: " + word);
  return StateArray::Number(it - std::begin(number_words));
}

/// Calls f with a value of the array's number type.
template <class F> void with_number(StateArray::Number number, F f) {
  switch (number) {
    case StateArray::Number::int32:
      return f(std::int32_t());
    case StateArray::Number::uint64:
      return f(std::uint64_t());
    case StateArray::Number::float32:
      return f(float());
    case StateArray::Number::float64:
      return f(double());
  }
}

void write_array(Hdf5Writer& file, const Checkpoint::Array& a) {
  with_number(a.number, [&](auto number) {
    using T = decltype(number);
    file.write(a.name,
               std::span(reinterpret_cast<const T*>(a.bytes.data()), a.bytes.size() / sizeof(T)),
               std::size_t(a.components));
  });
}

void read_array(const Hdf5Reader& file, Checkpoint::Array& a) {
  with_number(a.number, [&](auto number) {
    std::vector<decltype(number)> values;
    file.read(a.name, values);
    const auto bytes = std::as_bytes(std::span(values));
    a.bytes.assign(bytes.begin(), bytes.end());
  });
  if (a.bytes.size() != a.StateArray::bytes()) throw std::runtime_error("sizes differ: " + a.name);
}

WatchRecord finite(WatchRecord w) {
  for (Warning& warning : w.warnings) warning.worst = finite(warning.worst);
  w.first_compression = finite(w.first_compression);
  w.first_bound = finite(w.first_bound);
  for (WatchRecord::Particle* p : {&w.first_densest, &w.last_fastest}) {
    p->value = finite(p->value);
    for (double& x : p->x) x = finite(x);
  }
  return w;
}

std::vector<SolveStatistics> finite(std::vector<SolveStatistics> solves) {
  for (SolveStatistics& s : solves) {
    s.last_error = finite(s.last_error);
    s.worst_error = finite(s.worst_error);
  }
  return solves;
}

JsonHeader json_of(const RunCheckpoint& c) {
  JsonHeader arrays = JsonHeader::array();
  for (const Checkpoint::Array& a : c.arrays)
    arrays.push_back({{"name", a.name},
                      {"count", a.count},
                      {"components", a.components},
                      {"number", number_words[int(a.number)]}});
  JsonHeader json{{"steps", c.steps},
                  {"time", c.time},
                  {"edited", c.edited},
                  {"walls_sha256", c.walls_sha256},
                  {"time_steps", c.time_steps},
                  {"solves", finite(c.solves)},
                  {"retries_help", c.retries_help},
                  {"watch", finite(c.watch)},
                  {"run", c.run},
                  {"arrays", arrays}};
  if (const auto& video = c.run.video)
    json["video"] = {{"file", video->file.string()}, {"fps", video->fps}, {"speed", video->speed}};
  return json;
}

void read_json(const JsonHeader& json, RunCheckpoint& c) {
  json.at("steps").get_to(c.steps);
  json.at("time").get_to(c.time);
  json.at("edited").get_to(c.edited);
  json.at("walls_sha256").get_to(c.walls_sha256);
  json.at("time_steps").get_to(c.time_steps);
  json.at("solves").get_to(c.solves);
  json.at("retries_help").get_to(c.retries_help);
  json.at("watch").get_to(c.watch);
  json.at("run").get_to(c.run);
  if (const auto video = json.find("video"); video != json.end())
    c.run.video = {video->at("file").get<std::string>(), video->at("fps"), video->at("speed")};
  for (const JsonHeader& a : json.at("arrays"))
    c.arrays.push_back({{a.at("name"), nullptr, a.at("count"), a.at("components"),
                         number_of(a.at("number")), StateArray::Role::other},
                        {}});
}

/// The block of 512 bytes before the HDF5 data.
std::string header(int file_format, std::string_view version, std::size_t bytes,
                   const std::string& digest) {
  std::string text = fmt::format("{}format {}\nversion {}\nbytes {}\nsha256 {}\n", magic,
                                 file_format, version, bytes, digest);
  text.resize(block, '\n');
  return text;
}

std::string digest_of(std::string_view head, std::string_view body) {
  Sha256 sha;
  sha.add(head.data(), head.size());
  sha.add(body.data(), body.size());
  return sha.hex();
}

struct Header {
  int format = 0;
  std::string version, digest;
  std::size_t bytes = 0;
};

std::optional<Header> parse_header(std::string_view bytes) {
  if (!bytes.starts_with(magic)) return {};
  std::istringstream in{std::string(bytes.substr(magic.size(), block - magic.size()))};
  Header h;
  std::string words[4];
  if (!(in >> words[0] >> h.format >> words[1] >> h.version >> words[2] >> h.bytes >> words[3] >>
        h.digest))
    return {};
  const bool known =
      words[0] == "format" && words[1] == "version" && words[2] == "bytes" && words[3] == "sha256";
  return known ? std::optional(h) : std::nullopt;
}

[[noreturn]] void fail(const std::string& file, const std::string& why) {
  throw Error(Error::Kind::run, file, why);
}

/// Reads the HDF5 data, whose digest has been checked.
RunCheckpoint read_body(std::string_view body, const std::string& file_name) {
  RunCheckpoint c;
  const Hdf5Reader file(body, file_name);
  c.scene = file.read_text("scene.toml");
  read_json(JsonHeader::parse(file.read_text("run.json")), c);
  for (Checkpoint::Array& a : c.arrays) read_array(file, a);
  return c;
}

}  // namespace

void prepare_checkpoints() { start_hdf5(); }

std::string encode_checkpoint(const RunCheckpoint& c) {
  Hdf5Writer file;
  file.write_text("scene.toml", c.scene);
  file.write_text("run.json", json_of(c).dump(2, ' ', false, JsonHeader::error_handler_t::replace));
  for (const Checkpoint::Array& a : c.arrays) write_array(file, a);
  return sealed_checkpoint(file.bytes());
}

std::string sealed_checkpoint(std::string_view body) {
  const std::size_t size = block + body.size();
  const std::string digest = digest_of(header(format, FRESHET_VERSION, size, no_digest), body);
  return header(format, FRESHET_VERSION, size, digest).append(body);
}

RunCheckpoint decode_checkpoint(std::string_view bytes, const std::string& file) {
  if (bytes.size() < block && magic.starts_with(bytes.substr(0, magic.size())))
    fail(file, fmt::format("this checkpoint is torn: {} bytes of it are here", bytes.size()));
  const auto h = parse_header(bytes);
  if (!h) fail(file, "this is no checkpoint of Freshet, or its first bytes are damaged");
  if (h->format != format)
    fail(file,
         fmt::format("this checkpoint has format {}, written by Freshet {}; this program, Freshet "
                     "{}, reads format {}; go on with that version",
                     h->format, h->version, FRESHET_VERSION, format));
  if (bytes.size() < h->bytes)
    fail(file, fmt::format("this checkpoint is torn: {} of its {} bytes are here", bytes.size(),
                           h->bytes));
  const std::string_view body = bytes.substr(block);
  if (bytes.substr(0, block) != header(h->format, h->version, bytes.size(), h->digest) ||
      h->digest != digest_of(header(h->format, h->version, h->bytes, no_digest), body))
    fail(file, "this checkpoint is damaged: its bytes are not those that its SHA-256 was made of");
  // not a damaged file, as the digest is correct: another program wrote it
  RunCheckpoint c;
  try {
    c = read_body(body, file);
  } catch (const Error& e) {
    fail(file, fmt::format("this checkpoint is invalid: {}", e.diagnostics().front().message));
  } catch (const std::exception& e) {
    fail(file, fmt::format("this checkpoint is invalid: {}; use another checkpoint", e.what()));
  }
  try {
    check_checkpoint(c);
    check_record(c.run);
  } catch (const Error& e) {
    fail(file, e.diagnostics().front().message);
  }
  return c;
}

RunCheckpoint read_checkpoint(const std::filesystem::path& file) {
  constexpr InputFile checkpoint_file{
      .noun = "checkpoint", .remedy = "use another checkpoint", .kind = Error::Kind::run};
  return decode_checkpoint(read_input(file, checkpoint_file), file.string());
}

std::set<std::string> checkpoint_names(const std::filesystem::path& folder) {
  std::set<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder / checkpoint_folder, none)) {
    std::string name = entry.path().filename().string();
    if (name.ends_with(".part")) name.resize(name.size() - 5);
    if (name.starts_with("step_") && name.ends_with(".h5")) names.insert(name);
  }
  return names;
}

std::vector<std::filesystem::path> checkpoints_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const std::string& name : checkpoint_names(folder))
    if (std::filesystem::exists(folder / checkpoint_folder / name, none))
      files.push_back(folder / checkpoint_folder / name);
  std::sort(files.begin(), files.end(), std::greater<>());
  return files;
}

}  // namespace freshet
