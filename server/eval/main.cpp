// saccade-eval: pictures, dumps and figures from the same rooms that the server runs.
#include <cstdio>

#include "eval/commands.h"

namespace saccade {

Size parseSize(const std::string& text) {
  Size size;
  char rest = 0;
  const bool whole = std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) == 2;
  const auto valid = [](int n) { return n >= 1 && n <= 16384; };
  if (!whole || !valid(size.width) || !valid(size.height)) {
    throw CLI::ValidationError("--size", "must be WxH, each from 1 to 16384, not " + text);
  }
  return size;
}

}  // namespace saccade

int main(int argc, char** argv) {
  CLI::App app{"Evaluate Saccade: stills, frames of a method, references, comparisons."};
  app.require_subcommand(1);
  saccade::addStillCommand(app);
  saccade::addFramesCommand(app);
  saccade::addCompareCommand(app);
  saccade::addChartCommand(app);
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
