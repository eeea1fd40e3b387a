#include "app/sequence/stream_plan.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/admission/stream_cost.h"
#include "app/request/refusal.h"
#include "app/request/resolve.h"
#include "app/request/resolve_objects.h"
#include "app/sequence/stream_rig.h"
#include "base/names.h"
#include "base/text_cut.h"
#include "render/world/render_scene.h"

namespace saccade {
namespace {

SceneEntry findScene(const std::string& name, const SceneLibrary& library) {
  const std::optional<SceneEntry> entry = library.find(name);
  if (!entry) throw Refusal(v1::CODE_NOT_FOUND, "scene", library.unknown(name));
  if (!entry->unavailable.empty()) throw Refusal(v1::CODE_UNAVAILABLE, "scene", entry->unavailable);
  return *entry;
}

// Before the scene is loaded, which would be told as a fault of the scene.
void checkAnimation(const std::string& name, const std::string& scene, const SceneLibrary& library) {
  if (name.empty()) return;
  const std::vector<std::string> names = library.animations(scene);
  if (std::ranges::find(names, name) != names.end()) return;
  const std::string valid = names.empty() ? "; it has none: only scenes of glTF do"
                                          : "; it has: " + cutText(joinNames(names), kMostNames);
  throw Refusal(v1::CODE_NOT_FOUND, "animation",
                "the scene has no animation '" + cutText(name, kMaxEcho) + "'" + valid);
}

ResolvedStream check(v1::OpenStream request, const SceneLibrary& library, const MeasuredTables& tables) {
  if (request.pushed()) return resolvePushed(std::move(request));
  const SceneEntry entry = findScene(request.scene(), library);
  checkAnimation(request.animation(), request.scene(), library);
  return resolve(std::move(request), entry, tables);
}

}  // namespace

StreamPlan planStream(v1::OpenStream request, const SceneLibrary& library, const MeasuredTables& tables,
                      const Limits& limits) {
  limitRates(limits[Limit::kFrameRate], *request.mutable_timing());
  StreamPlan plan{check(std::move(request), library, tables)};
  checkAlone(plan.resolved.request, limits);
  boundEvents(plan.resolved, limits);
  boundRows(plan.resolved, limits);
  boundSteering(plan.resolved, limits);
  return plan;
}

void loadScenes(StreamPlan& plan, SceneCache& scenes, const BuildContext& context) {
  ResolvedStream& resolved = plan.resolved;
  const std::string& name = resolved.request.scene();
  plan.whole = scenes.get(name, context.stop, context.setProgress, resolved.request.animation());
  fitTo(plan.whole->description(), resolved);
  const SceneVariant variant{resolved.disabled_features, bodyNames(resolved.request),
                             rigidNames(resolved.request), resolved.request.animation()};
  plan.scene = scenes.vary(name, plan.whole, variant, context.stop);
  setBodyPaths(plan.scene->description(), resolved);
}

void bakeLight(StreamPlan& plan, const Trajectory& body, BakeStore& bakes, TilePool& pool,
               const BuildContext& context) {
  ResolvedStream& resolved = plan.resolved;
  if (!resolved.request.quality().has_bake_error()) return;
  plan.bake =
      bakes.get(plan.scene, planBakeOf(*plan.scene, body, resolved), pool, context.stop, context.setProgress);
  resolved.feed.baked = {plan.bake, plan.bake->light.get()};
  for (FeedConfig& feed : resolved.further) feed.baked = resolved.feed.baked;
}

}  // namespace saccade
