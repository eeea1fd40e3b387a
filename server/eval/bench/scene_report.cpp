#include "eval/bench/scene_report.h"

#include "base/names.h"
#include "base/text_cut.h"
#include "eval/pictures/text.h"
#include "scene/motion/bodies.h"
#include "scene/scene_stats.h"
#include "scene/scene_warnings.h"

namespace saccade::eval {

std::string reportLine(const std::string& what, const std::string& text) {
  return format("%-9s %s\n", what.c_str(), text.c_str());
}

std::string sceneReport(const Scene& scene) {
  std::string report = reportLine("holds", statsOf(scene).text());
  report += reportLine("objects", cutText(joinNames(objectNames(scene)), kMostNames));
  report += reportLine(
      "camera", format("%d x %d pixels, %.4g degrees across", scene.width, scene.height, scene.fov_x_deg));
  if (scene.bounces) report += reportLine("author", std::to_string(*scene.bounces) + " indirect bounces");
  for (const std::string& warning : warningsOf(scene)) report += reportLine("not read", warning);
  return report;
}

}  // namespace saccade::eval
