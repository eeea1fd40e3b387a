#include "client/commands/summary.h"

#include <cmath>
#include <cstdio>
#include <map>

#include "client/options/request_text.h"
#include "client/terminal/console.h"
#include "client/terminal/progress.h"

namespace saccade::client {
namespace {

using Count = unsigned long long;  // as printf names it

constexpr double kAdvisedPixels = 0.5, kMaxRateHz = 1e5;

// To two digits.
double roundedUp(double rate) {
  const double step = std::pow(10, std::floor(std::log10(rate)) - 1);
  return std::ceil(rate / step) * step;
}

// The rate that keeps the picture to half a pixel per frame.
double advisedRate(double rate_hz, double px_per_frame) {
  return roundedUp(rate_hz * px_per_frame / kAdvisedPixels);
}

void printIntervals(std::FILE* out, const v1::Timing& timing) {
  print(out, "it is rendered every %g px of motion, %g to %g times per second", timing.interval_px(),
        timing.frame_rate_hz(), timing.max_rate_hz());
  if (const double finest = timing.refinement().finest_px(); finest < timing.interval_px())
    print(out, ", and pixels that change in between every %g px", finest);
  print(out, "\n");
}

// Longer intervals than were asked for are less accurate, but four times as long ones hardly if they are
// refined.
void warnOfFastIntervals(const v1::StreamOpened& opened) {
  const v1::Timing& timing = opened.resolved().timing();
  const double px_per_s = opened.px_per_frame_p99() * timing.frame_rate_hz();
  const double px = px_per_s / timing.max_rate_hz();
  const bool refined = timing.refinement().finest_px() < timing.interval_px();
  if (px <= (refined ? 4 : 1) * timing.interval_px()) return;
  print(stderr, "saccade: warning: the picture moves by up to %.2g pixels in an interval", px);
  if (const double rate = roundedUp(px_per_s / timing.interval_px()); rate <= kMaxRateHz)
    print(stderr, "; --max-rate %lld would be enough for %g", std::llround(rate), timing.interval_px());
  print(stderr, "\n");
}

// "spin:90", or in words.
std::string textOf(const v1::ObjectPath& path) {
  if (path.has_own()) return "as the scene says";
  if (!path.has_motion()) return "along poses";
  const v1::ObjectSpeed& motion = path.motion();
  char speed[32];
  std::snprintf(speed, sizeof speed, ":%g", motion.speed());
  return enumWord(motion.kind()) + speed;
}

}  // namespace

void printObjects(std::FILE* out, const v1::OpenStream& resolved) {
  std::string text;
  for (const v1::ObjectMotion& object : resolved.objects())
    if (!object.path().has_still())
      text += (text.empty() ? "" : ", ") + object.name() + " (" + textOf(object.path()) + ")";
  if (!text.empty()) print(out, "objects move: %s\n", text.c_str());
}

void printModel(std::FILE* out, const v1::StreamOpened& opened) {
  if (!opened.has_simplification()) return;
  const v1::ExpectedChange& simpler = opened.simplification();
  print(out, "chosen: %s\n", simpler.model().c_str());
  print(out, "expected: %.3g %% of the time of the whole scene, %.3g %% of its events change\n",
        100 * simpler.time(), 100 * simpler.changed());
  print(out, "  as measured with %s\n", simpler.measured_on().c_str());
}

void printChoice(std::FILE* out, const v1::StreamOpened& opened) {
  if (!opened.has_expected()) return;
  const v1::ExpectedQuality& expected = opened.expected();
  print(out, "chosen: %s at %u spp\n", expected.setting().c_str(), opened.resolved().method().spp());
  print(out, "expected: %.3g CPU ms per frame, %.3g false and %.3g missed events per pixel-frame\n",
        expected.cpu_ms(), expected.false_rate(), expected.missed_rate());
  print(out, "  as measured with %s\n", expected.measured_on().c_str());
}

void printPixelSpeed(std::FILE* out, const v1::StreamOpened& opened) {
  const v1::Timing& timing = opened.resolved().timing();
  const bool follows = timing.interval_px() > 0;
  const double unit = follows ? timing.frame_rate_hz() : 1;
  print(out, "the picture moves by %.3g pixels per %s (median; 99th percentile %.3g)\n",
        unit * opened.px_per_frame_p50(), follows ? "second" : "frame", unit * opened.px_per_frame_p99());
  if (follows) printIntervals(out, timing);
  std::fflush(out);  // a warning on stderr may follow
}

void warnOfFastPicture(const v1::StreamOpened& opened) {
  const v1::OpenStream& request = opened.resolved();
  if (request.timing().interval_px() > 0) return warnOfFastIntervals(opened);
  const v1::Motion& motion = request.trajectory().motion();
  const double px = motion.has_px_per_frame() ? std::abs(motion.px_per_frame()) : opened.px_per_frame_p50();
  if (px <= kAdvisedPixels) return;
  const double rate = advisedRate(request.timing().frame_rate_hz(), px);
  std::string advice = "the motion is too fast for any frame rate";
  if (motion.has_px_per_frame()) {
    advice = "ask for at most 0.5px";
  } else if (rate <= kMaxRateHz) {
    advice = "--rate " + std::to_string(std::llround(rate)) + " would be enough";
  }
  print(stderr, "saccade: warning: above half a pixel per frame events are less accurate; %s\n",
        advice.c_str());
}

void printFiles(std::FILE* out, std::vector<std::string> files, const std::string& preview) {
  if (!preview.empty()) files.push_back(preview);
  for (const std::string& file : files) {
    print(out, "wrote %s\n", file == kStandardOutput ? "to standard output" : file.c_str());
  }
}

void printRates(std::FILE* out, const Recorder& recorder, double wall_s) {
  const double stream_s = recorder.duration_ns() / 1e9;
  print(out, "%llu events (%.3g per second of the stream); %.6g s of the stream in %s, %.3gx real time\n",
        Count{recorder.events()}, stream_s > 0 ? recorder.events() / stream_s : 0.0, stream_s,
        timeText(wall_s).c_str(), stream_s / wall_s);
}

void printTruth(std::FILE* out, const Recorder& recorder) {
  const char* separator = ": ";
  const auto channels = recorder.truth();
  if (channels.empty()) return;
  print(out, "samples of truth in %s", recorder.truthPlace().c_str());
  for (const v1::RecordedTruth& channel : channels) {
    print(out, "%s%s %llu", separator, channel.name().c_str(), Count{channel.samples()});
    separator = ", ";
  }
  print(out, "\n");
}

void printWithheld(std::FILE* out, const Recorder& recorder, const v1::OpenStream& resolved) {
  const Withheld& withheld = recorder.withheld();
  const v1::Sensor& sensor = resolved.sensors(0);
  const Count others{withheld.suppressed - withheld.artefacts - withheld.lost_in_readout};
  if (others > 0) {
    print(out, "%llu events withheld: ", others);
    if (sensor.refractory_s() > 0) print(out, "the refractory period is %g s, and ", sensor.refractory_s());
    print(out, "limits are %u per pixel and interval, which --max-events raises, and %llu per interval\n",
          sensor.max_events_per_pixel_frame(), Count{sensor.max_events_per_frame()});
  }
  if (withheld.artefacts > 0)
    print(out, "%llu events withheld: their odds to be artefacts are above %g\n", Count{withheld.artefacts},
          sensor.max_artefact_odds());
  if (withheld.lost_in_readout > 0)
    print(out, "%llu events lost in the readout\n", Count{withheld.lost_in_readout});
}

void printLosses(std::FILE* out, const Losses& losses) {
  if (losses.gaps == 0) return;
  print(out, "lost on the way: %llu packets with %llu events", Count{losses.packets}, Count{losses.events});
  if (losses.samples > 0) print(out, " and %llu samples of truth", Count{losses.samples});
  print(out, ", in %llu gaps\n", Count{losses.gaps});
}

void printStages(std::FILE* out, const v1::StreamInfo& info, const v1::Timing& timing) {
  const bool follows = timing.interval_px() > 0;
  const double unit = follows ? timing.frame_rate_hz() / 1000 : 1;
  print(out, "CPU %s: %.3g", follows ? "s per second of the stream" : "ms per frame",
        unit * info.frame_cpu_ms());
  const char* separator = " (";
  // Sorted by name; the map of protobuf has no order.
  for (const auto& [stage, ms] :
       std::map<std::string, double>(info.stage_cpu_ms().begin(), info.stage_cpu_ms().end())) {
    print(out, "%s%s %.3g", separator, stage.c_str(), unit * ms);
    separator = ", ";
  }
  print(out, info.stage_cpu_ms().empty() ? "\n" : ")\n");
}

}  // namespace saccade::client
