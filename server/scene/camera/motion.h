// Camera motions that any scene offers. They begin at a given pose.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera/lens.h"
#include "scene/camera/trajectory.h"

namespace saccade {

// A motion at constant speed, in the axes that the camera has at its start. Kinds, where a positive speed
// goes, and its unit per second:
//   dolly     along the viewing axis        scene units
//   truck     to the right                  scene units
//   pedestal  up                            scene units
//   pan       turns to the right            degrees
//   tilt      turns up                      degrees
//   roll      turns clockwise               degrees
//   orbit     to the right around the point looked at, and keeps looking at it: degrees
//   shake     hand-held, see shake.h: degrees that the images move, median over the view and the period; a
//             focal length counts as a radian
//   random    a smooth path about the start, see random_path.h: the unit is that of shake
//   roam      a smooth path through the free space of the scene, see scene/roam/roam.h: likewise
// The last three are drawn by a seed, and periodic.
struct Motion {
  std::string kind;          // one of motionKinds()
  double speed = 0;          // as above
  bool image_speed = false;  // the speed is the median of the images at the start, focal lengths per second
  // When to turn back, and again at the start, and so on: at least 1e-3. 0: never. Unset: after
  // kTurnTime. A dolly may turn sooner, when it has gone a quarter of the way to the nearest surface. So
  // may an orbit, when it has turned by kMaxOrbitRad. So both stay in the scene. Of no use to what has a
  // seed.
  std::optional<double> turn_s = {};
  std::uint64_t seed = 0;  // where isSeeded()
  // Of roam: the least distance to all surfaces, scene units. Unset: a twentieth of the median distance that
  // is seen around the start, or less where that leaves no room.
  std::optional<double> clearance = {};
};

inline constexpr TimeNs kTurnTime{200'000'000};
inline constexpr double kMaxOrbitRad = 0.25;
// Bounds on every motion: a rotation turns back after so many turns, and any other motion after kMaxDistance.
// A motion that never turns back stays there.
inline constexpr double kMaxTurns = 1000, kMaxTurnsPerSecond = 100;

const std::vector<std::string>& motionKinds();
bool isSeeded(const std::string& kind);  // shake, random and roam: they have no time to turn back
inline constexpr const char* kRoam = "roam";
// Empty, or why this kind cannot have this speed: its magnitude is 1e-6 to 1e6, and that of
// what has a seed is positive.
std::string speedFault(const std::string& kind, double speed);

// All kinds but kRoam, which needs the free space: see makeRoam().
// `probes` are world-space points on the surfaces in view. Those behind the camera do not count; without any,
// one is assumed on the viewing axis at distance 1. An image_speed of what would move no image stands still.
// Shake has a largest swing: beyond about 250 degrees per second it is slower than asked. A random path has
// the bounds of random_path.h.
// `lens`: through which the images are seen; unset: without distortion.
Trajectory makeMotion(const Motion& motion, const Pose& start, const std::vector<Vec3d>& probes,
                      const Lens& lens = Lens{});

// Reads KIND:SPEED, such as "dolly:0.2" or "pan:-15"; none where there is no colon. Throws SceneError.
std::optional<Motion> parseMotion(const std::string& text);

// Motions with names: right (truck), forward (dolly), orbit, shake and still. The median speed of the images
// is kMotionPxPerFrame in a picture kMotionWidth pixels wide at kMotionRateHz.
inline constexpr double kMotionPxPerFrame = 0.67, kMotionWidth = 256, kMotionRateHz = 500;
const std::vector<std::string>& motionNames();
bool isMotionName(const std::string& name);
Motion namedMotion(const std::string& name, double fov_x_deg);  // fovXDeg() of the camera

}  // namespace saccade
