// Motions of objects that any scene offers. They begin where the scene file has the object.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/camera/trajectory.h"
#include "scene/scene.h"

namespace saccade {

// Up is the axis of the scene that is nearest to up in its camera's view, and right is likewise another one.
// Kinds, where a positive speed goes, and its unit per second:
//   spin    turns about its centre, counter-clockwise as seen from above      degrees
//   orbit   around the middle of the scene, likewise, and turns as it goes    degrees
//   slide   to the right, and turns back after kSlideTime                     scene units
//   swing   as slide, as a pendulum with the period kSwingTime: its greatest speed, scene units
struct ObjectMotion {
  std::string kind;  // one of objectMotionKinds()
  double speed = 0;  // as above
};

inline constexpr TimeNs kSlideTime{1'000'000'000}, kSwingTime{2'000'000'000};

const std::vector<std::string>& objectMotionKinds();

// Why a speed is not of a magnitude from 1e-6 to 1e6; empty where it is.
std::string objectSpeedFault(double speed);

// Reads KIND:SPEED, such as "spin:90"; none where there is no colon. Throws SceneError.
std::optional<ObjectMotion> parseObjectMotion(const std::string& text);

// T_world_body of a body of `scene`.
Trajectory makeObjectMotion(const ObjectMotion& motion, const Scene& scene, const Body& body);

}  // namespace saccade
