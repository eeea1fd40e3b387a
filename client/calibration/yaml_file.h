// Values of a YAML file, with errors that name the file and the key.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace YAML {
class Node;
}

namespace saccade::client {

// A mapping of the file. All members throw std::invalid_argument.
class YamlMapping {
 public:
  // `name`: of the mapping, for errors; empty: the whole file.
  YamlMapping(const std::string& path, const YAML::Node& node, const std::string& name = "");
  static YamlMapping ofFile(const std::string& path);

  bool has(const std::string& key) const;
  YamlMapping mapping(const std::string& key) const;
  std::string text(const std::string& key) const;
  double number(const std::string& key) const;
  // A list, a list of lists, or a matrix of OpenCV or ROS with `data`. `count`: how many; 0: any.
  std::vector<double> numbers(const std::string& key, std::size_t count = 0) const;
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

 private:
  YAML::Node at(const std::string& key) const;

  std::string path_, name_;
  std::shared_ptr<const YAML::Node> node_;  // never null
};

}  // namespace saccade::client
