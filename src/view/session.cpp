// SPDX-License-Identifier: MIT
#include "view/session.h"

#include <fmt/format.h>

#include <algorithm>

#include "freshet/checkpoint_file.h"
#include "freshet/scene_keys.h"
#include "io/files.h"
#include "view/worker.h"

namespace freshet::view {

namespace fs = std::filesystem;

namespace {

/// Sets a key in a list of overrides; the last one of a key counts.
void put(std::vector<Override>& list, const Override& change) {
  std::erase_if(list, [&](const Override& o) { return o.first == change.first; });
  list.push_back(change);
}

}  // namespace

void Session::Worker::open(const fs::path& path, const std::vector<Override>& overrides) {
  std::error_code ec;
  if (!fs::is_directory(path, ec)) {
    base_ = overrides;
    return begin({path, overrides, {}});
  }
  auto opened = std::make_unique<PlayedRun>(path);
  live_.reset();
  played_ = std::move(opened);
  watched_.clear();
  base_ = overrides_ = waiting_ = {};
  name_ = path.string();
  problems_.clear();
  playing_ = failed_ = false;
  steps_left_ = 0;
  ++run_;
  pace.restart();
}

void Session::Worker::replay(const ActionLog& log) {
  base_ = log.overrides;
  begin(log);
}

void Session::Worker::begin(const ActionLog& log) {
  std::error_code ec;
  saved_ = fs::last_write_time(log.scene, ec);
  watched_ = log.scene;  // also if it cannot be loaded: it is loaded when it is saved
  if (!live_ && !played_) name_ = log.scene.string();
  LiveRun opened(log, execution_);
  live_.emplace(std::move(opened));
  name_ = log.scene.string();
  played_.reset();
  overrides_ = log.overrides;
  waiting_.clear();
  problems_.clear();
  playing_ = failed_ = false;
  steps_left_ = 0;
  step_seconds_ = 0;
  ++run_;
  pace.restart();
}

void Session::Worker::play(bool playing) {
  playing_ = playing && !failed_;
  if (!playing) steps_left_ = 0;
  if (playing && played_ && played_->ended()) played_->seek(0);
  pace.restart();
}

void Session::Worker::step(std::int64_t count) {
  playing_ = false;
  if ((live_ || played_) && !failed_) steps_left_ += count;
}

void Session::Worker::restart() {
  if (played_) return played_->seek(0);
  if (watched_.empty()) return;
  const bool playing = playing_;
  const std::vector<Override> kept = overrides_;
  begin({watched_, kept, {}});
  playing_ = playing;
  done("started again");
}

LiveRun& Session::Worker::live(const char* request) {
  if (!live_)
    throw Error(Error::Kind::scene, "",
                fmt::format("{} needs a scene; a finished run is only shown", request));
  return *live_;
}

void Session::Worker::change(const Override& change) {
  LiveRun& run = live("a change");
  if (may_change_while_running(change.first)) {
    run.change(change);
    done(change.first + " changed");
  } else {
    auto all = overrides_;
    put(all, change);
    load_scene(watched_, all);  // throws where the changed scene is invalid
    put(waiting_, change);
  }
  put(overrides_, change);
  problems_.clear();
}

void Session::Worker::drop_waiting() {
  for (const Override& w : waiting_)
    std::erase_if(overrides_, [&](const Override& o) { return o.first == w.first; });
  for (const Override& b : base_)
    if (std::none_of(overrides_.begin(), overrides_.end(),
                     [&](const Override& o) { return o.first == b.first; }))
      overrides_.push_back(b);
  waiting_.clear();
}

void Session::Worker::push(const std::optional<Push>& push) { live("a push").push(push); }

void Session::Worker::seek(std::size_t frame) {
  if (!played_) return;
  played_->seek(frame);
  pace.restart();
}

void Session::Worker::save_scene(const fs::path& file) {
  const LiveRun& run = live("saving a scene");
  const std::string text =
      waiting_.empty() ? run.simulation().scene().source : load_scene(watched_, overrides_).source;
  const bool own =
      !watched_.empty() && fs::weakly_canonical(file) == fs::weakly_canonical(watched_);
  write_file(file, text);
  std::error_code ec;
  if (own) saved_ = fs::last_write_time(file, ec);  // not to be loaded again
  done("wrote " + file.string());
}

void Session::Worker::save_checkpoint(const fs::path& file) {
  freshet::save_checkpoint(live("a checkpoint").simulation(), file);
  done("wrote " + file.string());
}

void Session::Worker::save_log(const fs::path& file) {
  ActionLog log = live("a log").log();
  log.scene = fs::absolute(log.scene);
  write_file(file, log.text());
  done("wrote " + file.string());
}

Session::Session(const Execution& execution) : worker_(std::make_unique<Worker>(execution)) {}
Session::~Session() = default;

void Session::open(const fs::path& path, const std::vector<Override>& overrides) {
  worker_->post([w = worker_.get(), path, overrides] { w->open(path, overrides); });
}
void Session::replay(const ActionLog& log) {
  worker_->post([w = worker_.get(), log] { w->replay(log); });
}
void Session::play(bool playing) {
  worker_->post([w = worker_.get(), playing] { w->play(playing); });
}
void Session::step(std::int64_t count) {
  worker_->post([w = worker_.get(), count] { w->step(count); });
}
void Session::restart() {
  worker_->post([w = worker_.get()] { w->restart(); });
}
void Session::set_pace(double pace) {
  worker_->post([w = worker_.get(), pace] { w->pace.set_limit(pace); });
}
void Session::change(const Override& change) {
  worker_->post([w = worker_.get(), change] { w->change(change); });
}
void Session::drop_waiting() {
  worker_->post([w = worker_.get()] { w->drop_waiting(); });
}
void Session::push(const std::optional<Push>& push) {
  worker_->post([w = worker_.get(), push] { w->push(push); });
}
void Session::seek(std::size_t frame) {
  worker_->post([w = worker_.get(), frame] { w->seek(frame); });
}
void Session::save_scene(const fs::path& file) {
  worker_->post([w = worker_.get(), file] { w->save_scene(file); });
}
void Session::save_checkpoint(const fs::path& file) {
  worker_->post([w = worker_.get(), file] { w->save_checkpoint(file); });
}
void Session::save_log(const fs::path& file) {
  worker_->post([w = worker_.get(), file] { w->save_log(file); });
}
std::shared_ptr<const Snapshot> Session::newest() { return worker_->newest(); }
std::shared_ptr<const Snapshot> Session::wait() { return worker_->wait(); }
std::string Session::state_sha256() {
  worker_->wait();
  std::string digest;
  worker_->post_and_wait([&] {
    if (const Simulation* sim = worker_->simulation()) digest = sim->state_sha256();
  });
  return digest;
}

}  // namespace freshet::view
