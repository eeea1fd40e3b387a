#include "client/commands/summary.h"

#include <cstdio>
#include <map>

namespace saccade::client {
namespace {

using Count = unsigned long long;  // as printf names it

}  // namespace

void printModel(const v1::StreamOpened& opened) {
  if (!opened.has_simplification()) return;
  const v1::ExpectedChange& simpler = opened.simplification();
  std::printf("chosen: %s\n", simpler.model().c_str());
  std::printf("expected: %.3g %% of the time of the whole model, %.3g %% of its events change\n",
              100 * simpler.time(), 100 * simpler.changed());
  std::printf("  as measured with %s\n", simpler.measured_on().c_str());
}

void printChoice(const v1::StreamOpened& opened) {
  if (!opened.has_expected()) return;
  const v1::ExpectedQuality& expected = opened.expected();
  std::printf("chosen: %s at %u spp\n", expected.setting().c_str(), opened.resolved().method().spp());
  std::printf("expected: %.3g CPU ms per frame, %.3g false and %.3g missed events per pixel-frame\n",
              expected.cpu_ms(), expected.false_rate(), expected.missed_rate());
  std::printf("  as measured with %s\n", expected.measured_on().c_str());
}

void printPixelSpeed(const v1::StreamOpened& opened) {
  std::printf("the picture moves by %.3g pixels per frame (median; 99th percentile %.3g)\n",
              opened.px_per_frame_p50(), opened.px_per_frame_p99());
}

void printFiles(std::vector<std::string> files, const std::string& preview) {
  if (!preview.empty()) files.push_back(preview);
  for (const std::string& file : files) std::printf("wrote %s\n", file.c_str());
}

void printRates(const Recorder& recorder, double wall_s) {
  const double stream_s = recorder.duration_ns() / 1e9;
  std::printf("%llu events, %.6g per second of the stream; %.6g s in %.3g s, %.3gx real time\n",
              Count{recorder.events()}, stream_s > 0 ? recorder.events() / stream_s : 0.0, stream_s, wall_s,
              stream_s / wall_s);
  if (recorder.suppressed() == 0) return;
  std::printf("%llu events withheld by the sensors' limits\n", Count{recorder.suppressed()});
}

void printLosses(const Losses& losses) {
  if (losses.gaps == 0) return;
  std::printf("lost on the way: %llu packets with %llu events, in %llu places\n", Count{losses.packets},
              Count{losses.events}, Count{losses.gaps});
}

void printStages(const v1::StreamInfo& info) {
  std::printf("CPU ms per frame: %.3g", info.frame_cpu_ms());
  const char* separator = " (";
  // In one order, which protobuf's own map does not have.
  for (const auto& [stage, ms] :
       std::map<std::string, double>(info.stage_cpu_ms().begin(), info.stage_cpu_ms().end())) {
    std::printf("%s%s %.3g", separator, stage.c_str(), ms);
    separator = ", ";
  }
  std::printf(info.stage_cpu_ms().empty() ? "\n" : ")\n");
}

}  // namespace saccade::client
