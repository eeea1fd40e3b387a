// Checks the files of a recording before its stream is opened.
#pragma once

#include "client/commands/record_options.h"

namespace saccade::client {

// Throws std::invalid_argument with the option at fault: an unknown format, no such folder, a folder that
// cannot be written, a file that exists (unless options.force), or several sensors on standard output.
void checkOutputs(const RecordOptions& options, int sensors);

}  // namespace saccade::client
