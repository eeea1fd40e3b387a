#include "app/streams/stream_control.h"

#include <algorithm>

#include "app/admission/stream_cost.h"
#include "app/request/read_pose.h"
#include "app/request/refusal.h"
#include "app/request/resolve_sensor.h"
#include "base/names.h"
#include "base/text_cut.h"

namespace saccade {
namespace {

void checkRuns(const Stream& stream) {
  if (stream.session->finished()) throw Refusal(v1::CODE_NOT_FOUND, "stream_id", "the stream has ended");
}

Steering& steeringOf(const Stream& stream) {
  checkRuns(stream);
  if (stream.steering) return *stream.steering;
  refuse("stream_id", "open the stream with timing.clock LOCKSTEP, or with timing.steerable, to steer it");
}

// The number of the body of an object.
std::size_t bodyNamed(const std::string& name, const Stream& stream, const std::string& field) {
  std::vector<std::string> steered;
  for (int i = 0; i < stream.request->objects_size(); ++i) {
    const auto body = static_cast<std::size_t>(i);
    if (!stream.steering->steers(body)) continue;
    if (stream.request->objects(i).name() == name) return body;
    steered.push_back(stream.request->objects(i).name());
  }
  throw Refusal(v1::CODE_NOT_FOUND, field,
                "the request has no object '" + cutText(name, kMaxEcho) +
                    "'; it has: " + cutText(joinNames(steered), kMostNames));
}

std::map<std::size_t, Pose> readObjects(const v1::Steer& call, const Stream& stream) {
  std::map<std::size_t, Pose> poses;
  for (int i = 0; i < call.objects_size(); ++i) {
    const v1::SteeredObject& object = call.objects(i);
    const std::string field = "objects[" + std::to_string(i) + "]";
    const std::size_t body = bodyNamed(object.name(), stream, field + ".name");
    const Pose pose = readPose(object.pose().position(), object.pose().rotation(), field + ".pose");
    if (!poses.emplace(body, pose).second)
      refuse(field + ".name", "the object '" + object.name() + "' is given twice");
  }
  return poses;
}

std::optional<SteerTarget> readTarget(const v1::Steer& call) {
  if (call.has_pose()) return readPose(call.pose().position(), call.pose().rotation(), "pose");
  if (!call.has_velocity() && call.objects_size() > 0) return {};
  if (!call.has_velocity()) refuse("target", "give a pose, a velocity or objects");
  const v1::CameraVelocity& velocity = call.velocity();
  return Twist{readVector(velocity.linear(), ranges::kLinear, "velocity.linear"),
               readVector(velocity.angular(), ranges::kAngular, "velocity.angular")};
}

// The first frame at `t` or later.
FrameIndex frameFrom(TimeNs t, double rate_hz) {
  auto frame = static_cast<FrameIndex>(seconds(t) * rate_hz);
  while (frame > 0 && frameTime(frame - 1, rate_hz) >= t) --frame;
  while (frameTime(frame, rate_hz) < t) ++frame;
  return frame;
}

void setVector(const Vec3d& v, v1::Vector3& to) {
  to.set_x(v.x);
  to.set_y(v.y);
  to.set_z(v.z);
}

void describePath(const std::vector<TimedPose>& keys, v1::Keyframes& path) {
  path.Clear();
  path.set_interpolation(v1::INTERPOLATION_LINEAR);
  for (const TimedPose& key : keys) {
    v1::Keyframe& frame = *path.add_keys();
    frame.set_time_s(seconds(key.time));
    setVector(key.pose.position, *frame.mutable_position());
    const Quaternion& q = key.pose.rotation;
    v1::Quaternion& rotation = *frame.mutable_rotation();
    rotation.set_x(q.x);
    rotation.set_y(q.y);
    rotation.set_z(q.z);
    rotation.set_w(q.w);
  }
}

// Checks the change of a call, as that of a sensor in a request.
SensorChange readChange(const v1::OpenStream& request, const v1::ChangeSensor& call) {
  const int index = static_cast<int>(call.sensor());
  v1::Sensor sensor = request.sensors(index);
  v1::SensorChange change = call.change();
  const SensorConfig config = resolveSensor(sensor, index, request.seed());
  const SensorChange read = resolveChange(change, config, "change");
  checkChange(request, sensor, config.noise, read, "change");
  return read;
}

void describeChanges(const std::vector<SensorChange>& changes, v1::Sensor& sensor) {
  sensor.clear_changes();
  for (const SensorChange& change : changes) {
    v1::SensorChange& one = *sensor.add_changes();
    one.set_time_s(seconds(change.time));
    if (change.threshold) one.set_threshold(*change.threshold);
    if (change.threshold_off) one.set_threshold_off(*change.threshold_off);
    if (change.bias) one.set_bias(*change.bias);
    if (change.noise) fillNoise(*one.mutable_noise(), *change.noise);
  }
}

}  // namespace

v1::Steered steerStream(const Stream& stream, const v1::Steer& call) {
  Steering& steering = steeringOf(stream);
  const FrameIndex frame = steering.steer({readTarget(call), readObjects(call, stream)});
  stream.feed->notifier()->raise();
  v1::Steered steered;
  steered.set_frame(frame);
  steered.set_t_ns(frameTime(frame, stream.request->timing().frame_rate_hz()).count());
  return steered;
}

PushTarget pushTarget(const Stream& stream) {
  checkRuns(stream);
  if (!stream.pushed) refuse("stream_id", "open the stream with `pushed` to send its frames");
  return {stream.pushed, stream.feed->notifier(), stream.request->timing().frame_rate_hz()};
}

v1::FramePushed pushFrame(const PushTarget& target, std::string_view intensity) {
  const FrameIndex frame = target.frames->push(intensity);
  target.feed->raise();
  v1::FramePushed pushed;
  pushed.set_frame(frame);
  pushed.set_t_ns(frameTime(frame, target.frame_rate_hz).count());
  return pushed;
}

v1::SensorChanged changeSensor(const Stream& stream, const v1::ChangeSensor& call) {
  const int sensors = stream.request->sensors_size();
  if (call.sensor() >= static_cast<std::uint32_t>(sensors))
    refuse("sensor", "the stream has " + std::to_string(sensors) + " sensors");
  checkRuns(stream);
  const SensorChange change = readChange(*stream.request, call);
  const double rate_hz = stream.request->timing().frame_rate_hz();
  const FrameIndex frame = frameFrom(stream.sink->schedule(call.sensor()).add(change), rate_hz);
  v1::SensorChanged changed;
  changed.set_frame(frame);
  changed.set_t_ns(frameTime(frame, rate_hz).count());
  return changed;
}

std::size_t descriptionBytes(const Stream& stream) {
  constexpr std::size_t kKeyBytes = 90, kChangeBytes = 220;  // serialized, at most
  std::size_t bytes = stream.request_bytes;
  for (int i = 0; i < stream.request->sensors_size(); ++i) {
    const auto asked = static_cast<std::size_t>(stream.request->sensors(i).changes_size());
    bytes += kChangeBytes * (stream.sink->schedule(static_cast<std::size_t>(i)).size() - asked);
  }
  return stream.steering ? bytes + kKeyBytes * stream.steering->frames() * stream.steering->paths() : bytes;
}

v1::StreamDescription describeStream(const Stream& stream) {
  v1::StreamDescription description;
  v1::OpenStream& request = *description.mutable_request();
  request = *stream.request;
  for (int i = 0; i < request.sensors_size(); ++i) {
    describeChanges(stream.sink->schedule(static_cast<std::size_t>(i)).all(), *request.mutable_sensors(i));
  }
  if (!stream.steering) return description;
  const std::vector<TimedPose> keys = stream.steering->keys();
  describePath(keys, *request.mutable_trajectory()->mutable_keyframes());
  for (const auto& [body, of_body] : stream.steering->bodyKeys())
    describePath(of_body,
                 *request.mutable_objects(static_cast<int>(body))->mutable_path()->mutable_keyframes());
  v1::Timing& timing = *request.mutable_timing();
  timing.set_clock(v1::CLOCK_FAST);
  timing.set_speed(0);
  timing.set_steerable(false);
  const double frames = static_cast<double>(std::max<std::size_t>(keys.size() - 1, 1));
  timing.set_duration_s(frames / timing.frame_rate_hz());
  return description;
}

}  // namespace saccade
