#include <algorithm>
#include <cmath>

#include "app/request/refusal.h"
#include "app/request/resolve_parts.h"
#include "app/request/resolve_truth.h"
#include "base/hash_rng.h"
#include "base/text_cut.h"
#include "truth/truth_source.h"

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

using Setting = TruthChannelInfo::Setting;

void resolveBias(v1::Truth& truth, const std::string& field, Setting setting, TruthConfig& config) {
  if (setting != Setting::kBias) {
    if (truth.has_bias()) refuse(field + ".bias", truth.name() + " has no bias");
    return;
  }
  if (!truth.has_bias()) truth.set_bias(config.bias);
  checkRange(field + ".bias", truth.bias(), ranges::kBias);
  config.bias = truth.bias();
}

void resolveExposure(v1::Truth& truth, const std::string& field, Setting setting, TruthConfig& config) {
  if (setting != Setting::kExposure) {
    if (truth.has_aps()) refuse(field + ".aps", truth.name() + " has no exposure");
    return;
  }
  v1::Aps& aps = *truth.mutable_aps();
  if (aps.has_exposure_s()) {
    checkRange(field + ".aps.exposure_s", aps.exposure_s(), ranges::kExposure);
    const double frames = std::round(aps.exposure_s() * config.frame_rate_hz);
    config.exposure_frames = static_cast<FrameIndex>(std::max(1.0, frames));
  }
  aps.set_exposure_s(static_cast<double>(config.exposure_frames) / config.frame_rate_hz);
  if (!aps.has_gain()) aps.set_gain(config.gain);
  if (!aps.has_gamma()) aps.set_gamma(config.gamma);
  checkRange(field + ".aps.gain", aps.gain(), ranges::kGain);
  checkRange(field + ".aps.gamma", aps.gamma(), ranges::kGamma);
  config.gain = aps.gain(), config.gamma = aps.gamma();
}

}  // namespace

TruthConfig resolveTruth(v1::Truth& truth, int index, const FeedConfig& feed, std::uint64_t stream_seed) {
  const std::string field = "truth[" + std::to_string(index) + "]";
  const TruthChannelInfo* info = findTruth(truth.name());
  if (!info) {
    refuse(field + ".name",
           "there is no truth channel '" + cutText(truth.name(), kMaxEcho) + "'; there are: " + truthNames());
  }
  if (feed.intervals.followMotion() && info->needs_pairs)
    refuse(field + ".name", info->name + " needs frames of one interval each: leave out timing.interval_px");
  TruthConfig config{.name = truth.name(),
                     .frames = FrameSelection(),
                     .width = feed.camera.width,
                     .height = feed.camera.height,
                     .frame_rate_hz = feed.frame_rate_hz};
  resolveBias(truth, field, info->setting, config);
  resolveExposure(truth, field, info->setting, config);
  if (truth.times_s_size() > 0) {
    config.frames = FrameSelection(resolveTimes(truth, field));
  } else {
    if (truth.every() == 0) truth.set_every(1);
    config.frames = FrameSelection(truth.every());
  }
  if (truth.name() == "imu") {
    constexpr std::uint64_t kSeeds = 128;  // the addresses below are those of sensors and views
    const std::uint64_t seed = hashKey(stream_seed, kSeeds + static_cast<std::uint64_t>(index));
    config.imu = resolveImu(*truth.mutable_imu(), field + ".imu", seed);
  } else if (truth.has_imu()) {
    refuse(field + ".imu", "only the channel imu has it");
  }
  return config;
}

void resolveTruths(ResolvedStream& stream) {
  v1::OpenStream& request = stream.request;
  for (int i = 0; i < request.truth_size(); ++i) {
    v1::Truth& truth = *request.mutable_truth(i);
    stream.truth.push_back(resolveTruth(truth, i, stream.feedOf(truth.view()), request.seed()));
  }
}

}  // namespace saccade
