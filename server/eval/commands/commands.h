// The subcommands of saccade-eval. Each adds its flags to the parser and runs when it was called for.
#pragma once

#include <CLI/CLI.hpp>

namespace saccade::eval {

void addRenderCommand(CLI::App& app);
void addFramesCommand(CLI::App& app);
void addCompareCommand(CLI::App& app);
void addCompareRendersCommand(CLI::App& app);
void addChartCommand(CLI::App& app);
void addFigureCommand(CLI::App& app);
void addSimplificationCommand(CLI::App& app);

}  // namespace saccade::eval
