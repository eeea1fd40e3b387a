#include <stdexcept>

#include "client/options/pose_text.h"
#include "client/options/request_options.h"
#include "client/options/request_text.h"

namespace saccade::client {
namespace {

bool isFile(const std::string& path) {
  return path.ends_with(".txt") || isTrajectoryFile(path);
}

// Of KIND:SPEED.
v1::ObjectSpeed makeMotion(const std::string& text) {
  const auto [kind, speed] = splitAt(text, ':');
  const auto value = parseNumber<double>(speed);
  if (!value)
    throw std::invalid_argument(
        "--object: '" + text +
        "' is neither a .csv or .txt file, nor KIND:SPEED such as spin:90, nor still or own");
  v1::ObjectSpeed motion;
  motion.set_kind(enumValue<v1::ObjectMotionKind>("--object", kind));
  motion.set_speed(*value);
  return motion;
}

}  // namespace

void addObjects(const std::vector<std::string>& objects, v1::OpenStream& open) {
  for (const std::string& text : objects) {
    const auto [name, path] = splitAt(text, '=');
    if (name.empty() || path.empty())
      throw std::invalid_argument("--object: '" + text + "' is not NAME=PATH, such as bunny=spin:90");
    v1::ObjectMotion& object = *open.add_objects();
    object.set_name(name);
    if (path == "still")
      object.mutable_path()->mutable_still();
    else if (path == "own")
      object.mutable_path()->mutable_own();
    else if (isFile(path))
      object.mutable_path()->set_csv(readPoseText("--object", path));
    else
      *object.mutable_path()->mutable_motion() = makeMotion(path);
  }
}

}  // namespace saccade::client
