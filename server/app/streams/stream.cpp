#include "app/streams/stream.h"

#include <algorithm>

namespace saccade {

void Stream::stop(v1::EndReason reason) const {
  session->stop(reason);
  if (feed) feed->interrupt();
}

v1::StreamInfo Stream::info() const {
  v1::StreamInfo info;
  const FeedProgress progress = feed->progress();
  const double frames = static_cast<double>(std::max<FrameIndex>(1, progress.frames));
  info.set_stream_id(session->id());
  info.set_scene(request->scene());
  info.set_delivery(request->delivery());
  info.set_state(session->state());
  info.set_sensors(static_cast<std::uint32_t>(request->sensors_size()));
  info.set_frames_done(progress.frames);
  info.set_events(sink->events());
  info.set_dropped_packets(session->droppedPackets());
  info.set_lag_s(progress.lag_s);
  double total_ms = 0;
  for (std::size_t i = 0; i < kStageNames.size(); ++i) {
    const double ms = seconds(progress.cpu.cpu[i]) * 1e3 / frames;
    (*info.mutable_stage_cpu_ms())[kStageNames[i]] = ms;
    total_ms += ms;
  }
  info.set_frame_cpu_ms(total_ms);
  return info;
}

CpuCost Stream::load() const {
  constexpr FrameIndex kSureFrames = 10;  // so many say more than a measurement before
  const v1::Timing& timing = request->timing();
  if (timing.clock() != v1::CLOCK_PACED || session->finished()) return {};
  const FeedProgress done = feed->progress();
  const double frames_per_s = timing.frame_rate_hz() * timing.speed();
  const bool sure = done.frames >= kSureFrames;
  return {(sure ? done.recent_s.value() : frame_cost.feed) * frames_per_s,
          std::max(frame_cost.sensors, sink->recentSeconds()) * frames_per_s,
          (sure ? done.critical_path_s.value() : frame_cost.critical_path) * frames_per_s,
          std::max(frame_cost.longest, sink->recentLongestSeconds()) * frames_per_s};
}

}  // namespace saccade
