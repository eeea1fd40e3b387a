// The subcommands of saccade-eval. Each adds its flags to the parser and runs when it was called for.
#pragma once

#include <CLI/CLI.hpp>

#include "base/default_cache.h"

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

}  // namespace saccade
