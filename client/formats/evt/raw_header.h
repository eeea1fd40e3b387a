// The text at the front of a RAW file of Prophesee: lines `% key value`, of which `% end` is the last.
#pragma once

#include <string>

#include "saccade/v1/recording.pb.h"

namespace saccade::client {

// `evt`: "3.0"; `encoding`: "EVT3". Throws std::invalid_argument if the image has more than 2048 columns or
// rows.
std::string rawHeader(const std::string& evt, const std::string& encoding, const v1::Recording& about);

}  // namespace saccade::client
