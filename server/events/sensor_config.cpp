#include "events/sensor_config.h"

#include "base/range.h"
#include "events/event_model.h"
#include "events/reconstruction.h"

namespace saccade {

std::optional<SensorFault> findFault(const SensorConfig& config) {
  const struct {
    const char* field;
    double value, min, max;
  } ranges[] = {
      {"threshold", config.threshold, 1e-3, 10},
      {"threshold_off", config.threshold_off, 1e-3, 10},
      {"bias", config.bias, 1e-12, 1e6},
      {"cutoff_hz", config.reconstruction_cutoff_hz, 1e-4, 1e4},
      {"refractory_s", seconds(config.refractory), 0, 10},
      {"max_events_per_pixel_frame", static_cast<double>(config.max_events_per_pixel_frame), 1, 65536},
      {"max_events_per_frame", static_cast<double>(config.max_events_per_frame), 1, 0x1p64},
  };
  for (const auto& [field, value, min, max] : ranges) {
    if (std::string fault = rangeFault(value, min, max); !fault.empty()) return SensorFault{field, fault};
  }
  if (!findEventModel(config.model)) {
    return SensorFault{"model", "no event model '" + config.model + "'; there are: " + eventModelNames()};
  }
  if (!findReconstruction(config.reconstruction)) {
    return SensorFault{"reconstruction", "no reconstruction '" + config.reconstruction +
                                             "'; there are: " + reconstructionNames()};
  }
  return std::nullopt;
}

}  // namespace saccade
