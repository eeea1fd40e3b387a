#include "client/formats/common/truth_group.h"

#include "saccade/stream_views.h"

namespace saccade::client {

std::string truthGroup(const v1::Recording& about, int channel) {
  const std::uint32_t view = viewOfTruth(about, channel);
  return (view == 0 ? "" : "view_" + std::to_string(view) + "/") + "truth/" + nameInView(about, channel);
}

}  // namespace saccade::client
