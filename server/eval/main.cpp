// saccade-eval: pictures, dumps and figures from the same rooms that the server runs.
#include <cstdio>

#include "eval/commands.h"

int main(int argc, char** argv) {
  CLI::App app{"Evaluate Saccade: stills, frames of a method, references, comparisons."};
  app.require_subcommand(1);
  saccade::addStillCommand(app);
  saccade::addFramesCommand(app);
  saccade::addCompareCommand(app);
  saccade::addCompareStillsCommand(app);
  saccade::addChartCommand(app);
  saccade::addFigureCommand(app);
  saccade::addNeedsCommand(app);
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
