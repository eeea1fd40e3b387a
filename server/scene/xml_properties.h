// The properties of one object of a scene file: its children, by tag and name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "scene/xml_file.h"

namespace saccade {

// Each getter takes a property; finish() then throws for any that nobody took, listing those that exist. All
// throw SceneError naming the line of a property that is malformed.
class Properties {
 public:
  Properties(const XmlFile& file, pugi::xml_node object);

  double number(const std::string& name, double fallback);       // <float> or <integer>, finite
  bool flag(const std::string& name, bool fallback);             // <boolean>
  std::string text(const std::string& name);                     // <string>; empty if absent
  Vec3d point(const std::string& name);                          // <point>; the origin if absent
  std::optional<Rgb> color(const std::string& name, float max);  // <rgb> or <float>, each value in [0, max]

  // The objects with this tag and name, seen through <ref>. Unnamed objects have an empty name.
  std::vector<pugi::xml_node> objects(const std::string& tag, const std::string& name = {});
  // At most one of them; null if absent.
  pugi::xml_node object(const std::string& tag, const std::string& name = {});
  void readPast(const std::string& tag, const std::string& name);

  void finish();

 private:
  struct Child {
    pugi::xml_node given, seen;  // as written; what a <ref> stands for
    bool taken = false;
  };
  Child* take(const std::string& tag, const std::string& name);
  double parsed(pugi::xml_node node) const;

  const XmlFile& file_;
  pugi::xml_node object_;
  std::vector<Child> children_;
  std::vector<std::string> known_;
};

// The `type` of an object. Throws SceneError listing `supported` if it is none of them.
std::string supportedType(const XmlFile& file, pugi::xml_node object,
                          const std::vector<std::string>& supported);

// Numbers parted by blanks or commas. Throws SceneError if one is not a finite number.
std::vector<double> parseNumbers(const XmlFile& file, pugi::xml_node node, const std::string& text);

}  // namespace saccade
