#include "client/formats/aedat4/info_node.h"

#include <charconv>
#include <cstdio>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

namespace saccade::client::aedat4 {
namespace {

constexpr const char* kModule = "saccade";
constexpr const char* kTypeKey = "typeIdentifier";
constexpr std::uint32_t kMostPixels = 32768;  // coordinates are of 16 bits with a sign

pugi::xml_node addNode(pugi::xml_node parent, const std::string& name, const std::string& path) {
  pugi::xml_node node = parent.append_child("node");
  node.append_attribute("name") = name.c_str();
  node.append_attribute("path") = path.c_str();
  return node;
}

void addValue(pugi::xml_node node, const char* key, const char* type, const std::string& value) {
  pugi::xml_node attribute = node.append_child("attr");
  attribute.append_attribute("key") = key;
  attribute.append_attribute("type") = type;
  attribute.text() = value.c_str();
}

void addSize(pugi::xml_node info, const ImageSize& size) {
  addValue(info, "sizeX", "int", std::to_string(size.width));
  addValue(info, "sizeY", "int", std::to_string(size.height));
}

void addSource(pugi::xml_node info, std::uint32_t sensor) {
  char source[32];
  std::snprintf(source, sizeof source, "Saccade_%08u", sensor);
  addValue(info, "source", "string", source);
}

// The text begins with <dv>: the reader of the crate `aedat` takes the first child of the document.
std::string textOf(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(text, "    ", pugi::format_indent | pugi::format_no_declaration);
  return text.str();
}

struct Document {
  explicit Document(const std::string& path) : path(path) {
    pugi::xml_node dv = xml.append_child("dv");
    dv.append_attribute("version") = "2.0";
    const std::string id = std::to_string(kStreamId);
    stream = addNode(addNode(dv, "outInfo", path), id, path + id + "/");
    this->path += id + "/info/";
  }
  pugi::xml_node addInfo() { return addNode(stream, "info", path); }

  std::string path;
  pugi::xml_document xml;
  pugi::xml_node stream;
};

const char* valueOf(pugi::xml_node node, const char* key) {
  return node.find_child_by_attribute("attr", "key", key).child_value();
}

ImageSize sizeOf(pugi::xml_node stream) {
  const pugi::xml_node info = stream.find_child_by_attribute("node", "name", "info");
  const auto number = [&](const char* key) -> std::uint32_t {
    const std::string_view text = valueOf(info, key);
    std::uint32_t value = 0;
    if (text.empty()) return value;
    std::from_chars(text.data(), text.data() + text.size(), value);
    if (value == 0 || value > kMostPixels)
      throw std::runtime_error("has the " + std::string(key) + " '" + std::string(text) +
                               "', which is not a number from 1 to 32768");
    return value;
  };
  return {number("sizeX"), number("sizeY")};
}

Stream streamOf(pugi::xml_node node) {
  Stream stream{0, valueOf(node, kTypeKey), sizeOf(node)};
  const std::string_view name = node.attribute("name").value();
  if (std::from_chars(name.data(), name.data() + name.size(), stream.id).ec != std::errc())
    throw std::runtime_error("names a stream '" + std::string(name) + "', which is not a number");
  return stream;
}

}  // namespace

std::string fileInfo(const Camera& camera, Compression compression) {
  Document document("/mainloop/Recorder/outInfo/");
  addValue(document.stream, "compression", "string", nameOf(compression));
  addValue(document.stream, "originalModuleName", "string", kModule);
  addValue(document.stream, "originalOutputName", "string", "events");
  addValue(document.stream, "typeDescription", "string", "Array of events (polarity ON/OFF).");
  addValue(document.stream, kTypeKey, "string", kEventsType);
  pugi::xml_node info = document.addInfo();
  addSize(info, camera.size);
  addSource(info, camera.sensor);
  addValue(info, "tsOffset", "long", "0");
  return textOf(document.xml);
}

std::string networkInfo(const Camera& camera, Compression compression) {
  Document document("/outInfo/");
  addValue(document.stream, kTypeKey, "string", kEventsType);
  addValue(document.stream, "compression", "string", nameOf(compression));
  addValue(document.stream, "originalOutputName", "string", "events");
  addValue(document.stream, "originalModuleName", "string", kModule);
  pugi::xml_node info = document.addInfo();
  addSource(info, camera.sensor);
  addSize(info, camera.size);
  return textOf(document.xml);
}

std::vector<Stream> streamsOf(const std::string& info) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_string(info.c_str());
  if (!parsed) throw std::runtime_error(std::string("is not XML: ") + parsed.description());
  const pugi::xml_node out = document.child("dv").find_child_by_attribute("node", "name", "outInfo");
  if (!out) throw std::runtime_error("has no node outInfo");
  std::vector<Stream> streams;
  for (const pugi::xml_node node : out.children("node")) {
    if (*valueOf(node, kTypeKey) != 0) streams.push_back(streamOf(node));  // jAER adds a node of settings
  }
  return streams;
}

}  // namespace saccade::client::aedat4
