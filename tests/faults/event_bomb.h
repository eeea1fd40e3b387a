// A request whose second frame makes thousands of events in each pixel.
#pragma once

#include "mock/test_server.h"

namespace saccade {

// The camera turns from black to the box between two frames, at the lowest threshold and bias.
inline v1::OpenStream eventBomb(std::uint32_t side, std::uint32_t pixel_events) {
  v1::OpenStream request = tinyRequest();
  request.mutable_view()->set_width(side);
  request.mutable_view()->set_height(side);
  request.mutable_view()->set_fov_x_deg(20);
  request.mutable_timing()->set_frame_rate_hz(100);
  request.mutable_timing()->set_duration_s(0.03);
  v1::Keyframes& path = *request.mutable_trajectory()->mutable_keyframes();
  for (const double time_s : {0.0, 0.015, 0.015000001}) {
    v1::Keyframe& key = *path.add_keys();
    key.set_time_s(time_s);
    key.mutable_position()->set_x(2.78);
    key.mutable_position()->set_y(2.73);
    key.mutable_position()->set_z(-7.5);
    const bool away = time_s <= 0.015;
    key.mutable_rotation()->set_y(away);
    key.mutable_rotation()->set_w(!away);
  }
  v1::Sensor& sensor = *request.mutable_sensors(0);
  sensor.set_threshold(1e-3);
  sensor.set_bias(1e-12);
  sensor.set_max_events_per_pixel_frame(pixel_events);
  sensor.set_reconstruction(v1::RECONSTRUCTION_DIRECT);
  return request;
}

}  // namespace saccade
