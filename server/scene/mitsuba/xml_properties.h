// The properties of one object of a scene file: its children, by tag and name.
//
// Names are those of Mitsuba 3. A file may spell them as Mitsuba 0.5 and 0.6 do (toWorld, intIOR): both are
// read as to_world, int_ior.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "scene/mitsuba/xml_color.h"

namespace saccade {

// Each getter takes a property; finish() then throws for any that nobody took, listing those that exist. All
// throw SceneError naming the line of a property that is malformed.
class Properties {
 public:
  Properties(const XmlFile& file, pugi::xml_node object);

  double number(const std::string& name, double fallback);  // <float> or <integer>, finite
  bool flag(const std::string& name, bool fallback);        // <boolean>
  std::string text(const std::string& name);                // <string>; empty if absent
  std::optional<Vec3d> vector(const std::string& name);     // <point> or <vector>, finite
  // Colours, see xml_color.h: a share of light, each part in [0, max], or a quantity, each part in [least,
  // max].
  std::optional<Rgb> share(const std::string& name, float max = 1) {
    return color(name, ColorUse::kShare, 0, max);
  }
  std::optional<Rgb> quantity(const std::string& name, float max, float least = 0) {
    return color(name, ColorUse::kQuantity, least, max);
  }

  // The objects with this tag and name, or of any name if it is empty, seen through <ref>.
  std::vector<pugi::xml_node> objects(const std::string& tag, const std::string& name = {});
  // At most one of them; null if absent.
  pugi::xml_node object(const std::string& tag, const std::string& name = {});
  // Takes a property that may be given if it has this value, which changes nothing.
  void neutral(const std::string& name, int value);
  void neutral(const std::string& name, bool value);
  // Takes properties that are not used here; without names, all with this tag.
  void ignore(const std::string& tag, const std::vector<std::string>& names = {{}});

  void finish();

 private:
  struct Child {
    pugi::xml_node given, seen;  // as written; what a <ref> stands for
    std::string name;            // as in Mitsuba 3
    bool taken = false;
  };
  std::vector<Child*> takeAll(const std::string& tag, const std::string& name);
  Child* take(const std::string& tag, const std::string& name);  // at most one; nullptr if absent
  double parsed(pugi::xml_node node) const;
  bool parsedFlag(pugi::xml_node node) const;
  std::optional<Rgb> color(const std::string& name, ColorUse use, float least, float max);

  const XmlFile& file_;
  pugi::xml_node object_;
  std::vector<Child> children_;
  std::vector<std::string> known_;
};

// The `type` of an object. Throws SceneError listing `supported` if it is none of them.
std::string supportedType(const XmlFile& file, pugi::xml_node object,
                          const std::vector<std::string>& supported);

// Numbers separated by blanks or commas. Throws SceneError if one is not a finite number.
std::vector<double> parseNumbers(const XmlFile& file, pugi::xml_node node, const std::string& text);

}  // namespace saccade
