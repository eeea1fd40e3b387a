// The linear velocity of a camera, by flow across edges whose depth is known.
#pragma once

#include <optional>
#include <span>

#include "base/vec.h"
#include "scene/camera/lens.h"

namespace saccade::eval {

// An edge that an event tells of.
struct EdgeFlow {
  Vec2 position;  // pixels
  Vec2 flow;      // across the edge, pixels per second, not 0
  float depth;    // along the viewing axis, scene units
};

inline constexpr std::size_t kLeastEdges = 12;

// In the camera's axes, scene units per second. `angular`: the angular velocity, radians per second, as a
// gyroscope tells it. Nothing with fewer than kLeastEdges edges, and where these leave a direction open.
//
// A surface at depth Z that is seen at (x, y) = ((u - cx) / fx, (v - cy) / fy) moves by [LP80]
//   x' = (-v_x + x v_z) / Z + x y w_x - (1 + x^2) w_y + y w_z
//   y' = (-v_y + y v_z) / Z + (1 + y^2) w_x - x y w_y - x w_z
// Of this flow (fx x', fy y') an event shows the part n across its edge: n . flow = n . n [L24], [R24].
// Divided by n . n these equations are solved for v. The sum of absolute errors is least: edges of moving
// bodies and false events do not count for more than others [ours].
//
// [LP80] Longuet-Higgins and Prazdny, The interpretation of a moving retinal image, Proc. R. Soc. B 1980.
// [L24] Lu et al., Event-based visual inertial velometer, RSS 2024.
// [R24] Ren et al., Motion and structure from event-based normal flow, ECCV 2024.
std::optional<Vec3d> egoVelocity(std::span<const EdgeFlow> edges, const CameraModel& camera, Vec3d angular);

}  // namespace saccade::eval
