// Where the cameras of a stream and its IMU are on their body.
#pragma once

#include <array>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

// A rigid transform as a matrix of 4x4, row by row. T_a_b takes coordinates of b to those of a.
using Transform = std::array<double, 16>;

// T_body_camera, with lengths times `scale`.
Transform bodyFromCamera(const v1::View& view, double scale);
// The same back, with lengths times `scale`.
v1::RigidTransform rigidTransform(const Transform& T_body_camera, double scale);
Transform inverse(const Transform& T_a_b);                                 // T_b_a
Transform product(const Transform& T_a_b, const Transform& T_b_c);         // T_a_c
Transform relative(const Transform& T_body_a, const Transform& T_body_b);  // T_a_b

// The first truth channel that is an IMU, which is the body; nullptr: there is none.
const v1::Truth* imuOf(const v1::OpenStream& stream);
// Metres of the IMU per scene unit; 1 without an IMU.
double metresPerUnit(const v1::OpenStream& stream);

}  // namespace saccade::client
