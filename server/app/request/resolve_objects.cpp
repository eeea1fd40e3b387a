#include "app/request/resolve_objects.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "app/request/enum_names.h"
#include "app/request/read_path.h"
#include "app/request/refusal.h"
#include "base/check.h"
#include "base/names.h"
#include "base/text_cut.h"
#include "scene/motion/bodies.h"
#include "scene/motion/object_motion.h"

namespace saccade {
namespace {

constexpr std::size_t kMostNames = 1024;  // bytes of a list of names in a refusal

std::string fieldOf(std::size_t place) {
  return "objects[" + std::to_string(place) + "]";
}

ObjectMotion motionOf(const v1::ObjectSpeed& motion) {
  return {nameWithout("OBJECT_MOTION_KIND_", v1::ObjectMotionKind_Name(motion.kind())), motion.speed()};
}

void checkMotion(const v1::ObjectSpeed& motion, const std::string& field) {
  if (motion.kind() == v1::OBJECT_MOTION_KIND_UNSPECIFIED)
    refuse(field + ".kind", "give one of: " + joinNames(objectMotionKinds()));
  resolveEnum(field + ".kind", motion.kind(), v1::OBJECT_MOTION_KIND_UNSPECIFIED);
  const std::string fault = objectSpeedFault(motion.speed());
  if (!fault.empty()) refuse(field + ".speed", fault);
}

// None of a motion, which needs the scene.
std::optional<Trajectory> readPath(v1::ObjectPath& path, const std::string& field) {
  if (path.has_keyframes()) return readKeyframes(*path.mutable_keyframes(), field + ".keyframes");
  if (path.has_csv()) return Trajectory(readCsv(path.csv(), field + ".csv").poses);
  if (!path.has_motion())
    refuse(field, "give a motion, keyframes or csv; a motion is one of: " + joinNames(objectMotionKinds()));
  checkMotion(path.motion(), field + ".motion");
  return {};
}

// All texts together are bounded as that of a camera is.
void checkTexts(const v1::OpenStream& request) {
  std::size_t bytes = 0;
  for (int i = 0; i < request.objects_size(); ++i) {
    bytes += request.objects(i).path().csv().size();
    if (bytes > ranges::kMaxCsvBytes)
      refuse(fieldOf(static_cast<std::size_t>(i)) + ".path.csv",
             "the texts of all objects are longer than " + std::to_string(ranges::kMaxCsvBytes) + " bytes");
  }
}

void sortByName(ResolvedStream& stream) {
  std::vector<int> order(stream.objects.size());
  std::iota(order.begin(), order.end(), 0);
  auto& given = *stream.request.mutable_objects();
  std::ranges::sort(order, {}, [&](int i) -> const std::string& { return given[i].name(); });
  google::protobuf::RepeatedPtrField<v1::ObjectMotion> sorted;
  std::vector<ResolvedObject> objects;
  for (const int i : order) {
    sorted.Add()->Swap(&given[i]);
    objects.push_back(std::move(stream.objects[static_cast<std::size_t>(i)]));
  }
  given.Swap(&sorted);
  stream.objects = std::move(objects);
}

}  // namespace

void checkObjects(ResolvedStream& stream) {
  v1::OpenStream& request = stream.request;
  if (request.objects_size() > ranges::kObjects.max)
    refuse("objects", "there are more than " + std::to_string(ranges::kObjects.max));
  checkTexts(request);
  std::set<std::string> names;
  for (v1::ObjectMotion& object : *request.mutable_objects()) {
    const std::string field = fieldOf(stream.objects.size());
    if (object.name().empty()) refuse(field + ".name", "give the name of a shape of the scene");
    if (!names.insert(object.name()).second)
      refuse(field + ".name", "the object '" + cutText(object.name(), kMaxEcho) + "' is given twice");
    stream.objects.push_back({stream.objects.size(), readPath(*object.mutable_path(), field + ".path")});
  }
  sortByName(stream);
}

std::vector<std::string> objectNames(const v1::OpenStream& request) {
  std::vector<std::string> names;
  for (const v1::ObjectMotion& object : request.objects()) names.push_back(object.name());
  return names;
}

void findObjects(const Scene& scene, const ResolvedStream& stream) {
  if (stream.objects.empty()) return;
  const std::set<std::string> known = shapeNames(scene);
  for (std::size_t i = 0; i < stream.objects.size(); ++i) {
    const std::string& name = stream.request.objects(static_cast<int>(i)).name();
    if (known.contains(name)) continue;
    throw Refusal(v1::CODE_NOT_FOUND, fieldOf(stream.objects[i].given) + ".name",
                  "the scene has no object '" + cutText(name, kMaxEcho) +
                      "'; it has: " + cutText(joinNames(known), kMostNames));
  }
}

void setBodyPaths(const Scene& scene, ResolvedStream& stream) {
  SACCADE_CHECK(scene.bodies.size() == stream.objects.size());
  std::vector<Trajectory> paths;
  for (std::size_t i = 0; i < stream.objects.size(); ++i) {
    const v1::ObjectPath& path = stream.request.objects(static_cast<int>(i)).path();
    const auto& given = stream.objects[i].path;
    paths.push_back(given ? *given : makeObjectMotion(motionOf(path.motion()), scene, scene.bodies[i]));
  }
  for (FeedConfig& feed : stream.further) feed.body_paths = paths;
  stream.feed.body_paths = std::move(paths);
}

}  // namespace saccade
