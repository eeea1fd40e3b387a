#include <algorithm>

#include "events/event_model.h"
#include "events/models/models.h"

namespace saccade {

const std::vector<EventModelInfo>& eventModelTable() {
  static const std::vector<EventModelInfo> table = {
      {"accumulating", "sums the brightness change; every pixel starts at a random phase [E (22)]",
       makeAccumulating},
      {"probabilistic", "draws a fresh threshold phase for every pixel and frame; keeps no level",
       makeProbabilistic},
  };
  return table;
}

const EventModelInfo* findEventModel(const std::string& name) {
  const auto& table = eventModelTable();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.name == name; });
  return found == table.end() ? nullptr : &*found;
}

std::string eventModelNames() {
  std::string names;
  for (const auto& row : eventModelTable()) names += (names.empty() ? "" : ", ") + row.name;
  return names;
}

}  // namespace saccade
