// A request whose every value is checked, and every default filled in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "events/sensor_config.h"
#include "feed/feed_config.h"
#include "render/features/simplify.h"
#include "saccade/v1/control.pb.h"
#include "scene/camera/trajectory.h"
#include "truth/truth_config.h"

namespace saccade {

// An object that moves, or that the client stops.
struct ResolvedObject {
  std::optional<std::size_t> given = {};  // its place in the client's request; none: the scene moves it
  std::optional<Trajectory> path = {};    // of keyframes and csv; other motions need the scene
  std::size_t own_poses = 0;              // of a path that the scene gives it
};

struct ResolvedStream {
  v1::OpenStream request = {};                 // as StreamOpened.resolved
  FeedConfig feed = {};                        // of view 0
  std::vector<FeedConfig> further = {};        // of the further views
  std::vector<Pose> T_body_camera = {Pose{}};  // of each view
  std::vector<SensorConfig> sensors = {};
  std::vector<std::vector<SensorChange>> changes = {};  // by sensor, in order of time
  std::vector<TruthConfig> truth = {};
  FrameIndex frames = 0;                           // intervals to render; 0: until closed
  std::optional<Trajectory> given_path = {};       // of keyframes and csv; other paths need the scene
  std::optional<std::int64_t> path_begin_ns = {};  // of csv: the time that its text gives the first pose
  std::vector<ResolvedObject> objects = {};        // in the order of request.objects: by name
  double shape_bytes = 0;                          // of shapes that a feed keeps for itself at one time
  SceneFeatures disabled_features = {};
  bool chooses_method = false;      // the request, or its budget; otherwise fitTo() may take another one
  bool chooses_refinement = false;  // the request, by Refinement.finest_px
  std::optional<v1::ExpectedQuality> expected = {};       // of a request with a budget
  std::optional<v1::ExpectedChange> simplification = {};  // of a request with a max_event_change

  std::size_t views() const { return T_body_camera.size(); }
  const FeedConfig& feedOf(std::size_t view) const { return view == 0 ? feed : further[view - 1]; }

  // Streams with equal keys share a feed.
  std::string feedKey() const;
  // Streams with equal keys would share it, if they had the same speed.
  std::string feedKeyOfAnySpeed() const;
  // Frames of streams with equal keys cost the same.
  std::string costKey() const;
};

}  // namespace saccade
