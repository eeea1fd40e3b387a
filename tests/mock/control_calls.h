// Calls that control a running stream.
#pragma once

#include "mock/mock_client.h"

namespace saccade {

// The call of `request`, for the stream of the reply.
template <class Call>
Call& forStream(Call& call, const v1::StreamOpened& stream) {
  call.set_stream_id(stream.stream_id());
  call.set_token(stream.token());
  return call;
}

inline constexpr double kCornellX = 2.78;

// A pose of the Cornell box's camera, moved to the right by `right` scene units.
inline v1::Request steerTo(const v1::StreamOpened& stream, double right) {
  v1::Request request;
  v1::CameraPose& pose = *forStream(*request.mutable_steer(), stream).mutable_pose();
  pose.mutable_position()->set_x(kCornellX - right);
  pose.mutable_position()->set_y(2.73);
  pose.mutable_position()->set_z(-7.5);
  pose.mutable_rotation()->set_z(3);  // half a turn about z; not of unit length
  return request;
}

inline v1::Request steerBy(const v1::StreamOpened& stream, double speed, double turn) {
  v1::Request request;
  v1::CameraVelocity& velocity = *forStream(*request.mutable_steer(), stream).mutable_velocity();
  velocity.mutable_linear()->set_x(speed);
  velocity.mutable_angular()->set_y(turn);
  return request;
}

inline v1::Request changeOf(const v1::StreamOpened& stream, std::uint32_t sensor,
                            const v1::SensorChange& change) {
  v1::Request request;
  v1::ChangeSensor& call = forStream(*request.mutable_change_sensor(), stream);
  call.set_sensor(sensor);
  *call.mutable_change() = change;
  return request;
}

inline v1::OpenStream describe(MockClient& client, const v1::StreamOpened& stream) {
  v1::Request request;
  forStream(*request.mutable_describe_stream(), stream);
  return client.call(request).describe_stream().request();
}

}  // namespace saccade
