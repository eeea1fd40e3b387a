#include "app/request/enum_names.h"
#include "app/request/refusal.h"
#include "app/request/resolve_parts.h"

namespace saccade {
namespace {

constexpr const char* kNotFromItems =
    "only a LOSSLESS stream of a scene goes on from here, and none that can be steered";

// A feed that LIVE or BROADCAST streams share cannot begin in the middle.
// Nor can a path or frames that are not known yet.
void checkFromItems(const v1::OpenStream& request) {
  const bool repeatable = !request.timing().steerable() && !request.pushed();
  if (request.delivery() == v1::DELIVERY_LOSSLESS && repeatable) return;
  for (int i = 0; i < request.truth_size(); ++i) {
    if (request.truth(i).from_sample() == 0) continue;
    refuse("truth[" + std::to_string(i) + "].from_sample", kNotFromItems);
  }
  for (int i = 0; i < request.sensors_size(); ++i) {
    if (request.sensors(i).from_event() == 0) continue;
    refuse("sensors[" + std::to_string(i) + "].from_event", kNotFromItems);
  }
}

}  // namespace

void resolveDelivery(v1::OpenStream& request) {
  request.set_delivery(resolveEnum("delivery", request.delivery(), v1::DELIVERY_LOSSLESS));
  request.set_codec(resolveEnum("codec", request.codec(), v1::CODEC_NONE));
  checkFromItems(request);
}

}  // namespace saccade
