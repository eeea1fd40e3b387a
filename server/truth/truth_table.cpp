#include "base/names.h"
#include "truth/channels/channels.h"

namespace saccade {

const std::vector<TruthChannelInfo>& truthTable() {
  constexpr auto kPicture = v1::LAYOUT_PICTURE, kRows = v1::LAYOUT_ROWS;
  constexpr auto kF32 = v1::ELEMENT_F32, kF64 = v1::ELEMENT_F64;
  static const std::vector<TruthChannelInfo> table = {
      {"depth",
       "depth along the viewing axis at the pixel centre; 1e5 where no surface is",
       "scene units",
       kPicture,
       kF32,
       {"z"},
       makeDepth},
      {"pose",
       "T_world_camera at each frame: position, unit quaternion",
       "scene units",
       kRows,
       kF64,
       {"x", "y", "z", "qx", "qy", "qz", "qw"},
       makePose},
  };
  return table;
}

const TruthChannelInfo* findTruth(const std::string& name) {
  return findRow(truthTable(), name);
}

std::string truthNames() {
  return joinRowNames(truthTable());
}

}  // namespace saccade
