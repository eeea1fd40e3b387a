#include "app/feeds/feed_runner.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/feeds/pace.h"
#include "base/thread_time.h"

namespace saccade {
namespace {

void logTimes(FrameIndex frame, const StageTimes& times) {
  if (!spdlog::should_log(spdlog::level::debug)) return;
  std::string text;
  for (std::size_t i = 0; i < kStageNames.size(); ++i) {
    text += fmt::format(" {} {:.2f}", kStageNames[i], seconds(times.cpu[i]) * 1e3);
  }
  spdlog::debug("frame {}, CPU ms:{}", frame, text);
}

bool isStopping(const std::shared_ptr<StreamSink>& sink) {
  return sink->session().stopping();
}

}  // namespace

FeedRunner::FeedRunner(std::shared_ptr<IntervalSource> source, const FeedPace& pace, TilePool& pool,
                       Totals& totals, ClientLog& log, const FeedFacts& facts)
    : pool_(pool),
      source_(std::move(source)),
      pace_(pace),
      totals_(totals),
      log_(log),
      facts_(facts),
      clock_(pace.speed) {}

FeedRunner::~FeedRunner() {
  if (thread_.joinable()) thread_.join();
}

bool FeedRunner::add(std::shared_ptr<StreamSink> sink) {
  std::unique_lock lock(mutex_);
  if (ended_) return false;
  newcomers_.push_back(std::move(sink));
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  lock.unlock();
  notifier_->raise();
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

bool FeedRunner::ending() const {
  std::lock_guard lock(mutex_);
  return ended_ || (allStopping() && std::ranges::all_of(newcomers_, isStopping));
}

bool FeedRunner::allStopping() const {
  return std::ranges::all_of(sinks_, isStopping);
}

void FeedRunner::run() {
  flushDenormalsToZero();
  try {
    while ((pace_.frames == 0 || frame_ < pace_.frames) && gather()) step();
    while (!close()) admit();
    for (auto& sink : sinks_) finish(*sink);
  } catch (const Cancelled&) {
    for (auto& sink : sinks_) finish(*sink);
  } catch (const std::exception& fault) {
    fail(fault.what());
  } catch (...) {
    fail("unknown fault");
  }
}

// Allocates nothing, because the fault may be a lack of memory.
void FeedRunner::fail(const char* message) noexcept {
  logFault(message);
  std::vector<std::shared_ptr<StreamSink>> late;
  {
    std::lock_guard lock(mutex_);
    ended_ = true;
    late.swap(newcomers_);
  }
  for (auto* sinks : {&sinks_, &late}) {
    for (auto& sink : *sinks) {
      if (!sink->session().finished() && !sink->fail(message)) logFault("a stream of it cannot be told");
    }
  }
}

void FeedRunner::logFault(const char* message) noexcept {
  try {
    log_.error({}, fmt::format("a feed failed at frame {}: {}", frame_, message));
  } catch (...) {
    spdlog::error("a feed failed at frame {}: {}", frame_, message);  // takes no memory
  }
}

// Waits until the next frame is wanted. False: no stream is left.
bool FeedRunner::gather() {
  while (true) {
    admit();
    endStopped();
    if (sinks_.empty() && close()) return false;
    if (ready()) return true;
    holdClock();
    notifier_->wait([&] { return ready() || needsAttention(); });
  }
}

void FeedRunner::endStopped() {
  for (auto& sink : sinks_) {
    if (sink->session().stopping()) finish(*sink);
  }
  std::lock_guard lock(mutex_);
  std::erase_if(sinks_, [](const auto& sink) { return sink->session().finished(); });
}

// The clock of a feed stands still while a stream holds the feed up.
void FeedRunner::holdClock() {
  clock_.hold();
  for (auto& sink : sinks_) sink->clearLag();
  std::lock_guard lock(mutex_);
  progress_.lag_s = 0;
}

void FeedRunner::admit() {
  std::lock_guard lock(mutex_);
  sinks_.insert(sinks_.end(), newcomers_.begin(), newcomers_.end());
  newcomers_.clear();
}

// Lets nobody join any more. Returns false where somebody has just joined.
bool FeedRunner::close() {
  std::lock_guard lock(mutex_);
  ended_ = newcomers_.empty();
  return ended_;
}

// The source is ready, some stream has a receiver, and every stream with a receiver has room.
bool FeedRunner::ready() const {
  if (!source_->ready()) return false;
  bool any = false;
  for (const auto& sink : sinks_) {
    if (!sink->session().started()) continue;
    if (!sink->session().hasRoom()) return false;
    any = true;
  }
  return any;
}

bool FeedRunner::needsAttention() const {
  std::lock_guard lock(mutex_);
  return !newcomers_.empty() || std::any_of(sinks_.begin(), sinks_.end(),
                                            [](const auto& sink) { return sink->session().stopping(); });
}

void FeedRunner::step() {
  if (now_ == TimeNs{0}) began_ = ChangeNotifier::Clock::now();
  clock_.begin(
      now_, std::none_of(sinks_.begin(), sinks_.end(), [](const auto& sink) { return sink->catchingUp(); }));
  const std::vector<FeedInterval>& views = makeIntervals();
  const double lag_s = clock_.running() ? waitUntilDue(views.front().change.t1) : 0;
  StageTimes times = source_->lastTimes();
  const auto before = threadCpuTime();
  times[Stage::kEvents] += publish(views, lag_s);
  record(times, source_->lastCriticalPath() + (threadCpuTime() - before), lag_s, views.front().ends_frame);
}

// Frames of a feed that keeps its pace are due at a certain time. interrupt() drops what is left of a frame.
PoolHandle FeedRunner::pool() const {
  return {pool_, clock_.running() ? Priority::kUrgent : Priority::kNormal, stop_.get_token()};
}

const std::vector<FeedInterval>& FeedRunner::makeIntervals() {
  const std::vector<FeedInterval>& views = source_->step(pool());
  newest_.set(views.front().change, views.front().frame);
  now_ = views.front().change.t1;
  frame_ = views.front().reachedFrame();
  return views;
}

// Makes the events of all streams, and gives them their packets. Returns the CPU time of the
// channels.
std::chrono::nanoseconds FeedRunner::publish(const std::vector<FeedInterval>& views, double lag_s) {
  std::vector<StreamSink*> started;
  std::vector<std::pair<StreamSink*, std::size_t>> channels;
  for (auto& sink : sinks_) {
    if (!sink->session().started()) continue;
    started.push_back(sink.get());
    for (std::size_t i = 0; i < sink->channels(); ++i) channels.emplace_back(sink.get(), i);
  }
  const auto used = pool().run(static_cast<int>(channels.size()), [&](int i) {
    const auto [sink, channel] = channels[static_cast<std::size_t>(i)];
    sink->process(channel, views[sink->view(channel)]);
  });
  const std::chrono::milliseconds lag(lag_s > kMostLagSeconds ? std::llround(lag_s * 1e3) : 0);
  for (StreamSink* sink : started) {
    const std::uint64_t events_before = sink->events();
    sink->publish(views.front(), lag);
    totals_.events += sink->events() - events_before;
  }
  return used;
}

// Returns by how many seconds `t` is over already.
double FeedRunner::waitUntilDue(TimeNs t) {
  const auto due = clock_.due(t);
  notifier_->waitUntil(due, [&] { return allStopping(); });
  return std::max(0.0, std::chrono::duration<double>(ChangeNotifier::Clock::now() - due).count());
}

void FeedRunner::record(const StageTimes& times, std::chrono::nanoseconds critical_path, double lag_s,
                        bool ends_frame) {
  logTimes(frame_, times);
  totals_.frames += ends_frame ? 1 : 0;
  totals_.add(times);
  frame_cpu_ += times, frame_critical_path_ += critical_path;
  std::lock_guard lock(mutex_);
  progress_.frames = frame_;
  progress_.lag_s = lag_s;
  progress_.cpu += times;
  if (!ends_frame) return;
  const StageTimes frame = std::exchange(frame_cpu_, {});
  progress_.recent_s.add(seconds(frame.total() - frame[Stage::kEvents]));
  progress_.critical_path_s.add(seconds(std::exchange(frame_critical_path_, {})));
}

void FeedRunner::finish(StreamSink& sink) {
  const std::uint64_t events_before = sink.events();
  sink.end(now_, frame_);
  totals_.events += sink.events() - events_before;
  const std::chrono::duration<double> wall = ChangeNotifier::Clock::now() - began_;
  log_.info(sink.user(),
            fmt::format("stream {} ended after {} frames: {} events, {:.3g} of real time",
                        sink.session().id(), frame_, sink.events(), seconds(now_) / wall.count()));
}

}  // namespace saccade
