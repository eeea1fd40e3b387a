// Finds before any work that files cannot be written, or would be replaced.
#pragma once

#include <string>

namespace saccade::client {

// Throws std::invalid_argument with `option` and the reason. `force`: an existing file may be replaced.
void checkOutput(const std::string& option, const std::string& path, bool force);

// The same for the files of a recording of `sensors` sensors at `output`, and their JSON; for --output.
void checkOutputs(const std::string& output, int sensors, bool force);

}  // namespace saccade::client
