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

FrameRange parseFrameRange(const std::string& text) {
  constexpr int kMaxFrame = 1'000'000;
  FrameRange range;
  char rest = 0;
  const int found = std::sscanf(text.c_str(), "%d:%d%c", &range.first, &range.last, &rest);
  if (found == 1 && text.find(':') == text.npos)
    range.last = range.first;
  else if (found != 2)
    range.first = 0;
  if (range.first < 1 || range.last < range.first || range.last > kMaxFrame) {
    throw CLI::ValidationError("--frames",
                               "must be A:B with 1 <= A <= B (the change of frame 1 is since frame 0)");
  }
  return range;
}

}  // namespace saccade

int main(int argc, char** argv) {
  CLI::App app{"Evaluate Saccade: stills, frames of a method, references, comparisons."};
  app.require_subcommand(1);
  saccade::addStillCommand(app);
  saccade::addFramesCommand(app);
  saccade::addCompareCommand(app);
  saccade::addChartCommand(app);
  saccade::addFigureCommand(app);
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
