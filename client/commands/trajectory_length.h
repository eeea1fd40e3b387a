// Warns of a trajectory file that does not fill its stream.
#pragma once

#include <string>

namespace saccade::client {

// One sentence if the poses of a TUM or ESIM text end before `stream_s` (seconds; 0: an endless stream), or
// if their times look like those of the wrong unit. Empty otherwise. `text` has passed the server's checks.
std::string trajectoryWarning(const std::string& text, double stream_s);

}  // namespace saccade::client
