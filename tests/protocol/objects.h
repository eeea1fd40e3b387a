// Requests that move objects of the Cornell box, whose camera stands.
#pragma once

#include <string>

#include "mock/test_server.h"

namespace saccade {

inline v1::OpenStream stillRequest() {
  v1::OpenStream request = tinyRequest();
  request.mutable_trajectory()->set_name("still");
  return request;
}

inline v1::ObjectPath& addObject(v1::OpenStream& request, const std::string& name) {
  v1::ObjectMotion& object = *request.add_objects();
  object.set_name(name);
  return *object.mutable_path();
}

inline void addMotion(v1::OpenStream& request, const std::string& name, v1::ObjectMotionKind kind,
                      double speed) {
  v1::ObjectSpeed& motion = *addObject(request, name).mutable_motion();
  motion.set_kind(kind), motion.set_speed(speed);
}

// A turn in half a second.
inline v1::OpenStream spinning(const std::string& name = "tall_block", double speed = 720) {
  v1::OpenStream request = stillRequest();
  addMotion(request, name, v1::OBJECT_MOTION_KIND_SPIN, speed);
  return request;
}

}  // namespace saccade
