#include "app/streams/stream_opened.h"

#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/text_format.h>

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
  if (resolved.path_begin_ns) opened.set_trajectory_begin_ns(*resolved.path_begin_ns);
  opened.set_channels(static_cast<std::uint32_t>(channels));
  if (resolved.expected) *opened.mutable_expected() = *resolved.expected;
  if (resolved.simplification) *opened.mutable_simplification() = *resolved.simplification;
  if (!stream.session->broadcast()) return opened;
  for (std::uint32_t i = 0; i < stream.session->channels(); ++i) opened.add_topics(stream.session->topic(i));
  return opened;
}

void keepRequest(v1::OpenStream& request, Stream& stream) {
  v1::Trajectory* path = request.release_trajectory();
  google::protobuf::RepeatedPtrField<v1::ObjectMotion> objects;
  objects.Swap(request.mutable_objects());
  auto rest = std::make_shared<v1::OpenStream>(request);
  for (const v1::ObjectMotion& object : objects) {
    v1::ObjectMotion& kept = *rest->add_objects();
    kept.set_name(object.name());
    const bool is_long = object.path().has_csv() || object.path().has_keyframes();
    if (request.timing().steerable() || !is_long) *kept.mutable_path() = object.path();
  }
  objects.Swap(request.mutable_objects());
  request.set_allocated_trajectory(path);
  if (path && !path->has_keyframes() && !path->has_csv()) *rest->mutable_trajectory() = *path;
  stream.request_bytes = rest->ByteSizeLong();
  stream.request = std::move(rest);
}

std::string shortText(const google::protobuf::Message& message, std::size_t max_bytes) {
  std::string text(max_bytes, '\0');
  google::protobuf::io::ArrayOutputStream out(text.data(), static_cast<int>(text.size()));
  google::protobuf::TextFormat::Printer printer;
  printer.SetSingleLineMode(true);
  const bool whole = printer.Print(message, &out);
  text.resize(static_cast<std::size_t>(out.ByteCount()));
  return whole ? text : text + "...";
}

}  // namespace saccade
