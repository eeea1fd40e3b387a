// An XML scene file with its $names filled in, its ids known, and faults that name their line.
#pragma once

#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "scene/files/load_options.h"
#include "scene/files/scene_error.h"

namespace saccade {

class XmlFile {
 public:
  // `text` is what the file at `path` holds. Throws SceneError: faulty XML, a root that is not <scene>, a
  // $name that is not defined, what is beyond limits.h.
  XmlFile(std::string text, const std::string& path, const LoadOptions& options);

  pugi::xml_node root() const { return document_.document_element(); }
  bool isMitsuba0() const;  // written for 0.4 to 0.6, whose defaults differ here and there
  SceneError error(pugi::xml_node at, const std::string& what) const;

  // The object that a <ref> names; other nodes are what they are. An object must stand before its <ref>, so
  // that references cannot go in circles.
  pugi::xml_node resolve(pugi::xml_node node) const;

  // The path of a file that the object `at` names, relative to the folder of the scene file. Throws
  // SceneError: no name, or a file that the scene may not read.
  std::string locate(pugi::xml_node at, const std::string& filename) const;

 private:
  long lineAt(std::ptrdiff_t offset) const;
  void substituteNames(std::map<std::string, std::string> definitions);
  std::string substituted(pugi::xml_node node, const std::string& text,
                          const std::map<std::string, std::string>& definitions);
  void indexIds();

  std::string text_, path_;
  std::vector<std::filesystem::path> confined_to_;
  std::size_t substituted_bytes_ = 0;
  pugi::xml_document document_;
  std::map<std::string, pugi::xml_node> ids_;
};

}  // namespace saccade
