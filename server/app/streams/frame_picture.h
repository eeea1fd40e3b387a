// The picture that get_frame answers.
#pragma once

#include "frame/intensity_change.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

// The interval as a sensor with this bias sees it. bias > 0, in units of radiance.
v1::FramePicture drawPicture(const IntensityChange& change, double bias);

}  // namespace saccade
