// Estimates of the memory that requests take, in MiB.
#pragma once

#include <cstddef>

#include "saccade/v1/control.pb.h"

namespace saccade {

// Of an open_stream of so many bytes, until it is answered.
double openingMemory(std::size_t bytes);

// Of a request while its stream lives, all its defaults filled in, without its paths. `request` may still
// lack them.
double requestMemory(const v1::OpenStream& request);

// Of the path of a stream that is steered for so many frames, and of its description.
double steeringMemory(std::uint64_t frames);
// Of the path of a stream and of its feed's key, while the stream lives. Likewise of those of its objects.
double pathMemory(const v1::Trajectory& path);
double objectMemory(const v1::OpenStream& request);

// Keyframes and lines of csv, of a path and of all objects.
double pointsOf(const v1::Trajectory& path);
double objectPoints(const v1::OpenStream& request);

}  // namespace saccade
