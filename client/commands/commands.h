// The subcommands of `saccade`. Each adds itself to the command line and runs when it is named there.
#pragma once

#include <CLI/CLI.hpp>

namespace saccade {

void addListCommand(CLI::App& app);
void addInfoCommand(CLI::App& app);
void addRecordCommand(CLI::App& app);

// --control, which all of them have.
void addControlOption(CLI::App& command, std::string& endpoint);

}  // namespace saccade
