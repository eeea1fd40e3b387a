#include "scene/xml_properties.h"

#include <algorithm>
#include <cmath>

#include "scene/text.h"

namespace saccade {
namespace {

std::string titled(const std::string& tag, const std::string& name) {
  return "<" + tag + (name.empty() ? ">" : " name=\"" + name + "\">");
}

std::string nameOf(pugi::xml_node node) {
  return node.attribute("name").value();
}

}  // namespace

Properties::Properties(const XmlFile& file, pugi::xml_node object) : file_(file), object_(object) {
  for (pugi::xml_node child : object.children())
    if (child.type() == pugi::node_element) children_.push_back({child, file.resolve(child)});
}

Properties::Child* Properties::take(const std::string& tag, const std::string& name) {
  const std::string known = titled(tag, name);
  if (std::find(known_.begin(), known_.end(), known) == known_.end()) known_.push_back(known);
  for (Child& child : children_) {
    if (child.taken || child.seen.name() != tag || nameOf(child.given) != name) continue;
    child.taken = true;
    return &child;
  }
  return nullptr;
}

double Properties::parsed(pugi::xml_node node) const {
  const auto values = parseNumbers(file_, node, node.attribute("value").value());
  if (values.size() != 1) throw file_.error(node, "expected value=\"<number>\"");
  return values[0];
}

double Properties::number(const std::string& name, double fallback) {
  for (const char* tag : {"float", "integer"})
    if (const Child* child = take(tag, name)) return parsed(child->given);
  return fallback;
}

bool Properties::flag(const std::string& name, bool fallback) {
  const Child* child = take("boolean", name);
  if (!child) return fallback;
  const std::string value = child->given.attribute("value").value();
  if (value != "true" && value != "false")
    throw file_.error(child->given, "expected value=\"true\" or \"false\"");
  return value == "true";
}

std::string Properties::text(const std::string& name) {
  const Child* child = take("string", name);
  return child ? child->given.attribute("value").value() : "";
}

Vec3d Properties::point(const std::string& name) {
  const Child* child = take("point", name);
  if (!child) return {};
  const pugi::xml_node node = child->given;
  std::string text = node.attribute("value").value();
  if (text.empty())
    for (const char* axis : {"x", "y", "z"}) text += std::string(node.attribute(axis).value()) + " ";
  const auto values = parseNumbers(file_, node, text);
  if (values.size() != 3) throw file_.error(node, "expected x, y and z");
  return {values[0], values[1], values[2]};
}

std::optional<Rgb> Properties::color(const std::string& name, float max) {
  for (const char* tag : {"rgb", "float"}) {
    const Child* child = take(tag, name);
    if (!child) continue;
    const auto values = parseNumbers(file_, child->given, child->given.attribute("value").value());
    if (values.size() != 1 && values.size() != 3)
      throw file_.error(child->given, "expected one or three numbers");
    for (const double v : values)
      if (!(v >= 0 && v <= max))
        throw file_.error(child->given, "'" + name + "' must be at least 0" +
                                            (max == 1 ? " and at most 1" : " and finite"));
    const auto c = [&](std::size_t i) { return static_cast<float>(values[values.size() == 3 ? i : 0]); };
    return Rgb{c(0), c(1), c(2)};
  }
  return {};
}

std::vector<pugi::xml_node> Properties::objects(const std::string& tag, const std::string& name) {
  std::vector<pugi::xml_node> found;
  while (const Child* child = take(tag, name)) found.push_back(child->seen);
  return found;
}

pugi::xml_node Properties::object(const std::string& tag, const std::string& name) {
  const Child* first = take(tag, name);
  const Child* second = take(tag, name);
  if (second) throw file_.error(second->given, "a second " + titled(tag, name) + "; one is supported");
  return first ? first->seen : pugi::xml_node{};
}

void Properties::readPast(const std::string& tag, const std::string& name) {
  while (take(tag, name)) {
  }
}

void Properties::finish() {
  for (const Child& child : children_)
    if (!child.taken)
      throw file_.error(child.given, titled(child.seen.name(), nameOf(child.given)) +
                                         " is not supported in <" + object_.name() + " type=\"" +
                                         object_.attribute("type").value() +
                                         "\">, or is there twice; supported: " + joinNames(known_));
}

std::string supportedType(const XmlFile& file, pugi::xml_node object,
                          const std::vector<std::string>& supported) {
  const std::string type = object.attribute("type").value();
  if (std::find(supported.begin(), supported.end(), type) == supported.end())
    throw file.error(object, "the " + std::string(object.name()) + " type '" + type +
                                 "' is not supported; supported: " + joinNames(supported));
  return type;
}

std::vector<double> parseNumbers(const XmlFile& file, pugi::xml_node node, const std::string& text) {
  std::vector<double> values;
  std::string_view rest = text;
  for (auto word = takeWord(rest, ","); !word.empty(); word = takeWord(rest, ",")) {
    const auto number = parseNumber(word);
    if (!number) throw file.error(node, "'" + std::string(word) + "' is not a finite number");
    values.push_back(*number);
  }
  return values;
}

}  // namespace saccade
