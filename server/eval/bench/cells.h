// The cells of `saccade-eval cells`: scenes, motions, speeds and frames, each with each.
#pragma once

#include <string>
#include <vector>

#include "eval/bench/arguments.h"
#include "eval/bench/bench.h"

namespace saccade::eval {

// The motions that a speed in pixels per frame is kept for, see BenchSetup::px_per_frame.
inline const std::vector<std::string> kCellMotions{"right", "forward", "orbit", "shake"};
inline const std::string kStillCamera = "still";  // with it the speed sets the frame rate alone

struct Cell {
  std::string scene, motion;  // a name or a path; one of kCellMotions
  double px_per_frame = 0;
  FrameRange frames;

  std::string framesText() const;  // "17:21", "21"
  std::string name() const;        // "cornell-box right 0.67px 17:21": of the rows of a table
  BenchSetup setup(BenchSetup common) const;
};

struct CellGrid {
  std::vector<std::string> scenes, motions{kCellMotions};
  std::vector<double> speeds{0.1, 0.33, 0.67, 2, 4};  // pixels per frame
  std::vector<FrameRange> frames;
  // Scene by scene, so that each is opened once.
  std::vector<Cell> cells() const;
};

// Empty, or why a cell with this view tells nothing about methods.
std::string whyLeftOut(const Cell& cell, const BenchView& view);
inline constexpr double kLeastSurface = 0.5, kLeastOfSpeed = 0.01;

}  // namespace saccade::eval
