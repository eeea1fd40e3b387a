#include "client/commands/stream_opening.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "client/commands/summary.h"
#include "client/commands/trajectory_length.h"
#include "client/formats/common/units.h"
#include "client/terminal/console.h"
#include "client/terminal/interrupt.h"
#include "client/terminal/progress.h"
#include "saccade/server_probe.h"

namespace saccade::client {
namespace {

// "computing light ahead: 34 %"
std::string textOf(const v1::OpeningInfo& opening) {
  if (opening.done() <= 0) return opening.doing();
  return opening.doing() + ": " + std::to_string(std::lround(100 * opening.done())) + " %";
}

std::string awayText(const std::exception& fault) {
  const auto* silence = dynamic_cast<const NoAnswer*>(&fault);
  return silence ? explainSilence(*silence) : fault.what();
}

}  // namespace

StreamHandle openStream(ControlClient& control, const OpenJob& job) {
  constexpr double kUnknown = 0;
  Progress progress(kUnknown);
  return openStream(
      control, job, [&](const std::string& text) { progress.note(text); },
      [&](const std::string& text) { progress.tell("saccade: " + text); });
}

// A fault in the trajectory's text becomes one of the user's file.
StreamHandle openStream(ControlClient& control, const OpenJob& job,
                        const std::function<void(const std::string&)>& show,
                        const std::function<void(const std::string&)>& tell) {
  const auto away = [&, told = false](const std::exception& fault) mutable {
    if (!std::exchange(told, true))
      tell(awayText(fault) + "; trying again for " + timeText(job.retry_time_s));
  };
  try {
    return StreamHandle(control, job.request,
                        {.retry_time = millisecondsOf(job.retry_time_s),
                         .away = away,
                         .waiting = throwIfInterrupted,
                         .watching = [&](const v1::OpeningInfo& opening) { show(textOf(opening)); }});
  } catch (const Refused& refused) {
    if (refused.field != "trajectory.csv") throw;
    throw std::invalid_argument(job.trajectory + ": " + refused.message);
  }
}

double streamSeconds(const v1::StreamOpened& opened) {
  return static_cast<double>(opened.frames()) / opened.resolved().timing().frame_rate_hz();
}

void tellOpening(std::FILE* out, const v1::OpenStream& request, const v1::StreamOpened& opened) {
  if (request.pushed()) return;
  printChoice(out, opened);
  printModel(out, opened);
  printObjects(out, opened.resolved());
  printPixelSpeed(out, opened);
  warnOfFastPicture(opened);
  if (!request.trajectory().has_csv() || !opened.has_trajectory_s()) return;
  const std::string warning = trajectoryWarning(opened.trajectory_s(), streamSeconds(opened),
                                                1 / opened.resolved().timing().frame_rate_hz());
  if (!warning.empty()) print(stderr, "saccade: warning: %s\n", warning.c_str());
}

}  // namespace saccade::client
