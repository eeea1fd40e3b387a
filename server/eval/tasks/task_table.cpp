#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

bool always(const TaskTruth&) {
  return true;
}

bool turns(const TaskTruth& truth) {
  return truth.onlyTurns();
}

bool goes(const TaskTruth& truth) {
  return truth.goes();
}

bool hasBodies(const TaskTruth& truth) {
  return truth.hasBodies();
}

}  // namespace

const std::vector<Task>& taskTable() {
  static const std::vector<Task> table{
      {"normal_flow", "optical flow across edges, by planes through event times", "median relative error",
       always, scoreNormalFlow},
      {"patch_flow", "optical flow of patches, by contrast maximisation", "median relative error", always,
       scorePatchFlow},
      {"rotation", "angular velocity of a camera that only turns, by contrast maximisation",
       "mean relative error", turns, scoreRotation},
      {"ego_velocity", "velocity of a camera that goes, by flow across edges, depth and a gyroscope",
       "mean relative error", goes, scoreEgoVelocity},
      {"moving_objects", "events of bodies that move, under a moving camera", "1 - area under ROC", hasBodies,
       scoreMovingObjects},
      {"high_pass", "changes of log intensity, from events alone", "1 - correlation", always, scoreHighPass},
      {"complementary", "log intensity, from events and a frame out of ten", "1 - correlation", always,
       scoreComplementary},
      {"corner_tracks", "tracks of corners", "share further than 3 px from the truth", always,
       scoreCornerTracks},
  };
  return table;
}

}  // namespace saccade::eval
