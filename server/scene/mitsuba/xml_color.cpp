#include "scene/mitsuba/xml_color.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

#include "scene/files/srgb.h"
#include "scene/files/text.h"
#include "scene/mitsuba/xml_properties.h"
#include "scene/spectrum.h"

namespace saccade {
namespace {

// "nm:value, ...", in increasing order of the wavelengths.
std::vector<SpectrumSample> parseSpectrum(const XmlFile& file, pugi::xml_node node) {
  std::vector<SpectrumSample> samples;
  std::string_view rest = node.attribute("value").value();
  for (auto word = takeWord(rest, ","); !word.empty(); word = takeWord(rest, ",")) {
    const std::size_t colon = std::min(word.find(':'), word.size());
    const auto wavelength = parseNumber(word.substr(0, colon));
    const auto value = parseNumber(word.substr(std::min(colon + 1, word.size())));
    if (!wavelength || !value || !(*value >= 0) || *value > std::numeric_limits<float>::max())
      throw file.error(node, "'" + std::string(word) + "' is not nm:value, a wavelength and a number from 0");
    if (!samples.empty() && !(samples.back().wavelength < *wavelength))
      throw file.error(node, "the wavelength of '" + std::string(word) + "' is not above the one before it");
    samples.push_back({*wavelength, *value});
  }
  return samples;
}

Rgb colorOf(const std::vector<SpectrumSample>& spectrum, ColorUse use) {
  const bool share = use == ColorUse::kShare;
  const Rgb color = share ? colorUnderDaylight(spectrum) : colorOfLight(spectrum);
  const float most = share ? 1 : std::numeric_limits<float>::max();
  const auto inside = [most](float part) { return std::clamp(part, 0.f, most); };
  return {inside(color.x), inside(color.y), inside(color.z)};
}

// #rrggbb as three numbers in [0, 1].
Vec3d parseHex(const XmlFile& file, pugi::xml_node node, std::string_view text) {
  unsigned bits = 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data() + 1, end, bits, 16);
  if (text.size() != 7 || stop != end || fault != std::errc())
    throw file.error(node, "'" + std::string(text) + "' is not a colour #rrggbb");
  return Vec3d{double(bits >> 16), double(bits >> 8 & 255), double(bits & 255)} / 255.0;
}

Vec3d parseParts(const XmlFile& file, pugi::xml_node node) {
  const std::string text = node.attribute("value").value();
  if (text.starts_with('#')) return parseHex(file, node, text);
  const auto parts = parseNumbers(file, node, text);
  if (parts.size() == 1) return {parts[0], parts[0], parts[0]};
  if (parts.size() != 3) throw file.error(node, "expected one or three numbers");
  return {parts[0], parts[1], parts[2]};
}

}  // namespace

Rgb parseColor(const XmlFile& file, pugi::xml_node node, ColorUse use) {
  const std::string tag = node.name(), text = node.attribute("value").value();
  if (tag == "spectrum" && text.find(':') != text.npos) return colorOf(parseSpectrum(file, node), use);
  const Vec3d parts = parseParts(file, node);
  if (tag != "srgb") return toFloat(parts);
  if (!(std::min({parts.x, parts.y, parts.z}) >= 0 && std::max({parts.x, parts.y, parts.z}) <= 1))
    throw file.error(node, "the parts of an <srgb> must be within [0, 1]");
  return toFloat(Vec3d{linearFromSrgb(parts.x), linearFromSrgb(parts.y), linearFromSrgb(parts.z)});
}

}  // namespace saccade
