#include "app/streams/stream_opened.h"

namespace saccade {

v1::StreamOpened describeOpened(ResolvedStream resolved, const Stream& stream, std::uint64_t epoch,
                                int channels) {
  v1::StreamOpened opened;
  opened.set_stream_id(stream.session->id());
  opened.set_token(stream.session->token());
  opened.set_epoch(epoch);
  *opened.mutable_resolved() = std::move(resolved.request);
  opened.set_frames(resolved.frames);
  const FeedFacts& facts = stream.feed->facts();
  opened.set_luminance_p01(facts.luminance_p01);
  opened.set_luminance_p50(facts.luminance_p50);
  opened.set_px_per_frame_p50(facts.pixel_speed.p50);
  opened.set_px_per_frame_p99(facts.pixel_speed.p99);
  const v1::Trajectory& path = opened.resolved().trajectory();
  if (path.has_csv() || path.has_keyframes()) opened.set_trajectory_s(seconds(facts.last_pose));
  opened.set_channels(static_cast<std::uint32_t>(channels));
  if (resolved.expected) *opened.mutable_expected() = *resolved.expected;
  if (resolved.simplification) *opened.mutable_simplification() = *resolved.simplification;
  if (!stream.session->broadcast()) return opened;
  for (std::uint32_t i = 0; i < stream.session->channels(); ++i) opened.add_topics(stream.session->topic(i));
  return opened;
}

v1::OpenStream withoutLongPath(v1::OpenStream& request) {
  v1::Trajectory* path = request.release_trajectory();
  v1::OpenStream rest = request;
  request.set_allocated_trajectory(path);
  if (!path->has_keyframes() && !path->has_csv()) *rest.mutable_trajectory() = *path;
  return rest;
}

}  // namespace saccade
