#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "base/names.h"
#include "scene/camera/motion.h"
#include "scene/files/scene_error.h"
#include "scene/files/text.h"

namespace saccade {
namespace {

// THE list of named motions.
struct NamedMotion {
  std::string name, kind;
  bool moves = true;
};
const std::vector<NamedMotion>& nameTable() {
  static const std::vector<NamedMotion> table{{"right", "truck"},
                                              {"forward", "dolly"},
                                              {"orbit", "orbit"},
                                              {"shake", "shake"},
                                              {"still", "truck", false}};
  return table;
}

}  // namespace

const std::vector<std::string>& motionNames() {
  static const auto names = [] {
    std::vector<std::string> list;
    for (const NamedMotion& motion : nameTable()) list.push_back(motion.name);
    return list;
  }();
  return names;
}

bool isMotionName(const std::string& name) {
  return std::find(motionNames().begin(), motionNames().end(), name) != motionNames().end();
}

Motion namedMotion(const std::string& name, double fov_x_deg) {
  const NamedMotion* found = findRow(nameTable(), name);
  SACCADE_CHECK(found);
  const double focal_px = kMotionWidth / 2 / std::tan(fov_x_deg * std::numbers::pi / 360);
  const double speed = kMotionPxPerFrame * kMotionRateHz / focal_px;
  return {.kind = found->kind, .speed = found->moves ? speed : 0, .image_speed = true};
}

std::optional<Motion> parseMotion(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return {};
  const std::string kind = text.substr(0, colon);
  if (std::find(motionKinds().begin(), motionKinds().end(), kind) == motionKinds().end())
    throw SceneError("'" + kind + "' is not a motion; there are: " + joinNames(motionKinds()));
  const auto speed = parseNumber(std::string_view(text).substr(colon + 1));
  if (!speed) throw SceneError("'" + text + "' is not KIND:SPEED, such as dolly:0.2 or pan:-15");
  if (const std::string fault = speedFault(kind, *speed); !fault.empty())
    throw SceneError(text + ": " + fault);
  return Motion{.kind = kind, .speed = *speed};
}

}  // namespace saccade
