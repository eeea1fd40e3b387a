#include "app/request/request_memory.h"

#include <algorithm>

#include "base/mebibyte.h"

namespace saccade {
namespace {

// Measured on 100000 keyframes and on 190000 lines of CSV.
constexpr double kPointBytes = 250, kOpeningBytes = 12;
// Measured on 64 sensors of 1000 changes, each with all of its noise.
constexpr double kFieldBytes = 4, kChangeBytes = 1000;

double bytesOf(const v1::OpenStream& request) {
  double bytes = 0;
  for (const v1::ObjectMotion& object : request.objects())
    bytes += static_cast<double>(object.ByteSizeLong());
  return bytes;
}

// Of a Trajectory or an ObjectPath.
double points(const auto& path) {
  const auto lines = std::count(path.csv().begin(), path.csv().end(), '\n');
  return static_cast<double>(lines + path.keyframes().keys_size());
}

double memoryOf(double points, double bytes) {
  return (points * kPointBytes + 2 * bytes) / kMiB;
}

}  // namespace

double openingMemory(std::size_t bytes) {
  return kOpeningBytes * static_cast<double>(bytes) / kMiB;
}

double requestMemory(const v1::OpenStream& request) {
  double changes = 0;
  for (const v1::Sensor& sensor : request.sensors()) changes += sensor.changes_size();
  const double bytes = static_cast<double>(request.ByteSizeLong() - request.trajectory().ByteSizeLong());
  return (kChangeBytes * changes + kFieldBytes * (bytes - bytesOf(request))) / kMiB;
}

double steeringMemory(std::uint64_t frames) {
  return kPointBytes * static_cast<double>(frames) / kMiB;
}

double pathMemory(const v1::Trajectory& path) {
  return memoryOf(points(path), static_cast<double>(path.ByteSizeLong()));
}

double objectMemory(const v1::OpenStream& request) {
  return memoryOf(objectPoints(request), bytesOf(request));
}

double pointsOf(const v1::Trajectory& path) {
  return points(path);
}

double objectPoints(const v1::OpenStream& request) {
  double sum = 0;
  for (const v1::ObjectMotion& object : request.objects()) sum += points(object.path());
  return sum;
}

}  // namespace saccade
