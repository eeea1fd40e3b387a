#include "client/recording/truth_description.h"

#include <algorithm>
#include <string>

#include "saccade/stream_fault.h"
#include "saccade/stream_views.h"
#include "saccade/wire/truth_samples.h"

namespace saccade::client {
namespace {

// Names become those of files.
bool isPlain(const std::string& name) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyz0123456789_";
  return !name.empty() && name.find_first_not_of(kPlain) == std::string::npos;
}

const v1::TruthInfo& infoOf(const std::string& name, const v1::ServerDescription& server) {
  const auto& known = server.truth();
  const auto at =
      std::find_if(known.begin(), known.end(), [&](const auto& row) { return row.name() == name; });
  if (at == known.end() || !isPlain(name) || at->planes_size() == 0 || bytesOf(at->element()) == 0)
    throw StreamFault("the server does not describe its truth channel '" + name + "'");
  return *at;
}

// With _1, _2 for further channels of the same name. `names`: those before, without such numbers.
std::string uniqueName(const std::string& name, std::vector<std::string>& names) {
  const auto before = std::count(names.begin(), names.end(), name);
  names.push_back(name);
  return before == 0 ? name : name + "_" + std::to_string(before);
}

}  // namespace

void describeTruth(const v1::OpenStream& resolved, const v1::ServerDescription& server,
                   v1::Recording& about) {
  const int sensor = static_cast<int>(about.sensor());
  const std::uint32_t own = resolved.sensors(sensor).view();
  std::vector<std::string> names;
  for (const int i : truthOfSensor(resolved, sensor)) {
    const v1::Truth& truth = resolved.truth(i);
    v1::RecordedTruth& channel = *about.add_truth();
    *channel.mutable_info() = infoOf(truth.name(), server);
    channel.set_name(uniqueName(truth.name() + (truth.view() == own ? "" : viewSuffix(truth.view())), names));
    const v1::View& view = viewOf(resolved, truth.view());
    channel.set_width(view.width());
    channel.set_height(view.height());
  }
}

void checkTruthPacket(const v1::RecordedTruth& channel, const v1::PacketHeader& header) {
  const v1::TruthInfo& info = channel.info();
  const bool same_form = header.layout() == info.layout() && header.element() == info.element() &&
                         header.planes() == static_cast<std::uint32_t>(info.planes_size());
  const bool same_size = info.layout() == v1::LAYOUT_ROWS ||
                         (header.width() == channel.width() && header.height() == channel.height());
  if (!same_form || !same_size)
    throw StreamFault("the truth channel '" + channel.name() + "' is not as the server describes it");
}

}  // namespace saccade::client
