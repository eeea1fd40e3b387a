// Where HDF5 files have a truth channel.
#pragma once

#include <string>

#include "saccade/v1/recording.pb.h"

namespace saccade::client {

// The group of about.truth(channel): "truth/depth" for view 0, "view_1/truth/depth" for view 1.
std::string truthGroup(const v1::Recording& about, int channel);

}  // namespace saccade::client
