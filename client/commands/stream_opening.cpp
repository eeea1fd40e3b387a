#include "client/commands/stream_opening.h"

#include <cmath>
#include <stdexcept>

#include "client/commands/progress.h"
#include "client/commands/summary.h"
#include "client/commands/trajectory_length.h"

namespace saccade::client {
namespace {

// "computing light ahead: 34 %"
std::string textOf(const v1::OpeningInfo& opening) {
  if (opening.done() <= 0) return opening.doing();
  return opening.doing() + ": " + std::to_string(std::lround(100 * opening.done())) + " %";
}

}  // namespace

StreamHandle openStream(ControlClient& control, const v1::OpenStream& request,
                        const std::string& trajectory) {
  constexpr double kUnknown = 0;
  Progress progress(kUnknown);
  return openStream(control, request, trajectory, [&](const std::string& text) { progress.note(text); });
}

// A fault in the trajectory's text becomes one of the user's file.
StreamHandle openStream(ControlClient& control, const v1::OpenStream& request, const std::string& trajectory,
                        const std::function<void(const std::string&)>& show) {
  try {
    return StreamHandle(control, request, [&](const v1::OpeningInfo& opening) { show(textOf(opening)); });
  } catch (const Refused& refused) {
    if (refused.field != "trajectory.csv") throw;
    throw std::invalid_argument(trajectory + ": " + refused.message);
  }
}

double streamSeconds(const v1::StreamOpened& opened) {
  return static_cast<double>(opened.frames()) / opened.resolved().timing().frame_rate_hz();
}

void tellOpening(std::FILE* out, const v1::OpenStream& request, const v1::StreamOpened& opened) {
  if (request.pushed()) return;
  printChoice(out, opened);
  printModel(out, opened);
  printPixelSpeed(out, opened);
  warnOfFastPicture(opened);
  if (!request.trajectory().has_csv() || !opened.has_trajectory_s()) return;
  const std::string warning = trajectoryWarning(opened.trajectory_s(), streamSeconds(opened));
  if (!warning.empty()) std::fprintf(stderr, "saccade: warning: %s\n", warning.c_str());
}

}  // namespace saccade::client
