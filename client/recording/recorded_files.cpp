#include "client/recording/recorded_files.h"

namespace saccade::client {
namespace {

// A copy of the batch whose times are later by `offset_ns`.
DecodedPacket later(DecodedPacket batch, std::int64_t offset_ns) {
  batch.header.set_t0_ns(batch.header.t0_ns() + offset_ns);
  batch.header.set_t1_ns(batch.header.t1_ns() + offset_ns);
  for (Event& event : batch.events) event.t_ns += offset_ns;
  for (TruthSample& sample : batch.truth) {
    sample.t_ns += offset_ns;
    if (sample.exposure_end_ns == 0) continue;  // it was not exposed
    sample.exposure_begin_ns += offset_ns, sample.exposure_end_ns += offset_ns;
  }
  return batch;
}

}  // namespace

void RecordedFiles::take(const DecodedPacket& batch) {
  const auto write = [this](const DecodedPacket& timed) {
    recorder.add(timed);
    if (poses) poses->add(timed);
  };
  time_offset_ns == 0 ? write(batch) : write(later(batch, time_offset_ns));
}

void RecordedFiles::commit(std::uint64_t lost_events) {
  recorder.commit(lost_events);
  if (poses) poses->close();
}

}  // namespace saccade::client
