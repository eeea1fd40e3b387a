#include <cmath>

#include "app/request/refusal.h"
#include "app/request/resolve.h"
#include "base/text_cut.h"

namespace saccade {
namespace {

std::vector<TimeNs> resolveTimes(const v1::Truth& truth, const std::string& field) {
  if (truth.every() > 0) refuse(field + ".times_s", "a channel has either `every` or times");
  std::vector<TimeNs> times;
  double prev = -1;
  for (const double t : truth.times_s()) {
    checkRange(field + ".times_s", t, ranges::kDuration);
    if (t <= prev) refuse(field + ".times_s", "the times do not increase");
    times.push_back(TimeNs(std::llround(t * 1e9)));
    prev = t;
  }
  return times;
}

}  // namespace

TruthConfig resolveTruth(v1::Truth& truth, int index, const FeedConfig& feed) {
  const std::string field = "truth[" + std::to_string(index) + "]";
  if (!findTruth(truth.name())) {
    refuse(field + ".name",
           "there is no truth channel '" + cutText(truth.name(), kMaxEcho) + "'; there are: " + truthNames());
  }
  TruthConfig config{
      .name = truth.name(), .frames = FrameSelection(), .width = feed.width, .height = feed.height};
  if (truth.times_s_size() > 0) {
    config.frames = FrameSelection(resolveTimes(truth, field));
  } else {
    if (truth.every() == 0) truth.set_every(1);
    config.frames = FrameSelection(truth.every());
  }
  return config;
}

}  // namespace saccade
