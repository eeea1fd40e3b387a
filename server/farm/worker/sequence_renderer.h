// Renders sequences into files. It keeps scenes and bakes from one sequence to the next.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/request/measured_source.h"
#include "app/sequence/stream_plan.h"
#include "base/tile_pool.h"
#include "client/options/record_job.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::farm {

struct RenderSettings {
  std::string scenes, meshes;            // folders, as those of saccaded
  std::string bakes;                     // likewise; empty: there are none
  std::string accuracy, simplification;  // likewise, tables of plan and check
};

class SequenceRenderer {
 public:
  SequenceRenderer(const RenderSettings& settings, int threads);

  // Checks a request without loading its scene. Throws Refusal.
  StreamPlan plan(const v1::OpenStream& request) const;
  // Loads the scene of a plan, and finds the path of the body. Throws Refusal and SceneError.
  Trajectory load(StreamPlan& plan);

  // Renders the request that all jobs have into their files, of all frames or the first `most_frames`.
  // Returns what each sensor of each file holds, and the file. Throws Refusal, SceneError, and as Recorder
  // does.
  std::vector<std::pair<std::string, v1::Recording>> render(const std::vector<client::RecordJob>& jobs,
                                                            FrameIndex most_frames = 0);

  std::uint64_t sceneBytes() const { return scenes_.bytes(); }

 private:
  const Limits limits_;
  const MeasuredTables tables_;
  TilePool pool_;
  SceneCache scenes_;
  BakeStore bakes_;
  v1::ServerDescription description_;
};

}  // namespace saccade::farm
