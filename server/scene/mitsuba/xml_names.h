// The $names of a scene file, and what they stand for.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "scene/files/scene_error.h"
#include "scene/mitsuba/scene_values.h"

namespace saccade {

class XmlNames {
 public:
  // The values of `given` come before any <default>.
  explicit XmlNames(SceneValues given) : given_(std::move(given)) {}

  // Takes the value of a <default>. The first value of a name stays.
  void define(const std::string& name, const std::string& value);

  // `text` with each $name replaced. Throws SceneError without a place: an undefined $name, or more than
  // limits.h allows.
  std::string substituted(const std::string& text);

  // Throws SceneError where a value was given that no <default> and no text has named so far.
  void checkGiven() const;

 private:
  const std::string& valueOf(const std::string& name);
  SceneError undefined(const std::string& name) const;

  SceneValues given_;
  std::map<std::string, std::string> defaults_;
  std::set<std::string> named_;
  std::size_t substituted_bytes_ = 0;
};

}  // namespace saccade
