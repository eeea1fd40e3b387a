// The subcommands of saccade-eval. Each adds its flags to the parser and runs when it was called for.
#pragma once

#include <CLI/CLI.hpp>

namespace saccade {

struct Size {
  int width = 256, height = 256;
};
// "WxH", 1 to 16384 each. Throws CLI::ValidationError.
Size parseSize(const std::string& text);

void addStillCommand(CLI::App& app);
void addFramesCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addChartCommand(CLI::App& app);

// Where reference frames are kept: $XDG_CACHE_HOME/saccade, else ~/.cache/saccade.
std::string defaultCache();

}  // namespace saccade
