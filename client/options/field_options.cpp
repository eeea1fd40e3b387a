#include "client/options/field_options.h"

namespace saccade::client {
namespace {

// A field stands for all fields below it, of every element of a list. The first row that fits counts.
constexpr struct {
  const char *field, *option;
} kOptions[] = {{"scene", "scene"},
                {"view.fov_x_deg", "--fov"},
                {"view.intrinsics", "--intrinsics"},
                {"view.distortion", "--distortion"},
                {"view.body_camera", "--body-camera"},
                {"view", "--size"},
                {"further_views", "--further-view"},
                {"trajectory.motion.turn_s", "--turn"},
                {"trajectory.motion.start", "--start"},
                {"trajectory.motion.clearance", "--clearance"},
                {"trajectory", "--trajectory"},
                {"objects", "--object"},
                {"animation", "--animation"},
                {"timing.frame_rate_hz", "--rate"},
                {"timing.interval_px", "--interval-px"},
                {"timing.max_rate_hz", "--max-rate"},
                {"timing.refinement", "--finest-px"},
                {"timing.duration_s", "--duration"},
                {"timing.until_path_ends", "--duration"},
                {"timing.clock", "--clock"},
                {"method.name", "--method"},
                {"method.spp", "--spp"},
                {"method.params", "--set"},
                {"quality.bounces", "--bounces"},
                {"quality.disabled_features", "--disable"},
                {"quality.bake_error", "--bake-error"},
                {"quality.budget_ms", "--budget-ms"},
                {"quality.max_false_rate", "--max-false-rate"},
                {"quality.max_event_change", "--max-event-change"},
                {"sensors.threshold_off", "--threshold-off"},
                {"sensors.threshold", "--threshold"},
                {"sensors.bias", "--bias"},
                {"sensors.refractory_s", "--refractory"},
                {"sensors.model", "--model"},
                {"sensors.start_level", "--start-level"},
                {"sensors.reconstruction", "--reconstruction"},
                {"sensors.cutoff_hz", "--cutoff"},
                {"sensors.max_artefact_odds", "--max-artefact-odds"},
                {"sensors.preset", "--preset"},
                {"sensors.noise", "--noise"},
                {"sensors.max_events_per_pixel_frame", "--max-events"},
                {"sensors.labels", "--labels"},
                {"sensors.object_ids", "--object-ids"},
                {"truth.imu.gravity", "--gravity"},
                {"truth.imu.metres_per_unit", "--metres-per-unit"},
                {"truth.imu", "--imu"},
                {"truth", "--truth"},
                {"delivery", "--delivery"},
                {"codec", "--codec"}};

// "sensors.threshold" of "sensors[1].threshold"
std::string withoutIndices(const std::string& field) {
  std::string text;
  bool inside = false;
  for (const char c : field) {
    inside = inside || c == '[';
    if (!inside) text += c;
    if (c == ']') inside = false;
  }
  return text;
}

}  // namespace

std::string optionOf(const std::string& field) {
  const std::string plain = withoutIndices(field) + ".";
  for (const auto& row : kOptions)
    if (plain.starts_with(std::string(row.field) + ".")) return row.option;
  return {};
}

}  // namespace saccade::client
