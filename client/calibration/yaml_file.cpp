#include "client/calibration/yaml_file.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <stdexcept>

namespace saccade::client {
namespace {

void addNumbers(const YAML::Node& node, std::vector<double>& numbers) {
  if (node.IsSequence()) {
    for (const YAML::Node& element : node) addNumbers(element, numbers);
  } else {
    numbers.push_back(node.as<double>());
  }
}

}  // namespace

YamlMapping::YamlMapping(const std::string& path, const YAML::Node& node, const std::string& name)
    : path_(path), name_(name), node_(std::make_shared<YAML::Node>(node)) {
  if (!node.IsMap()) throw std::invalid_argument(path + (name.empty() ? "" : ": " + name) + " has no keys");
}

YamlMapping YamlMapping::ofFile(const std::string& path) {
  try {
    return {path, YAML::LoadFile(path)};
  } catch (const YAML::BadFile&) {
    throw std::invalid_argument("'" + path + "' cannot be read");
  } catch (const YAML::Exception& fault) {
    throw std::invalid_argument(path + ":" + std::to_string(fault.mark.line + 1) + ": " + fault.msg);
  }
}

bool YamlMapping::has(const std::string& key) const {
  return (*node_)[key].IsDefined();
}

YAML::Node YamlMapping::at(const std::string& key) const {
  const YAML::Node node = (*node_)[key];
  if (!node.IsDefined()) fail(key, "is missing");
  return node;
}

YamlMapping YamlMapping::mapping(const std::string& key) const {
  return {path_, at(key), key};
}

std::string YamlMapping::text(const std::string& key) const {
  const YAML::Node node = at(key);
  if (!node.IsScalar()) fail(key, "is no text");
  return node.Scalar();
}

double YamlMapping::number(const std::string& key) const {
  return numbers(key, 1)[0];
}

std::vector<double> YamlMapping::numbers(const std::string& key, std::size_t count) const {
  std::vector<double> numbers;
  const YAML::Node node = at(key);
  try {
    addNumbers(node.IsMap() ? node["data"] : node, numbers);
  } catch (const YAML::Exception&) {
    fail(key, "holds what is no number");
  }
  for (const double number : numbers)
    if (!std::isfinite(number)) fail(key, "holds a number that is not finite");
  if (count > 0 && numbers.size() != count)
    fail(key, "has " + std::to_string(numbers.size()) + " numbers; expected " + std::to_string(count));
  return numbers;
}

void YamlMapping::fail(const std::string& key, const std::string& what) const {
  throw std::invalid_argument(path_ + ": " + (name_.empty() ? "" : name_ + ".") + key + " " + what);
}

}  // namespace saccade::client
