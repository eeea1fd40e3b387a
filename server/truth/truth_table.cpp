#include "base/names.h"
#include "saccade/wire/ranges.h"
#include "truth/truth_source.h"

namespace saccade {

// Each in the file of its channel.
std::unique_ptr<TruthSource> makeDepth(const TruthConfig& config);
std::unique_ptr<TruthSource> makeImu(const TruthConfig& config);
std::unique_ptr<TruthSource> makePose(const TruthConfig& config);
std::unique_ptr<TruthSource> makeDistance(const TruthConfig& config);
std::unique_ptr<TruthSource> makeNormals(const TruthConfig& config);
std::unique_ptr<TruthSource> makeIntensity(const TruthConfig& config);
std::unique_ptr<TruthSource> makeBrightness(const TruthConfig& config);
std::unique_ptr<TruthSource> makeFlowBackward(const TruthConfig& config);
std::unique_ptr<TruthSource> makeFlowForward(const TruthConfig& config);
std::unique_ptr<TruthSource> makeVelocity(const TruthConfig& config);
std::unique_ptr<TruthSource> makeObjectPoses(const TruthConfig& config);
std::unique_ptr<TruthSource> makeObjectVelocities(const TruthConfig& config);
std::unique_ptr<TruthSource> makeFrame(const TruthConfig& config);    // 8 bits
std::unique_ptr<TruthSource> makeFrame16(const TruthConfig& config);  // 16 bits
std::unique_ptr<TruthSource> makeIds(const TruthConfig& config);

const std::vector<TruthChannelInfo>& truthTable() {
  constexpr auto kPicture = v1::LAYOUT_PICTURE, kRows = v1::LAYOUT_ROWS;
  constexpr auto kF32 = v1::ELEMENT_F32, kF64 = v1::ELEMENT_F64, kU32 = v1::ELEMENT_U32;
  constexpr auto kU8 = v1::ELEMENT_U8, kU16 = v1::ELEMENT_U16;
  using Setting = TruthChannelInfo::Setting;
  using Needs = TruthChannelInfo::Needs;
  static const std::vector<TruthChannelInfo> table = {
      {"depth",
       "depth along the viewing axis at the pixel centre; 1e5 where no surface is",
       "scene units",
       kPicture,
       kF32,
       {"z"},
       makeDepth},
      {"distance",
       "distance from the camera to the surface at the pixel centre; 1e5 where no surface is",
       "scene units",
       kPicture,
       kF32,
       {"distance"},
       makeDistance},
      {"normals",
       "unit shading normal in world axes, towards the camera; 0 where no surface is",
       "",
       kPicture,
       kF32,
       {"x", "y", "z"},
       makeNormals},
      {"flow_backward",
       "position in the frame before minus position in this one; valid is 1 where both show the surface, "
       "else 0",
       "pixels",
       kPicture,
       kF32,
       {"x", "y", "valid"},
       makeFlowBackward,
       Needs::kScene,
       Setting::kNone,
       true},
      {"flow_forward",
       "position in the next frame minus position in this one; valid is 1 where both show the surface, else "
       "0",
       "pixels",
       kPicture,
       kF32,
       {"x", "y", "valid"},
       makeFlowForward,
       Needs::kScene,
       Setting::kNone,
       true},
      {"ids",
       "object and material that the pixel centre meets first, counted from 1 on; 0 where no surface is",
       "",
       kPicture,
       kU32,
       {"object", "material"},
       makeIds},
      {"intensity",
       "luminance (Rec. 709, linear) from which the sensors make events",
       "scene luminance",
       kPicture,
       kF32,
       {"intensity"},
       makeIntensity,
       Needs::kIntensity},
      {"brightness",
       "log(bias + intensity), natural logarithm",
       "",
       kPicture,
       kF32,
       {"brightness"},
       makeBrightness,
       Needs::kIntensity,
       Setting::kBias},
      {"frame",
       "exposed picture: gain times mean intensity, clipped to [0, 1], to the power 1 / gamma, times 255",
       "",
       kPicture,
       kU8,
       {"value"},
       makeFrame,
       Needs::kIntensity,
       Setting::kExposure},
      {"frame16",
       "the same with 16 bits: times 65535",
       "",
       kPicture,
       kU16,
       {"value"},
       makeFrame16,
       Needs::kIntensity,
       Setting::kExposure},
      {"pose",
       "T_world_camera at each frame: position, unit quaternion",
       "scene units",
       kRows,
       kF64,
       {"x", "y", "z", "qx", "qy", "qz", "qw"},
       makePose},
      {"velocity",
       "velocity of the camera at each frame: linear in world axes, angular in the axes of the camera "
       "(right, down, forward); just before the frame where it jumps",
       "scene units/s, rad/s",
       kRows,
       kF64,
       {"vx", "vy", "vz", "wx", "wy", "wz"},
       makeVelocity},
      {"object_poses",
       "T_world_object of each object that moves, at each frame: its number in ids, position of its centre, "
       "unit quaternion",
       "scene units",
       kRows,
       kF64,
       {"object", "x", "y", "z", "qx", "qy", "qz", "qw"},
       makeObjectPoses},
      {"object_velocities",
       "velocity of each object that moves, at each frame: its number in ids, linear of its centre in world "
       "axes, angular in its own axes; just before the frame where it jumps",
       "scene units/s, rad/s",
       kRows,
       kF64,
       {"object", "vx", "vy", "vz", "wx", "wy", "wz"},
       makeObjectVelocities},
      {"imu",
       "specific force and angular velocity of the body, in its axes: means over the sample period that ends",
       "m/s^2, rad/s",
       kRows,
       kF64,
       {"ax", "ay", "az", "gx", "gy", "gz"},
       makeImu},
  };
  return table;
}

const TruthChannelInfo* findTruth(const std::string& name) {
  return findRow(truthTable(), name);
}

double rowsOfFrame(const TruthConfig& config) {
  if (findTruth(config.name)->layout != v1::LAYOUT_ROWS) return 0;
  if (tellsObjects(config.name)) return ranges::kObjects.max;
  return config.name == "imu" ? config.imu.rate_hz / config.frame_rate_hz : 1;
}

bool tellsObjects(const std::string& name) {
  return name == "ids" || name == "object_poses" || name == "object_velocities";
}

std::string truthNames() {
  return joinRowNames(truthTable());
}

std::string truthNamesOf(TruthChannelInfo::Needs needs) {
  std::string names;
  for (const TruthChannelInfo& info : truthTable()) {
    if (info.needs == needs) names += (names.empty() ? "" : ", ") + info.name;
  }
  return names;
}

}  // namespace saccade
