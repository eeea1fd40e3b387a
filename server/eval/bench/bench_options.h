// The flags that charts and figures share.
#pragma once

#include "eval/bench/bench.h"

namespace CLI {
class App;
}

namespace saccade::eval {

struct BenchOptions {
  BenchSetup setup;  // scene: filled by the command
  std::string size = "128x128", frames = "17:21";
  int repeats = 2;         // 0: the command runs once, and has no such flag
  double threshold = 0.2;  // 0: the command has thresholds of its own, and not this flag
  double bias = 1e-3;
  bool quick = false;

  // All of it in one line of key=value, for the head of a table.
  std::string text() const;
};

// Adds the flags, with what stands in `o` as their defaults.
void addBenchOptions(CLI::App& app, BenchOptions& o);

// Reads the texts after parsing; --quick halves the sides of the picture, the frame rate (so that motion
// keeps its pixels) and most of the rest. Throws CLI::ValidationError.
void resolve(BenchOptions& o);

}  // namespace saccade::eval
