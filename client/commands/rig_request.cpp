#include <stdexcept>

#include "client/commands/request_options.h"
#include "client/commands/request_text.h"

namespace saccade::client {
namespace {

std::vector<double> parseNumbers(std::string text) {
  std::vector<double> numbers;
  while (!text.empty()) {
    const auto [first, rest] = splitAt(text, ',');
    const auto number = parseNumber<double>(first);
    if (!number) return {};
    numbers.push_back(*number);
    text = rest;
  }
  return numbers;
}

v1::RigidTransform parseTransform(const std::string& text) {
  const std::vector<double> n = parseNumbers(text);
  if (n.size() != 3 && n.size() != 7)
    throw std::invalid_argument("--further-view: '" + text + "' is not X,Y,Z or X,Y,Z,QX,QY,QZ,QW");
  v1::RigidTransform transform;
  v1::Vector3& position = *transform.mutable_position();
  position.set_x(n[0]), position.set_y(n[1]), position.set_z(n[2]);
  if (n.size() == 3) return transform;
  v1::Quaternion& rotation = *transform.mutable_rotation();
  rotation.set_x(n[3]), rotation.set_y(n[4]), rotation.set_z(n[5]), rotation.set_w(n[6]);
  return transform;
}

}  // namespace

void addFurtherViews(const RequestOptions& options, v1::OpenStream& open) {
  const auto sensors = open.sensors();  // of one view
  for (const std::string& text : options.further_views) {
    v1::View& view = *open.add_further_views();
    view = open.view();
    *view.mutable_body_camera() = parseTransform(text);
    for (v1::Sensor sensor : sensors) {
      sensor.set_view(static_cast<std::uint32_t>(open.further_views_size()));
      *open.add_sensors() = sensor;
    }
  }
}

}  // namespace saccade::client
