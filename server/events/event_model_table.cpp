#include "base/names.h"
#include "events/event_model.h"
#include "events/models/models.h"

namespace saccade {

const std::vector<EventModelInfo>& eventModelTable() {
  static const std::vector<EventModelInfo> table = {
      {"accumulating", "sums the brightness change; every pixel starts at a random phase [E (22)]",
       makeAccumulating},
      {"probabilistic", "draws a fresh threshold phase for every pixel and frame; keeps no level",
       makeProbabilistic},
      {"stochastic", "accumulating, with a Brownian motion of the level, noise.brownian_hz", makeStochastic},
  };
  return table;
}

const EventModelInfo* findEventModel(const std::string& name) {
  return findRow(eventModelTable(), name);
}

std::string eventModelNames() {
  return joinRowNames(eventModelTable());
}

}  // namespace saccade
