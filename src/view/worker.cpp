// SPDX-License-Identifier: MIT
#include "view/worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>

namespace freshet::view {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

/// Publishing takes at most this share of a thread's time.
constexpr int publish_share = 25;

}  // namespace

Session::Worker::Worker(const Execution& execution)
    : execution_(execution), newest_(std::make_shared<Snapshot>()), thread_([this] { loop(); }) {}

Session::Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Session::Worker::post(std::function<void()> request) {
  {
    const std::lock_guard lock(mutex_);
    requests_.push_back(std::move(request));
  }
  wake_.notify_all();
}

void Session::Worker::post_and_wait(std::function<void()> request) {
  bool carried_out = false;
  post([&] {
    guard(request);
    const std::lock_guard lock(mutex_);
    carried_out = true;
    idle_.notify_all();
  });
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [&] { return carried_out; });
}

std::shared_ptr<const Snapshot> Session::Worker::newest() {
  wanted_ = true;
  const std::lock_guard lock(mutex_);
  return newest_;
}

std::shared_ptr<const Snapshot> Session::Worker::wait() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [&] { return requests_.empty() && !busy_; });
  return newest_;
}

bool Session::Worker::take_requests() {
  std::unique_lock lock(mutex_);
  while (!requests_.empty() && !quit_) {
    const auto request = std::move(requests_.front());
    requests_.pop_front();
    busy_ = true;
    lock.unlock();
    guard(request);
    lock.lock();
  }
  if (busy_ && (steps_left_ == 0 || !active())) {  // published before others see that all is done
    lock.unlock();
    publish();
    lock.lock();
    busy_ = !requests_.empty();
    idle_.notify_all();
  }
  if (!active() && requests_.empty() && !quit_)
    wake_.wait_for(lock, 250ms, [&] { return !requests_.empty() || quit_; });
  return !quit_;
}

void Session::Worker::guard(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& e) {
    problems_ = e.diagnostics();
  } catch (const std::bad_alloc&) {
    problems_ = {{Diagnostic::Severity::error, "", "out of memory; make particles.spacing larger"}};
  } catch (const std::exception& e) {
    problems_ = {{Diagnostic::Severity::error, "", e.what()}};
  }
}

void Session::Worker::loop() {
  while (take_requests()) {
    watch_file();
    if (!active()) continue;
    advance();
    publish_if_due();
  }
}

void Session::Worker::advance() {
  const std::size_t before = problems_.size();
  std::vector<Diagnostic> kept = std::exchange(problems_, {});
  guard([&] { live_ ? advance_live() : advance_played(); });
  if (!problems_.empty()) {
    failed_ = live_.has_value();
    playing_ = false;
    steps_left_ = 0;
    publish();
  } else if (before > 0) {
    problems_ = std::move(kept);
  }
}

void Session::Worker::advance_live() {
  if (steps_left_ == 0) {
    if (live_->ended()) {
      playing_ = false;
      return publish();
    }
    const Simulation& sim = live_->simulation();
    const auto wait = pace.wait(sim.time() + sim.time_steps().last, Clock::now());
    if (wait > 0ms) {
      publish_if_due();
      std::unique_lock lock(mutex_);
      const bool asked = wake_.wait_for(lock, std::min<Clock::duration>(wait, 50ms),
                                        [&] { return !requests_.empty() || quit_; });
      if (asked || wait > 50ms) return;
    }
  }
  const auto start = Clock::now();
  live_->step();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  step_seconds_ = step_seconds_ == 0 ? seconds : 0.95 * step_seconds_ + 0.05 * seconds;
  if (steps_left_ > 0) --steps_left_;
}

void Session::Worker::advance_played() {
  if (played_->ended()) {
    playing_ = false;
    steps_left_ = 0;
    return publish();
  }
  const double before = played_->time();
  played_->seek(played_->index() + 1);
  if (steps_left_ > 0) {
    --steps_left_;
    return publish();
  }
  pace.wait(before, Clock::now());
  const Clock::duration wait = pace.wait(played_->time(), Clock::now());
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, std::clamp<Clock::duration>(wait, 15ms, 1s),
                 [&] { return !requests_.empty() || quit_; });
}

void Session::Worker::publish_if_due() {
  const auto now = Clock::now();
  if (!wanted_ || now - last_publish_ < publish_share * publish_cost_) return;
  wanted_ = false;
  publish();
}

void Session::Worker::publish() {
  const auto start = Clock::now();
  auto s = std::make_shared<Snapshot>();
  s->number = ++number_;
  s->run = run_;
  s->name = name_;
  s->playing = playing_;
  s->failed = failed_;
  s->step_seconds = step_seconds_;
  s->waiting = waiting_;
  s->problems = problems_;
  s->notice = notice_;
  s->notices = notices_;
  const bool measure = !active() || start - last_measure_ >= publish_share * measure_cost_;
  if (live_) live_->show(*s, measure);
  else if (played_) played_->show(*s);
  if (live_ && measure) {
    last_measure_ = Clock::now();
    measure_cost_ = last_measure_ - start;
  } else if (live_ && measured_ && measured_->run == run_) {
    s->statistics = measured_->statistics;
    s->readings = measured_->readings;
    s->flows = measured_->flows;
  }
  std::shared_ptr<const Snapshot> shown = std::move(s);
  if (measure) measured_ = shown;
  {
    const std::lock_guard lock(mutex_);
    newest_ = std::move(shown);
  }
  last_publish_ = Clock::now();
  publish_cost_ = last_publish_ - start;
}

void Session::Worker::watch_file() {
  const auto now = Clock::now();
  if (watched_.empty() || now - last_watch_ < 250ms) return;
  last_watch_ = now;
  std::error_code ec;
  const auto saved = fs::last_write_time(watched_, ec);
  if (ec || saved == saved_) return;
  saved_ = saved;
  const bool playing = playing_;
  guard([&] {
    begin({watched_, base_, {}});
    playing_ = playing;
    done(fmt::format("loaded {} again", watched_.string()));
  });
  publish();
}

void Session::Worker::done(std::string notice) {
  notice_ = std::move(notice);
  ++notices_;
}

}  // namespace freshet::view
