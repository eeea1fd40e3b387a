#include "app/feeds/pace.h"

#include <algorithm>
#include <cmath>

#include "app/admission/limits.h"
#include "app/sequence/channel.h"
#include "app/sequence/stream_rig.h"
#include "base/usable_cpus.h"

namespace saccade {
namespace {

// Of the steps that are measured the first is left out: it also allocates, and knows no light.
constexpr int kLeastSteps = 2, kMostSteps = 4;
constexpr double kEnoughSeconds = 0.25;  // of CPU time: slow frames need no repetition

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// The value rounded down to two digits.
std::string atMost(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number(std::floor(value / unit) * unit);
}

CpuCost operator-(const CpuCost& a, const CpuCost& b) {
  return {a.feed - b.feed, a.sensors - b.sensors, a.critical_path - b.critical_path, a.longest - b.longest};
}

CpuCost operator*(const CpuCost& cost, double factor) {
  return {cost.feed * factor, cost.sensors * factor, cost.critical_path * factor, cost.longest * factor};
}

double longestOf(const std::vector<std::unique_ptr<Channel>>& channels) {
  std::chrono::nanoseconds longest{0};
  for (const auto& channel : channels) longest = std::max(longest, channel->cost());
  return seconds(longest);
}

// How many frame periods pass from the start of a frame to its packets. `feed` is the cost of a second.
double periodsOf(const CpuCost& feed, const CpuSupply& supply) {
  return feed.critical_path / supply.speed +
         std::max(feed.longest / supply.speed, feed.sensors / supply.threads);
}

}  // namespace

CpuCost together(const CpuCost& a, const CpuCost& b) {
  return {std::max(a.feed, b.feed), a.sensors + b.sensors, std::max(a.critical_path, b.critical_path),
          std::max(a.longest, b.longest)};
}

CpuCost measureFrame(const std::shared_ptr<const RenderScene>& scene, const Trajectory& body,
                     const ResolvedStream& stream, const PoolHandle& pool) {
  Rig rig = makeRig(scene, body, stream, pool);
  const auto channels = makeChannels(stream, {}, 0);
  const auto each = [&](const auto& f) {
    return seconds(pool.run(static_cast<int>(channels.size()), [&](int i) { f(*channels[i]); }));
  };
  const bool packet_per_frame = stream.request.timing().packet_per_frame();
  CpuCost spent, first;
  int steps = 0;
  TimeNs first_end{0}, end{0};
  while (steps < kLeastSteps || (steps < kMostSteps && spent.feed + spent.sensors < kEnoughSeconds)) {
    const std::vector<FeedInterval>& views = rig.step(pool);
    spent.feed += seconds(rig.lastTimes().total());
    spent.critical_path += seconds(rig.lastCriticalPath());
    spent.sensors +=
        each([&](Channel& channel) { channel.process(views[channel.view()], packet_per_frame); });
    spent.longest += longestOf(channels);
    end = views.front().change.t1;
    if (++steps == 1) first = spent, first_end = end;
  }
  const auto framesIn = [&](TimeNs t) { return seconds(t) * stream.feed.frame_rate_hz; };
  const double left_s =
      each([](Channel& channel) { channel.flush(); }) / framesIn(end);  // most of the cost of short frames
  CpuCost frame = (spent - first) * (1 / framesIn(end - first_end));
  frame.sensors += left_s;
  frame.longest += left_s / static_cast<double>(channels.size());
  return frame;
}

CpuSupply cpuSupply(const TilePool& pool) {
  const double cpus = usableCpus(), threads = pool.threads(), share = pool.receivedShare();
  return {std::min(cpus, threads * share), std::min(cpus, share), std::min(cpus, threads)};
}

void checkPace(const v1::Timing& timing, const CpuCost& frame, const PaceLoad& taken, const CpuSupply& lately,
               const Limits& limits) {
  const bool joins = frame.feed == 0;
  if (!joins && taken.lag_s > kMostLagSeconds) {
    throw LimitReached(Limit::kCpu, "timing",
                       "a PACED stream is " + number(taken.lag_s) +
                           " s behind its clock; none is taken until it has caught up",
                       kRetrySeconds);
  }
  const CpuSupply idle{lately.most, std::min(1.0, lately.most), lately.most};
  const CpuSupply& supply = joins ? idle : lately;  // other programs slow a running feed in any case
  const double share = limits[Limit::kCpu] / 100;
  const CpuCost own = frame * (timing.frame_rate_hz() * timing.speed());
  const double most = supply.threads * share, free = std::max(0.0, most - taken.total);
  const double need = own.feed + own.sensors, periods = periodsOf(together(taken.feed, own), supply);
  if (need <= free && periods <= share) return;
  std::string message = (joins ? "in each frame its sensors take " : "a frame takes ") +
                        number((frame.feed + frame.sensors) * 1e3) + " ms of CPU, so ";
  message += need > free ? "this stream takes " + number(need) + " threads; " + number(free) + " of " +
                               number(most) + " are free"
                         : "with this stream the time from a frame of its feed to the packets is " +
                               number(periods) + " of its period; " + number(share) + " are allowed";
  const double fits = std::min(free / need, share / periods);
  if (fits > 0 && !joins) {
    message += ": what fits is ";
    if (timing.interval_px() == 0)
      message += "a frame rate of " + atMost(timing.frame_rate_hz() * fits) + " Hz, or ";
    message += "a speed of " + atMost(timing.speed() * fits);
  }
  // Other programs may give back the CPU time that they take now.
  const bool later = need <= idle.threads * share && periodsOf(own, idle) <= share;
  throw LimitReached(Limit::kCpu, "timing", message, later ? kRetrySeconds : 0);
}

}  // namespace saccade
