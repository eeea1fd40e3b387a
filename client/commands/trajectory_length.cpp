#include "client/commands/trajectory_length.h"

#include <cstdio>
#include <sstream>

#include "client/commands/request_text.h"

namespace saccade::client {
namespace {

constexpr double kLongestPlausible = 1e6;  // seconds

struct Times {
  int poses = 0;
  double first = 0, last = 0;  // in the unit of the file
  bool nanoseconds = false;    // ESIM, with commas; TUM, with blanks, has seconds
  double seconds() const { return (last - first) * (nanoseconds ? 1e-9 : 1); }
};

// Skips comments and the heading: no other line begins with anything but a number.
Times readTimes(const std::string& text) {
  Times times;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    const std::size_t end = std::min(line.find_first_of(" \t,\r", begin), line.size());
    const auto time = parseNumber<double>(std::string_view(line).substr(begin, end - begin));
    if (!time) continue;
    if (times.poses++ == 0) times.first = *time;
    times.last = *time;
    times.nanoseconds = line.find(',') != line.npos;
  }
  return times;
}

std::string durationText(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, seconds < 1e-6 ? "%.3g ns" : "%.6g s",
                seconds < 1e-6 ? seconds * 1e9 : seconds);
  return text;
}

}  // namespace

std::string trajectoryWarning(const std::string& text, double stream_s) {
  const Times times = readTimes(text);
  if (times.poses == 1) return "the trajectory has one pose: the camera does not move";
  const double length = times.seconds();
  const bool too_long = !times.nanoseconds && length > kLongestPlausible;
  if (!too_long && (stream_s == 0 || length >= stream_s)) return "";
  std::string warning =
      "the trajectory lasts " + durationText(length) + " (" + std::to_string(times.poses) + " poses)";
  if (too_long) return warning + "; times of lines with blanks are seconds";
  warning += ", the stream " + durationText(stream_s) + ": then the camera stands still";
  return warning + (times.nanoseconds ? "; times of lines with commas are nanoseconds" : "");
}

}  // namespace saccade::client
