#include "client/options/rig_options.h"

#include "client/calibration/rig.h"
#include "client/options/request_text.h"

namespace saccade::client {
namespace {

// Puts the camera `view`, whose place is in the axes of the first camera, into those of the body.
void mount(const v1::View& first, v1::View& view) {
  if (!first.has_body_camera()) return;
  *view.mutable_body_camera() = rigidTransform(product(bodyFromCamera(first, 1), bodyFromCamera(view, 1)), 1);
}

}  // namespace

void addRigOptions(CLI::App& command, RigOptions& o) {
  command.option_defaults()->group("Rig");
  command.add_option("--body-camera", o.body_camera,
                     "X,Y,Z[,QX,QY,QZ,QW]: the pose of the camera in the axes of the body that --trajectory "
                     "moves and that has the IMU; of --calibration T_cam_imu tells it");
  command
      .add_option("--further-view", o.further_views,
                  "X,Y,Z[,QX,QY,QZ,QW]: a second camera on the same body, at this pose in the axes of the "
                  "first (x right, y down, z forward), with sensors of its own; may be given again")
      ->allow_extra_args(false);
  command.add_option("--metres-per-unit", o.metres_per_unit,
                     "metres of a unit of the scene, for the IMU and for --calibration");
}

void addViews(const RigOptions& options, const std::vector<v1::View>& views, v1::OpenStream& open) {
  v1::View first = views.front();
  if (!options.body_camera.empty())
    *first.mutable_body_camera() = parsePose("--body-camera", options.body_camera);
  *open.mutable_view() = first;
  open.mutable_further_views()->Add(views.begin() + 1, views.end());
  for (const std::string& text : options.further_views) {
    v1::View& view = *open.add_further_views() = first;
    *view.mutable_body_camera() = parsePose("--further-view", text);
    mount(first, view);
  }
  const auto sensors = open.sensors();  // of one view
  for (int view = 1; view <= open.further_views_size(); ++view) {
    for (v1::Sensor sensor : sensors) {
      sensor.set_view(static_cast<std::uint32_t>(view));
      *open.add_sensors() = sensor;
    }
  }
}

}  // namespace saccade::client
