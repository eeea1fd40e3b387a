// saccade-eval: pictures, dumps and figures from the same rooms that the server runs.
#include <cstdio>

#include "eval/commands/commands.h"

int main(int argc, char** argv) {
  CLI::App app{"Evaluate Saccade: stills, frames of a method, references, comparisons."};
  app.require_subcommand(1);
  saccade::eval::addRenderCommand(app);
  saccade::eval::addFramesCommand(app);
  saccade::eval::addCompareCommand(app);
  saccade::eval::addCompareRendersCommand(app);
  saccade::eval::addChartCommand(app);
  saccade::eval::addFigureCommand(app);
  saccade::eval::addSimplificationCommand(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "saccade-eval: %s\n", e.what());
    return 1;
  }
  return 0;
}
