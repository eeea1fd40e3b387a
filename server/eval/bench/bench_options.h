// The flags of the commands that measure.
#pragma once

#include "eval/bench/bench.h"

namespace CLI {
class App;
}

namespace saccade::eval {

struct BenchOptions {
  BenchSetup setup;  // the command fills in the scene
  std::string size = "128x128", frames = "17:21";
  int repeats = 2;         // 0: the command runs once and has no --repeats
  double threshold = 0.2;  // 0: the command has no --threshold
  double bias = 1e-3;
  bool camera = true;  // false: the command moves the camera, and has no --motion, --rate and --frames
  bool quick = false;
  const CLI::App* parsed = nullptr;  // tells which flags were given

  // All settings in one line of key=value, for the head of a table.
  std::string text() const;
};

// Adds the flags, with what stands in `o` as their defaults.
void addBenchOptions(CLI::App& app, BenchOptions& o);

// Adds the scenes of a command that fills a table.
void addScenesOption(CLI::App& app, std::vector<std::string>& scenes);

// Adds --methods and --spp: the lists of what a command compares.
void addMethodOptions(CLI::App& app, std::vector<std::string>& methods, std::vector<int>& spp);

// Whether the command line left this flag out; true where none was parsed.
bool isFree(const BenchOptions& o, const char* flag);

// Reads the texts after parsing. --quick halves the sides of the picture, and with them the frame rate:
// motion keeps its pixels per frame. It reduces frames and reference, too, and leaves flags that were given.
// Throws CLI::ValidationError.
void resolve(BenchOptions& o);

}  // namespace saccade::eval
