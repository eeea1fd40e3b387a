#include "app/request/resolve_objects.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
#include "scene/motion/own_motions.h"

namespace saccade {
namespace {

constexpr double kMaxClockSeconds = 1e9;  // between the first poses of two texts

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

// None of motions, which need the scene, and of csv.
std::optional<Trajectory> readPath(v1::ObjectPath& path, const std::string& field) {
  if (path.has_keyframes()) return readKeyframes(*path.mutable_keyframes(), field + ".keyframes");
  if (path.path_case() == v1::ObjectPath::PATH_NOT_SET)
    refuse(field, "give a motion, keyframes, csv, own or still; a motion is one of: " +
                      joinNames(objectMotionKinds()));
  if (path.has_motion()) checkMotion(path.motion(), field + ".motion");
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

// Poses of a text, at the stream times of the clock that all texts share.
std::vector<TimedPose> atStreamTime(PoseText text, std::int64_t zero_ns, const std::string& field) {
  const double later_s = (static_cast<double>(text.begin.count()) - static_cast<double>(zero_ns)) * 1e-9;
  const double last_s = later_s + seconds(text.poses.back().time);
  if (std::abs(later_s) > kMaxClockSeconds || (last_s < 0 && text.poses.size() > 1))
    refuse(field, "its poses are at stream times from " + std::to_string(later_s) + " to " +
                      std::to_string(last_s) + " s; all texts of a request have one clock");
  for (TimedPose& key : text.poses) key.time += text.begin - TimeNs{zero_ns};
  return std::move(text.poses);
}

// A text per object; none where it has none.
using Texts = std::vector<std::optional<PoseText>>;

Texts readTexts(const v1::OpenStream& request) {
  Texts texts;
  for (const v1::ObjectMotion& object : request.objects()) {
    const std::string field = fieldOf(texts.size()) + ".path.csv";
    texts.emplace_back();
    if (object.path().has_csv()) texts.back() = readCsv(object.path().csv(), field);
  }
  return texts;
}

void takeTexts(Texts texts, ResolvedStream& stream) {
  std::int64_t zero_ns = std::numeric_limits<std::int64_t>::max();
  for (const auto& text : texts)
    if (text) zero_ns = std::min(zero_ns, text->begin.count());
  zero_ns = stream.path_begin_ns.value_or(zero_ns);
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (texts[i])
      stream.objects[i].path =
          Trajectory(atStreamTime(std::move(*texts[i]), zero_ns, fieldOf(i) + ".path.csv"));
}

// Of the copy of all lamps that a feed keeps at one time where some move. A triangle is part of three tables.
double lampBytes(const Scene& scene) {
  constexpr double kTriangleBytes = 400, kVertexBytes = 64;
  if (!anyLampMoves(scene)) return 0;
  const std::size_t deltas =
      scene.point_lights.size() + scene.spot_lights.size() + scene.directional_lights.size();
  double bytes = kTriangleBytes * static_cast<double>(deltas);
  for (const Mesh& mesh : scene.meshes)
    if (emits(mesh))
      bytes += kTriangleBytes * static_cast<double>(mesh.triangles.size()) +
               kVertexBytes * static_cast<double>(mesh.positions.size());
  for (const Sphere& sphere : scene.spheres)
    if (emits(sphere)) bytes += kTriangleBytes;
  return bytes;
}

// Of the copies of bodies that deform, with their trees, that a feed keeps at one time.
double deformedBytes(const Scene& scene) {
  constexpr double kTriangleBytes = 300, kVertexBytes = 32;
  std::vector<char> bodies(scene.bodies.size());
  for (const Mesh& mesh : scene.meshes)
    if (deforms(mesh)) bodies[static_cast<std::size_t>(mesh.body)] = true;
  double bytes = 0;
  for (const Mesh& mesh : scene.meshes)
    if (mesh.body != kStands && bodies[static_cast<std::size_t>(mesh.body)])
      bytes += kTriangleBytes * static_cast<double>(mesh.triangles.size()) +
               kVertexBytes * static_cast<double>(mesh.positions.size());
  return bytes;
}

bool mayMove(const v1::ObjectMotion& object, const v1::OpenStream& request) {
  return !object.path().has_still() || request.timing().steerable();
}

// Of a motion that the scene makes.
Trajectory pathOf(const v1::ObjectMotion& object, const Scene& scene, const Body& body) {
  if (object.path().has_motion()) return makeObjectMotion(motionOf(object.path().motion()), scene, body);
  if (object.path().has_own()) return makeOwnMotion(*ownMotion(scene, object.name()), scene, body);
  return Trajectory({{TimeNs{0}, {toDouble(body.centre()) + scene.origin, {}}}});
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
    if (object.name().empty()) refuse(field + ".name", "give the name of an object of the scene");
    if (!names.insert(object.name()).second)
      refuse(field + ".name", "the object '" + cutText(object.name(), kMaxEcho) + "' is given twice");
    stream.objects.push_back({stream.objects.size(), readPath(*object.mutable_path(), field + ".path")});
  }
  takeTexts(readTexts(request), stream);
  sortByName(stream);
}

std::vector<std::string> bodyNames(const v1::OpenStream& request) {
  std::vector<std::string> names;
  for (const v1::ObjectMotion& object : request.objects())
    if (mayMove(object, request)) names.push_back(object.name());
  return names;
}

std::vector<std::string> rigidNames(const v1::OpenStream& request) {
  std::vector<std::string> names;
  for (const v1::ObjectMotion& object : request.objects())
    if (mayMove(object, request) && object.path().has_still()) names.push_back(object.name());
  return names;
}

void setBodyPaths(const Scene& scene, ResolvedStream& stream) {
  std::vector<Trajectory> paths;
  for (std::size_t i = 0; i < stream.objects.size(); ++i) {
    const v1::ObjectMotion& object = stream.request.objects(static_cast<int>(i));
    if (!mayMove(object, stream.request)) continue;
    const auto& given = stream.objects[i].path;
    paths.push_back(given ? *given : pathOf(object, scene, scene.bodies.at(paths.size())));
  }
  SACCADE_CHECK(scene.bodies.size() == paths.size());
  stream.shape_bytes = lampBytes(scene) + deformedBytes(scene);
  for (FeedConfig& feed : stream.further) feed.body_paths = paths;
  stream.feed.body_paths = std::move(paths);
}

}  // namespace saccade
