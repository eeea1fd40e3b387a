// --labels, which asks for the labels of events.
#pragma once

#include <CLI/CLI.hpp>

#include "client/options/output_options.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

void addLabelsOption(CLI::App& command, bool& labels);

void requestLabels(v1::OpenStream& request);  // of all sensors

// Throws std::invalid_argument with the formats that hold labels if the request has some and the output
// cannot hold them.
void checkLabelsOutput(const OutputOptions& options, const v1::OpenStream& request);

}  // namespace saccade::client
