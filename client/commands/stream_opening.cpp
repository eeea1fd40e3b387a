#include "client/commands/stream_opening.h"

#include <stdexcept>

#include "client/commands/summary.h"
#include "client/commands/trajectory_length.h"

namespace saccade::client {

// A fault in the trajectory's text becomes one of the user's file.
StreamHandle openStream(ControlClient& control, const v1::OpenStream& request,
                        const std::string& trajectory) {
  try {
    return StreamHandle(control, request);
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
  if (!request.trajectory().has_csv()) return;
  const std::string warning = trajectoryWarning(request.trajectory().csv(), streamSeconds(opened));
  if (!warning.empty()) std::fprintf(stderr, "saccade: warning: %s\n", warning.c_str());
}

}  // namespace saccade::client
