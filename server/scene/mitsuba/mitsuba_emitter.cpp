#include "scene/mitsuba/mitsuba_emitter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/files/limits.h"
#include "scene/files/text.h"
#include "scene/mitsuba/xml_properties.h"

namespace saccade {
namespace {

constexpr double kMaxSeconds = 9e9;  // what whole nanoseconds can count
constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr float kMaxFactor = 1e18f;  // times kMaxRadiance it is finite

TimeNs toTime(double seconds) {
  return TimeNs{std::llround(seconds * 1e9)};
}

// `word` is "seconds:factor".
StrengthKey parseKey(const XmlFile& file, pugi::xml_node at, std::string_view word) {
  const std::string_view before = word.substr(0, word.find(':'));
  const std::string_view after = word.substr(std::min(before.size() + 1, word.size()));
  const auto time = parseNumber(before), factor = parseNumber(after);
  const std::string key = "the key '" + std::string(word) + "'";
  if (!time || !factor) throw file.error(at, key + " is not seconds:factor, two finite numbers");
  if (!(*time >= 0 && *time <= kMaxSeconds)) throw file.error(at, key + " has a time outside of [0, 9e9] s");
  if (!(*factor >= 0 && *factor <= kMaxFactor))
    throw file.error(at, key + " has a factor below 0 or too large");
  return {toTime(*time), static_cast<float>(*factor)};
}

std::vector<StrengthKey> parseKeys(const XmlFile& file, pugi::xml_node at) {
  std::vector<StrengthKey> keys;
  std::string_view rest = at.attribute("value").value();
  for (auto word = takeWord(rest, ","); !word.empty(); word = takeWord(rest, ",")) {
    const StrengthKey key = parseKey(file, at, word);
    if (!keys.empty() && key.time < keys.back().time)
      throw file.error(at, "the key '" + std::string(word) + "' is earlier than the one before it");
    keys.push_back(key);
  }
  if (keys.empty()) throw file.error(at, "a strength needs at least one key, seconds:factor");
  return keys;
}

Strength parseStrength(const XmlFile& file, pugi::xml_node emitter, Properties& properties) {
  const pugi::xml_node text = properties.object("string", "strength");
  const double period = properties.number("strength_period", kForever);
  if (!text && period == kForever) return {};
  if (!text) throw file.error(emitter, "a strength_period needs a <string name=\"strength\">");
  std::vector<StrengthKey> keys = parseKeys(file, text);
  if (period == kForever) return Strength(std::move(keys));
  if (!(period <= kMaxSeconds) || toTime(period) <= TimeNs{0} || toTime(period) < keys.back().time)
    throw file.error(emitter, "the strength_period must be 1 ns to 9e9 s, and not before the last key");
  return Strength::periodic(std::move(keys), toTime(period));
}

}  // namespace

Emission parseEmitter(const XmlFile& file, pugi::xml_node emitter, TextureReader& textures) {
  supportedType(file, emitter, {"area"});
  Properties properties(file, emitter);
  properties.ignore("float", {"sampling_weight"});
  Emission emission{.radiance = {1, 1, 1}, .strength = parseStrength(file, emitter, properties)};
  if (const pugi::xml_node texture = properties.object("texture", "radiance"))
    emission.picture = textures.readTexture(texture, TextureReader::Use::kRadiance);
  else
    emission.radiance = properties.quantity("radiance", kMaxRadiance).value_or(emission.radiance);
  properties.finish();
  return emission;
}

bool hasTexture(const XmlFile& file, pugi::xml_node emitter) {
  return emitter && Properties(file, emitter).object("texture", "radiance");
}

}  // namespace saccade
