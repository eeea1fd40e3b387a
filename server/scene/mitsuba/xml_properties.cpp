#include "scene/mitsuba/xml_properties.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/names.h"
#include "scene/files/text.h"

namespace saccade {
namespace {

std::string titled(const std::string& tag, const std::string& name) {
  return "<" + tag + (name.empty() ? ">" : " name=\"" + name + "\">");
}

// The name in Mitsuba 3: to_world for toWorld, int_ior for intIOR.
std::string snakeCase(const std::string& name) {
  std::string snake;
  bool was_upper = true;
  for (const char c : name) {
    const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (upper && !was_upper) snake += '_';
    snake += upper ? static_cast<char>(std::tolower(static_cast<unsigned char>(c))) : c;
    was_upper = upper;
  }
  return snake;
}

}  // namespace

Properties::Properties(const XmlFile& file, pugi::xml_node object) : file_(file), object_(object) {
  for (pugi::xml_node child : object.children())
    if (child.type() == pugi::node_element)
      children_.push_back({child, file.resolve(child), snakeCase(child.attribute("name").value())});
}

std::vector<Properties::Child*> Properties::takeAll(const std::string& tag, const std::string& name) {
  const std::string known = titled(tag, name);
  if (std::find(known_.begin(), known_.end(), known) == known_.end()) known_.push_back(known);
  std::vector<Child*> found;
  for (Child& child : children_) {
    if (child.taken || child.seen.name() != tag || (!name.empty() && child.name != name)) continue;
    child.taken = true;
    found.push_back(&child);
  }
  return found;
}

Properties::Child* Properties::take(const std::string& tag, const std::string& name) {
  const std::vector<Child*> found = takeAll(tag, name);
  if (found.size() > 1)
    throw file_.error(found[1]->given, "a second " + titled(tag, name) + "; one is supported");
  return found.empty() ? nullptr : found[0];
}

double Properties::parsed(pugi::xml_node node) const {
  const auto values = parseNumbers(file_, node, node.attribute("value").value());
  if (values.size() != 1) throw file_.error(node, "expected value=\"<number>\"");
  return values[0];
}

bool Properties::parsedFlag(pugi::xml_node node) const {
  const std::string value = node.attribute("value").value();
  if (value != "true" && value != "false") throw file_.error(node, "expected value=\"true\" or \"false\"");
  return value == "true";
}

double Properties::number(const std::string& name, double fallback) {
  for (const char* tag : {"float", "integer"})
    if (const Child* child = take(tag, name)) return parsed(child->given);
  return fallback;
}

bool Properties::flag(const std::string& name, bool fallback) {
  const Child* child = take("boolean", name);
  return child ? parsedFlag(child->given) : fallback;
}

std::string Properties::text(const std::string& name) {
  const Child* child = take("string", name);
  return child ? child->given.attribute("value").value() : "";
}

std::optional<Vec3d> Properties::vector(const std::string& name) {
  for (const char* tag : {"point", "vector"}) {
    const Child* child = take(tag, name);
    if (!child) continue;
    const pugi::xml_node node = child->given;
    std::string text = node.attribute("value").value();
    if (text.empty())
      for (const char* axis : {"x", "y", "z"}) text += std::string(node.attribute(axis).value()) + " ";
    const auto values = parseNumbers(file_, node, text);
    if (values.size() != 3) throw file_.error(node, "expected x, y and z");
    return Vec3d{values[0], values[1], values[2]};
  }
  return {};
}

std::optional<Rgb> Properties::color(const std::string& name, ColorUse use, float least, float max) {
  for (const char* tag : {"rgb", "srgb", "spectrum", "float"}) {
    const Child* child = take(tag, name);
    if (!child) continue;
    const Rgb color = parseColor(file_, child->given, use);
    for (const float part : {color.x, color.y, color.z})
      if (!(part >= least && part <= max))
        throw file_.error(child->given, "'" + name + "' must be at least " +
                                            std::to_string(std::lround(least)) +
                                            (max == 1 ? " and at most 1" : ", and not too large"));
    return color;
  }
  return {};
}

void Properties::neutral(const std::string& name, int value) {
  for (const char* tag : {"float", "integer"}) {
    const Child* child = take(tag, name);
    if (child && parsed(child->given) != value)
      throw file_.error(child->given, "'" + name + "' is supported at " + std::to_string(value) + " alone");
  }
}

void Properties::neutral(const std::string& name, bool value) {
  const Child* child = take("boolean", name);
  if (child && parsedFlag(child->given) != value)
    throw file_.error(child->given,
                      "'" + name + "' is supported as " + (value ? "true" : "false") + " alone");
}

std::vector<pugi::xml_node> Properties::objects(const std::string& tag, const std::string& name) {
  std::vector<pugi::xml_node> found;
  for (const Child* child : takeAll(tag, name)) found.push_back(child->seen);
  return found;
}

pugi::xml_node Properties::object(const std::string& tag, const std::string& name) {
  const Child* child = take(tag, name);
  return child ? child->seen : pugi::xml_node{};
}

void Properties::ignore(const std::string& tag, const std::vector<std::string>& names) {
  for (const std::string& name : names) takeAll(tag, name);
}

void Properties::finish() {
  for (const Child& child : children_)
    if (!child.taken)
      throw file_.error(child.given, titled(child.seen.name(), child.name) + " is not supported in <" +
                                         object_.name() + " type=\"" + object_.attribute("type").value() +
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
