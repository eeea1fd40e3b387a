#include "client/commands/trajectory_length.h"

#include <cstdio>

namespace saccade::client {
namespace {

constexpr double kLongestPlausible = 1e6;    // seconds
constexpr double kShortestPlausible = 1e-3;  // of the stream
constexpr const char* kUnits =
    "; without a heading that names the unit, times are nanoseconds between commas and seconds between "
    "blanks";

std::string durationText(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, seconds < 1e-6 ? "%.3g ns" : "%.6g s",
                seconds < 1e-6 ? seconds * 1e9 : seconds);
  return text;
}

}  // namespace

std::string trajectoryWarning(double trajectory_s, double stream_s, double frame_s) {
  if (trajectory_s == 0) return "the trajectory has one pose: the camera does not move";
  const bool too_long = trajectory_s > kLongestPlausible;
  const std::string lasts = "the trajectory lasts " + durationText(trajectory_s);
  if (too_long) return lasts + kUnits;
  if (stream_s > 0 && trajectory_s - stream_s >= frame_s)
    return lasts + ", the stream " + durationText(stream_s) + ": the rest of the path is left out";
  if (stream_s > 0 && trajectory_s >= stream_s) return "";
  const bool too_short = trajectory_s < kShortestPlausible * stream_s;
  const std::string stream = stream_s > 0 ? "the stream " + durationText(stream_s) : "the stream has no end";
  return lasts + ", " + stream + ": then the camera stands still" + (too_short ? kUnits : "");
}

}  // namespace saccade::client
