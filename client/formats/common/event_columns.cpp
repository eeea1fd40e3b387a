#include "client/formats/common/event_columns.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

bool isPixel(std::int64_t value) {
  return value >= 0 && value <= UINT16_MAX;
}

bool isWithin(std::int64_t value, std::int64_t max) {
  return value >= 0 && value <= max;
}

}  // namespace

std::string LabelColumns::alone() const {
  return both() ? "" : source ? "source without artefact" : artefact ? "artefact without source" : "";
}

void EventColumns::toEvents(const std::string& path, std::uint64_t before, Events& events) {
  events.resize(t_us.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    std::int64_t t_ns;
    const auto polarity = polarities_.parse(p[i]);
    if (__builtin_mul_overflow(t_us[i], kNsPerUs, &t_ns) || !isPixel(x[i]) || !isPixel(y[i]) || !polarity)
      fail(path, before, i);
    events[i] = {t_ns, static_cast<std::uint16_t>(x[i]), static_cast<std::uint16_t>(y[i]), *polarity};
  }
  if (!source.empty()) addLabels(path, before, events);
  if (!object.empty()) addObjects(path, before, events);
}

void EventColumns::fail(const std::string& path, std::uint64_t before, std::size_t i) const {
  throw FileFault(path, "event " + std::to_string(before + i + 1) + " has t " + std::to_string(t_us[i]) +
                            " us, x " + std::to_string(x[i]) + ", y " + std::to_string(y[i]) + ", p " +
                            std::to_string(p[i]) + "; t is within 292 years, x and y are 0 to 65535, " +
                            kPolarities);
}

void EventColumns::addLabels(const std::string& path, std::uint64_t before, Events& events) const {
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!isWithin(source[i], kMaxSource) || !isWithin(artefact[i], UINT8_MAX))
      throw FileFault(path, "event " + std::to_string(before + i + 1) + " has source " +
                                std::to_string(source[i]) + ", artefact " + std::to_string(artefact[i]) +
                                "; source is 0 to " + std::to_string(kMaxSource) + ", artefact 0 to 255");
    events[i].source = static_cast<std::uint8_t>(source[i]);
    events[i].artefact = static_cast<std::uint8_t>(artefact[i]);
  }
}

void EventColumns::addObjects(const std::string& path, std::uint64_t before, Events& events) const {
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!isWithin(object[i], kMaxObject))
      throw FileFault(path, "event " + std::to_string(before + i + 1) + " has object " +
                                std::to_string(object[i]) + "; it is 0 to " + std::to_string(kMaxObject));
    events[i].object = static_cast<std::uint32_t>(object[i]);
  }
}

std::uint32_t toSide(const std::string& path, const std::string& name, std::int64_t pixels) {
  if (pixels < 0 || pixels > UINT16_MAX + 1)
    throw FileFault(path, "has " + name + " " + std::to_string(pixels) + "; valid are 1 to 65536");
  return static_cast<std::uint32_t>(pixels);
}

}  // namespace saccade::client
