#include "app/admission/queue_cost.h"

#include <algorithm>

#include "base/mebibyte.h"
#include "base/queue_bounds.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

// Only a stream that may join a running feed has snapshots.
double snapshotBytes(const ResolvedStream& stream) {
  if (stream.request.timing().clock() != v1::CLOCK_PACED) return 0;
  double bytes = 0;
  for (const v1::Sensor& sensor : stream.request.sensors())
    bytes = std::max(bytes, 2 * sizeof(float) * stream.feedOf(sensor.view()).pixels());
  return bytes;
}

double pictureBytes(const ResolvedStream& stream) {
  double bytes = 0;
  for (const v1::Truth& truth : stream.request.truth()) {
    const TruthChannelInfo& info = *findTruth(truth.name());
    if (info.layout != v1::LAYOUT_PICTURE) continue;
    const auto planes = static_cast<double>(bytesOf(info.element) * info.planes.size());
    bytes = std::max(bytes, planes * stream.feedOf(truth.view()).pixels());
  }
  return bytes;
}

}  // namespace

// The newest packet that was sent stays, however large, and receivers may hold others.
double queueMemory(const ResolvedStream& stream, const Limits& limits) {
  const double largest = std::max(snapshotBytes(stream), pictureBytes(stream));
  const double beyond = largest > kLargePacket ? (kMostLargePackets + 1) * largest : 0;
  return limits[Limit::kQueue] * (1 + kKeptBounds) + beyond / kMiB;
}

}  // namespace saccade
