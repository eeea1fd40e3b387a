// A picture of a truth channel as a file of its own.
#pragma once

#include <string>

#include "saccade/v1/recording.pb.h"

namespace saccade::client {

// ".png" for u8 and u16, ".exr" for others.
const char* pictureExtension(const v1::RecordedTruth& channel);

// `elements`: of the sample, as in TruthSample. The planes are the channels of the file, by name in EXR. f64
// becomes f32. Throws std::runtime_error with the file's name.
void writePicture(const std::string& path, const v1::RecordedTruth& channel, const std::string& elements);

}  // namespace saccade::client
