#include "app/feed_runner.h"

#include <spdlog/spdlog.h>

#include <algorithm>

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

void FeedRunner::run() {
  flushDenormalsToZero();
  try {
    while ((pace_.frames == 0 || frame_ < pace_.frames) && gather()) step();
    while (!close()) admit();
    for (auto& outlet : outlets_) finish(*outlet);
  } catch (const std::exception& fault) {
    spdlog::error("a feed failed at frame {}: {}", frame_, fault.what());
    while (!close()) admit();
    for (auto& outlet : outlets_) outlet->fail(fault.what());
  }
}

// Waits until the next frame is wanted. False: no stream is left.
bool FeedRunner::gather() {
  while (true) {
    admit();
    std::erase_if(outlets_, [&](const auto& outlet) {
      const bool stopping = outlet->session().stopping();
      if (stopping) finish(*outlet);
      return stopping;
    });
    if (outlets_.empty() && close()) return false;
    if (ready()) return true;
    running_ = false;  // whoever holds the feed holds its clock
    signal_->wait([&] { return ready() || needsCare(); });
  }
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
  const IntensityChange& change = feed_->step();
  frame_ = change.frame;
  const double lag_s = running_ ? waitUntilDue(change.t1) : 0;
  StageTimes times = feed_->lastTimes();
  for (auto& outlet : outlets_) {
    if (!outlet->session().started()) continue;
    const std::uint64_t events_before = outlet->events();
    times[Stage::kEvents] += outlet->publish(change, *pool_);
    totals_.events += outlet->events() - events_before;
  }
  snapshot_.take(change);
  record(times, lag_s);
}

// Returns how late it is already.
double FeedRunner::waitUntilDue(TimeNs t) {
  if (pace_.speed == 0) return 0;
  const auto due = wall_zero_ + wallTime(t, pace_.speed);
  const auto all_stopping = [&] {
    return std::all_of(outlets_.begin(), outlets_.end(),
                       [](const auto& outlet) { return outlet->session().stopping(); });
  };
  signal_->waitUntil(due, all_stopping);
  return std::max(0.0, std::chrono::duration<double>(Signal::Clock::now() - due).count());
}

void FeedRunner::record(const StageTimes& times, double lag_s) {
  logTimes(frame_, times);
  totals_.frames += 1;
  totals_.add(times);
  std::lock_guard lock(mutex_);
  progress_.frames = frame_;
  progress_.lag_s = lag_s;
  progress_.cpu += times;
  progress_.recent_s.add(seconds(times.total() - times[Stage::kEvents]));
}

void FeedRunner::finish(Outlet& outlet) {
  outlet.end(now(), frame_);
  const std::chrono::duration<double> wall = Signal::Clock::now() - began_;
  spdlog::info("stream {} ended after {} frames: {} events, {:.3g} of real time", outlet.session().id(),
               frame_, outlet.events(), seconds(now()) / wall.count());
}

}  // namespace saccade
