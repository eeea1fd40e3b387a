// A stream whose client sends the frames: there is no scene, no camera and nothing to render.
#include "app/request/refusal.h"
#include "app/request/resolve.h"
#include "app/request/resolve_parts.h"
#include "app/request/resolve_view.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

void checkUnset(bool set, const char* field) {
  if (set) refuse(field, "leave it unset in a stream with `pushed`: its frames come from the client");
}

void checkPushed(const v1::OpenStream& request) {
  checkUnset(!request.scene().empty(), "scene");
  checkUnset(request.has_trajectory(), "trajectory");
  checkUnset(request.has_method(), "method");
  checkUnset(request.has_quality(), "quality");
  checkUnset(request.further_views_size() > 0, "further_views");
  checkUnset(request.objects_size() > 0, "objects");
  checkUnset(!request.animation().empty(), "animation");
  const v1::View& view = request.view();
  checkUnset(view.has_fov_x_deg(), "view.fov_x_deg");
  checkUnset(view.has_intrinsics(), "view.intrinsics");
  checkUnset(view.has_distortion(), "view.distortion");
  checkUnset(view.has_body_camera(), "view.body_camera");
  const v1::Timing& timing = request.timing();
  checkUnset(timing.clock() != v1::CLOCK_UNSPECIFIED && timing.clock() != v1::CLOCK_FAST, "timing.clock");
  checkUnset(timing.steerable(), "timing.steerable");
  checkUnset(timing.interval_px() != 0, "timing.interval_px");
}

void checkObjectIds(const v1::OpenStream& request) {
  for (int i = 0; i < request.sensors_size(); ++i)
    checkUnset(request.sensors(i).object_ids(), ("sensors[" + std::to_string(i) + "].object_ids").c_str());
}

void checkTruth(const v1::OpenStream& request) {
  for (int i = 0; i < request.truth_size(); ++i) {
    const TruthChannelInfo* info = findTruth(request.truth(i).name());
    if (!info || info->needs == TruthChannelInfo::Needs::kIntensity)
      continue;  // resolveTruth() refuses others
    refuse("truth[" + std::to_string(i) + "].name", info->name +
                                                        " needs a scene; a stream with `pushed` has: " +
                                                        truthNamesOf(TruthChannelInfo::Needs::kIntensity));
  }
}

}  // namespace

ResolvedStream resolvePushed(v1::OpenStream request) {
  ResolvedStream stream{.request = std::move(request)};
  v1::OpenStream& r = stream.request;
  checkPushed(r);
  stream.feed.camera = resolveView(r.view(), viewField(0));
  if (r.view().width() * r.view().height() > ranges::kMaxPushedPixels)
    refuse(viewField(0),
           "a view with `pushed` has at most " + std::to_string(ranges::kMaxPushedPixels) + " pixels");
  resolveMounts(stream);
  r.mutable_timing()->set_packet_per_frame(true);
  resolveTiming(stream);
  // The difference of such frames has no noise of rendering.
  for (v1::Sensor& sensor : *r.mutable_sensors()) {
    if (sensor.reconstruction() == v1::RECONSTRUCTION_UNSPECIFIED)
      sensor.set_reconstruction(v1::RECONSTRUCTION_DIRECT);
  }
  resolveSensors(stream);
  checkObjectIds(r);
  checkTruth(r);
  resolveTruths(stream);
  resolveDelivery(r);
  return stream;
}

}  // namespace saccade
