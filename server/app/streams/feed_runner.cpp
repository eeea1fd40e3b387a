#include "app/streams/feed_runner.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "app/streams/pace.h"
#include "base/thread_time.h"

namespace saccade {
namespace {

Signal::Clock::duration wallTime(TimeNs t, double speed) {
  return std::chrono::duration_cast<Signal::Clock::duration>(
      std::chrono::duration<double>(seconds(t) / speed));
}

void logTimes(FrameIndex frame, const StageTimes& times) {
  if (!spdlog::should_log(spdlog::level::debug)) return;
  std::string text;
  for (std::size_t i = 0; i < kStageNames.size(); ++i) {
    text += fmt::format(" {} {:.2f}", kStageNames[i], seconds(times.cpu[i]) * 1e3);
  }
  spdlog::debug("frame {}, CPU ms:{}", frame, text);
}

}  // namespace

FeedRunner::FeedRunner(std::unique_ptr<Feed> feed, int width, int height, const FeedPace& pace,
                       std::shared_ptr<TilePool> pool, Totals& totals)
    : pool_(std::move(pool)),
      feed_(std::move(feed)),
      pace_(pace),
      totals_(totals),
      luminance_p01_(feed_->firstFrameLuminance(0.01)),
      luminance_p50_(feed_->firstFrameLuminance(0.5)),
      pixel_speed_(feed_->pixelSpeed(pace.frames)),
      snapshot_(width, height) {}

FeedRunner::~FeedRunner() {
  if (thread_.joinable()) thread_.join();
}

bool FeedRunner::add(std::shared_ptr<Outlet> outlet) {
  std::unique_lock lock(mutex_);
  if (ended_) return false;
  newcomers_.push_back(std::move(outlet));
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  lock.unlock();
  signal_->raise();
  return true;
}

FeedProgress FeedRunner::progress() const {
  std::lock_guard lock(mutex_);
  return progress_;
}

void FeedRunner::interrupt() {
  std::lock_guard lock(mutex_);
  if (!newcomers_.empty() || !allStopping()) return;
  ended_ = true;  // nobody may join what ends
  stop_.request_stop();
}

bool FeedRunner::allStopping() const {
  return std::all_of(outlets_.begin(), outlets_.end(),
                     [](const auto& outlet) { return outlet->session().stopping(); });
}

void FeedRunner::run() {
  flushDenormalsToZero();
  try {
    while ((pace_.frames == 0 || frame_ < pace_.frames) && gather()) step();
    while (!close()) admit();
    for (auto& outlet : outlets_) finish(*outlet);
  } catch (const Cancelled&) {
    for (auto& outlet : outlets_) finish(*outlet);
  } catch (const std::exception& fault) {
    giveUp(fault.what());
  } catch (...) {
    giveUp("unknown fault");
  }
}

// Takes no memory of its own: that may be what is missing.
void FeedRunner::giveUp(const char* message) noexcept {
  spdlog::error("a feed failed at frame {}: {}", frame_, message);
  std::vector<std::shared_ptr<Outlet>> late;
  {
    std::lock_guard lock(mutex_);
    ended_ = true;
    late.swap(newcomers_);
  }
  for (auto* outlets : {&outlets_, &late}) {
    for (auto& outlet : *outlets) {
      if (!outlet->session().finished()) outlet->fail(message);
    }
  }
}

// Waits until the next frame is wanted. False: no stream is left.
bool FeedRunner::gather() {
  while (true) {
    admit();
    endStopped();
    if (outlets_.empty() && close()) return false;
    if (ready()) return true;
    hold();
    signal_->wait([&] { return ready() || needsCare(); });
  }
}

void FeedRunner::endStopped() {
  for (auto& outlet : outlets_) {
    if (outlet->session().stopping()) finish(*outlet);
  }
  std::lock_guard lock(mutex_);
  std::erase_if(outlets_, [](const auto& outlet) { return outlet->session().finished(); });
}

// Whoever holds the feed holds its clock.
void FeedRunner::hold() {
  running_ = false;
  for (auto& outlet : outlets_) outlet->hold();
  std::lock_guard lock(mutex_);
  progress_.lag_s = 0;
}

void FeedRunner::admit() {
  std::lock_guard lock(mutex_);
  outlets_.insert(outlets_.end(), newcomers_.begin(), newcomers_.end());
  newcomers_.clear();
}

// From here on nobody can join. False: somebody just has, and is now among the outlets.
bool FeedRunner::close() {
  std::lock_guard lock(mutex_);
  ended_ = newcomers_.empty();
  return ended_;
}

// A receiver has come, and nobody who has one is without room.
bool FeedRunner::ready() const {
  bool any = false;
  for (const auto& outlet : outlets_) {
    if (!outlet->session().started()) continue;
    if (!outlet->session().hasRoom()) return false;
    any = true;
  }
  return any;
}

bool FeedRunner::needsCare() const {
  std::lock_guard lock(mutex_);
  return !newcomers_.empty() || std::any_of(outlets_.begin(), outlets_.end(),
                                            [](const auto& outlet) { return outlet->session().stopping(); });
}

void FeedRunner::step() {
  if (frame_ == 0) began_ = Signal::Clock::now();
  if (!running_ && pace_.speed > 0) wall_zero_ = Signal::Clock::now() - wallTime(now(), pace_.speed);
  running_ = std::none_of(outlets_.begin(), outlets_.end(), [](const auto& o) { return o->catchingUp(); });
  pool_->setUrgent(running_ && pace_.speed > 0);
  pool_->setStop(stop_.get_token());  // of rendering, not of what has been rendered
  const IntensityChange& change = feed_->step();
  pool_->setStop({});
  frame_ = change.frame;
  const double lag_s = running_ ? waitUntilDue(change.t1) : 0;
  StageTimes times = feed_->lastTimes();
  const auto before = threadCpuTime();
  times[Stage::kEvents] += look(change, lag_s);
  snapshot_.take(change);
  record(times, feed_->lastChain() + (threadCpuTime() - before), lag_s);
}

// All streams look at the interval, and get their packets. Returns the CPU time of their sensors.
std::chrono::nanoseconds FeedRunner::look(const IntensityChange& change, double lag_s) {
  std::vector<Outlet*> lookers;
  std::vector<std::pair<Outlet*, std::size_t>> eyes;
  for (auto& outlet : outlets_) {
    if (!outlet->session().started()) continue;
    lookers.push_back(outlet.get());
    for (std::size_t i = 0; i < outlet->eyes(); ++i) eyes.emplace_back(outlet.get(), i);
  }
  const auto used = pool_->run(static_cast<int>(eyes.size()), [&](int i) {
    const auto [outlet, eye] = eyes[static_cast<std::size_t>(i)];
    outlet->look(eye, change);
  });
  const std::chrono::milliseconds lag(lag_s > kMostLagSeconds ? std::llround(lag_s * 1e3) : 0);
  for (Outlet* outlet : lookers) {
    const std::uint64_t events_before = outlet->events();
    outlet->publish(change, lag);
    totals_.events += outlet->events() - events_before;
  }
  return used;
}

// Returns how late it is already.
double FeedRunner::waitUntilDue(TimeNs t) {
  if (pace_.speed == 0) return 0;
  const auto due = wall_zero_ + wallTime(t, pace_.speed);
  signal_->waitUntil(due, [&] { return allStopping(); });
  return std::max(0.0, std::chrono::duration<double>(Signal::Clock::now() - due).count());
}

void FeedRunner::record(const StageTimes& times, std::chrono::nanoseconds chain, double lag_s) {
  logTimes(frame_, times);
  totals_.frames += 1;
  totals_.add(times);
  std::lock_guard lock(mutex_);
  progress_.frames = frame_;
  progress_.lag_s = lag_s;
  progress_.cpu += times;
  progress_.recent_s.add(seconds(times.total() - times[Stage::kEvents]));
  progress_.chain_s.add(seconds(chain));
}

void FeedRunner::finish(Outlet& outlet) {
  outlet.end(now(), frame_);
  const std::chrono::duration<double> wall = Signal::Clock::now() - began_;
  spdlog::info("stream {} ended after {} frames: {} events, {:.3g} of real time", outlet.session().id(),
               frame_, outlet.events(), seconds(now()) / wall.count());
}

}  // namespace saccade
