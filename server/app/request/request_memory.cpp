#include "app/request/request_memory.h"

#include <algorithm>

#include "base/mebibyte.h"

namespace saccade {
namespace {

// Measured on 100000 keyframes and on 190000 lines of CSV.
constexpr double kPointBytes = 250, kOpeningBytes = 12;
// Measured on 64 sensors of 1000 changes, each with all of its noise.
constexpr double kFieldBytes = 4, kChangeBytes = 1000;

}  // namespace

double openingMemory(std::size_t bytes) {
  return kOpeningBytes * static_cast<double>(bytes) / kMiB;
}

double requestMemory(const v1::OpenStream& request) {
  double changes = 0;
  for (const v1::Sensor& sensor : request.sensors()) changes += sensor.changes_size();
  const std::size_t bytes = request.ByteSizeLong() - request.trajectory().ByteSizeLong();
  return (kChangeBytes * changes + kFieldBytes * static_cast<double>(bytes)) / kMiB;
}

double steeringMemory(std::uint64_t frames) {
  return kPointBytes * static_cast<double>(frames) / kMiB;
}

double pathMemory(const v1::Trajectory& path) {
  const auto lines = std::count(path.csv().begin(), path.csv().end(), '\n');
  const double points = static_cast<double>(lines + path.keyframes().keys_size());
  return (points * kPointBytes + 2 * static_cast<double>(path.ByteSizeLong())) / kMiB;
}

}  // namespace saccade
