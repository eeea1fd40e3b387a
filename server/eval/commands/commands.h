// The subcommands of saccade-eval. Each adds its flags to the parser and runs when it was called for.
#pragma once

#include <CLI/CLI.hpp>

namespace saccade::eval {

void addStillCommand(CLI::App& app);
void addFramesCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addCompareStillsCommand(CLI::App& app);
void addChartCommand(CLI::App& app);
void addFigureCommand(CLI::App& app);
void addNeedsCommand(CLI::App& app);

}  // namespace saccade::eval
