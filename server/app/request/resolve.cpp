#include "app/request/resolve.h"
#include "app/request/resolve_objects.h"
#include "app/request/resolve_parts.h"
#include "app/request/resolve_quality.h"
#include "app/request/resolve_trajectory.h"
#include "app/request/resolve_view.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include "app/request/enum_names.h"
#include "app/request/refusal.h"
#include "base/names.h"
#include "base/text_cut.h"
#include "methods/optional_method.h"
#include "scene/emitter_strengths.h"

namespace saccade {
namespace {

void resolveViews(ResolvedStream& stream) {
  const v1::OpenStream& request = stream.request;
  stream.feed.camera = resolveView(request.view(), viewField(0));
  if (request.further_views_size() > ranges::kFurtherViews.max)
    refuse("further_views", "there are more than " + std::to_string(ranges::kFurtherViews.max));
  for (const v1::View& view : request.further_views()) {
    FeedConfig& feed = stream.further.emplace_back();
    feed.camera = resolveView(view, viewField(stream.further.size()));
  }
  resolveMounts(stream);
}

void checkMethodName(const v1::Method& method) {
  if (method.name().empty() || findMethod(method.name())) return;
  refuse("method.name", noMethod(method.name()));
}

// checkMethodName() comes first.
void resolveMethod(v1::Method& method, FeedConfig& feed) {
  if (method.name().empty()) method.set_name(defaultMethod(true).name);
  const MethodInfo* info = findMethod(method.name());
  const ParamValues given(method.params().begin(), method.params().end());
  std::string bad_name;
  if (std::string fault = resolveParams(*info, given, feed.params, bad_name); !fault.empty()) {
    refuse("method.params[\"" + cutText(bad_name, kMaxEcho) + "\"]", fault);
  }
  method.mutable_params()->insert(feed.params.begin(), feed.params.end());

  if (method.spp() == 0) method.set_spp(2);
  checkRange("method.spp", method.spp(), ranges::kSpp);
  if (!takesSpp(*info, feed.params, static_cast<int>(method.spp()))) {
    refuse("method.spp", method.name() + " traces two passes of spp / 2 paths: spp must be even");
  }
  feed.method = method.name();
  feed.spp = static_cast<int>(method.spp());
}

// Instead of the default for steady light.
void takeMethod(const MethodInfo& info, ResolvedStream& stream) {
  v1::Method& method = *stream.request.mutable_method();
  method.set_name(info.name);
  method.clear_params();
  resolveMethod(method, stream.feed);
  v1::Timing& timing = *stream.request.mutable_timing();
  if (timing.has_refinement() && !stream.chooses_refinement) timing.mutable_refinement()->clear_finest_px();
  resolveRefinement(stream);
  shareSettings(stream);
}

void resolveQuality(v1::Quality& quality, ResolvedStream& stream) {
  if (!quality.has_bounces()) quality.set_bounces(3);
  checkRange("quality.bounces", quality.bounces(), ranges::kBounces);
  stream.feed.bounces = static_cast<int>(quality.bounces());
  stream.feed.monochrome = quality.monochrome();
  stream.disabled_features = resolveDisabledFeatures(quality);
  stream.feed.jitter = quality.jitter();
  if (!quality.has_bake_error()) return;
  checkRange("quality.bake_error", quality.bake_error(), ranges::kBakeError);
  if (!findMethod(stream.feed.method)->takes_baked)
    refuse("quality.bake_error", stream.feed.method + " has no use for light that is computed ahead");
}

v1::OpenStream feedPart(v1::OpenStream request) {
  request.clear_sensors();
  request.clear_truth();
  request.clear_delivery();
  request.clear_codec();
  return request;
}

void clearSpeeds(v1::OpenStream& request) {
  request.mutable_timing()->clear_speed();
  request.mutable_timing()->clear_min_speed();
}

std::string keyOf(const v1::OpenStream& part) {
  std::string key;
  google::protobuf::io::StringOutputStream text(&key);
  google::protobuf::io::CodedOutputStream out(&text);
  out.SetSerializationDeterministic(true);  // maps in order
  part.SerializeToCodedStream(&out);
  out.Trim();
  return key;
}

}  // namespace

ResolvedStream resolve(v1::OpenStream request, const SceneEntry& scene, const MeasuredTables& tables) {
  ResolvedStream stream{.request = std::move(request)};
  v1::OpenStream& r = stream.request;
  checkTrajectory(stream, scene);
  checkObjects(stream);
  resolveViews(stream);
  resolveTiming(stream);
  resolveSensors(stream);
  resolveTruths(stream);
  checkMethodName(r.method());
  stream.simplification = resolveSimplification(r, tables.simplification);
  stream.expected = resolveBudget(r, stream.sensors, tables.accuracy);
  stream.chooses_method = !r.method().name().empty() || !r.method().params().empty();
  resolveMethod(*r.mutable_method(), stream.feed);
  resolveQuality(*r.mutable_quality(), stream);
  if (r.timing().steerable() && r.quality().has_bake_error())
    refuse("quality.bake_error",
           "light is computed ahead for the surfaces of a path, and a steered path is not known");
  resolveDelivery(r);
  stream.feed.seed = r.seed();
  stream.chooses_refinement = r.timing().refinement().finest_px() > 0;
  resolveRefinement(stream);
  shareSettings(stream);
  return stream;
}

void fitTo(const Scene& scene, ResolvedStream& stream) {
  fitObjects(scene, stream);
  if (!stream.chooses_method && !EmitterStrengths(scene).areSteady())
    takeMethod(defaultMethod(false), stream);
  stream.feed.camera = fitView(scene, *stream.request.mutable_view(), viewField(0));
  for (std::size_t i = 0; i < stream.further.size(); ++i) {
    v1::View& view = *stream.request.mutable_further_views(static_cast<int>(i));
    stream.further[i].camera = fitView(scene, view, viewField(i + 1));
  }
  const SceneFeatures present = featuresOf(scene);
  std::erase_if(stream.disabled_features, [&](SceneFeature feature) { return !present.contains(feature); });
  setDisabledFeatures(stream.disabled_features, *stream.request.mutable_quality());
}

std::string ResolvedStream::feedKey() const {
  return keyOf(feedPart(request));
}

std::string ResolvedStream::feedKeyOfAnySpeed() const {
  v1::OpenStream part = feedPart(request);
  clearSpeeds(part);
  return keyOf(part);
}

std::string ResolvedStream::costKey() const {
  v1::OpenStream part = request;
  part.clear_delivery();
  clearSpeeds(part);
  return keyOf(part);
}

}  // namespace saccade
