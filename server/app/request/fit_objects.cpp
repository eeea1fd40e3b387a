// Joins the objects of a request with those that its scene moves.
#include <algorithm>
#include <set>

#include "app/request/refusal.h"
#include "app/request/resolve_objects.h"
#include "base/names.h"
#include "base/text_cut.h"
#include "scene/motion/bodies.h"
#include "scene/motion/own_motions.h"

namespace saccade {
namespace {

std::string quoted(const std::string& name) {
  return "'" + cutText(name, kMaxEcho) + "'";
}

void checkObject(const Scene& scene, const std::set<std::string>& known, const v1::ObjectMotion& object,
                 const std::string& field) {
  if (!known.contains(object.name()))
    throw Refusal(v1::CODE_NOT_FOUND, field + ".name",
                  "the scene has no object " + quoted(object.name()) +
                      "; it has: " + cutText(joinNames(known), kMostNames));
  if (object.path().has_own() && !ownMotion(scene, object.name()))
    throw Refusal(v1::CODE_NOT_FOUND, field + ".path.own",
                  "the scene does not move " + quoted(object.name()) +
                      "; it moves: " + cutText(joinRowNames(scene.motions), kMostNames));
}

void checkGiven(const Scene& scene, const ResolvedStream& stream) {
  if (stream.objects.empty()) return;
  const std::set<std::string> known = objectNames(scene);
  for (std::size_t i = 0; i < stream.objects.size(); ++i)
    checkObject(scene, known, stream.request.objects(static_cast<int>(i)),
                "objects[" + std::to_string(*stream.objects[i].given) + "]");
}

// Objects that stand anyway would make equal feeds different.
bool hasEffect(const v1::ObjectMotion& object, const Scene& scene, const v1::OpenStream& request) {
  return !object.path().has_still() || request.timing().steerable() || ownMotion(scene, object.name());
}

// Joins both, each of which is sorted by name.
void join(const Scene& scene, ResolvedStream& stream) {
  google::protobuf::RepeatedPtrField<v1::ObjectMotion> given;
  given.Swap(stream.request.mutable_objects());
  std::vector<ResolvedObject> resolved;
  const auto addOwn = [&](const OwnMotion& own) {
    v1::ObjectMotion& object = *stream.request.add_objects();
    object.set_name(own.name);
    object.mutable_path()->mutable_own();
    resolved.push_back({.own_poses = own.poses});
  };
  auto own = scene.motions.begin();
  for (int i = 0; i < given.size(); ++i) {
    for (; own != scene.motions.end() && own->name < given[i].name(); ++own) addOwn(*own);
    const bool named = own != scene.motions.end() && own->name == given[i].name();
    ResolvedObject& object = stream.objects[static_cast<std::size_t>(i)];
    if (named && given[i].path().has_own()) object.own_poses = own->poses;
    if (named) ++own;
    if (!hasEffect(given[i], scene, stream.request)) continue;
    stream.request.add_objects()->Swap(&given[i]);
    resolved.push_back(std::move(object));
  }
  for (; own != scene.motions.end(); ++own) addOwn(*own);
  stream.objects = std::move(resolved);
}

void checkMayMove(const ResolvedStream& stream) {
  const std::vector<std::string> moving = bodyNames(stream.request);
  if (moving.empty()) return;
  const std::string why = "; these move: " + cutText(joinNames(moving), kMostNames);
  if (stream.expected || stream.simplification)
    throw Refusal(v1::CODE_UNAVAILABLE, "quality", "no scene is measured with moving objects" + why);
  if (stream.request.quality().has_bake_error())
    refuse("quality.bake_error",
           "light is computed ahead for scenes that stand; leave out objects, or let them stand" + why);
}

}  // namespace

void fitObjects(const Scene& scene, ResolvedStream& stream) {
  checkGiven(scene, stream);
  join(scene, stream);
  if (stream.request.objects_size() > ranges::kObjects.max)
    refuse("objects",
           "with those that the scene moves there are more than " + std::to_string(ranges::kObjects.max));
  checkMayMove(stream);
}

}  // namespace saccade
