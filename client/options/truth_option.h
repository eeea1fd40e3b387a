// --truth NAME[:EVERY], the truth channels that a command asks for.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "client/options/output_options.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

void addTruthOption(CLI::App& command, std::vector<std::string>& channels);

// Adds them to the request, for each of its views; the IMU once. Throws std::invalid_argument for a text of
// another form.
void requestTruth(const std::vector<std::string>& channels, v1::OpenStream& request);

// Throws std::invalid_argument with the option and the reason if the truth of the request cannot be written.
void checkTruthOutput(const OutputOptions& options, const v1::OpenStream& request);

}  // namespace saccade::client
