// An XML scene file whose includes, $names and ids are resolved. Its errors name file and line.
#pragma once

#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <string>

#include "scene/files/file_loads.h"
#include "scene/files/load_options.h"
#include "scene/files/scene_error.h"
#include "scene/mitsuba/xml_names.h"
#include "scene/mitsuba/xml_text.h"

namespace saccade {

class XmlFile {
 public:
  // `text` is the content of the file at `path`; other files may be included in it. Throws SceneError on
  // faulty XML, a root other than <scene>, an undefined $name, and anything beyond limits.h.
  XmlFile(std::string text, const std::string& path, const LoadOptions& options);

  pugi::xml_node root() const { return document_.document_element(); }
  bool isMitsuba0() const;  // written for 0.4 to 0.6, whose defaults differ here and there
  SceneError error(pugi::xml_node at, const std::string& what) const {
    return text_.error(at.offset_debug(), what);
  }
  FileLoads::Locate errorsAt(pugi::xml_node at) const {
    return [this, at](const std::string& what) { return error(at, what); };
  }

  // The object that a <ref> names; any other node is returned as it is. References may go in circles: a
  // reader that follows them bounds the depth.
  pugi::xml_node resolve(pugi::xml_node node) const;

  // The path of a file that the object `at` names; see findFile(). Throws SceneError.
  std::string locate(pugi::xml_node at, const std::string& filename) const;

 private:
  void substituteNames();
  void addSearchFolder(pugi::xml_node path);
  void indexIds();

  const std::filesystem::path folder_;  // of the scene's file
  LoadOptions options_;                 // with the folders of each <path>
  XmlNames names_;
  XmlText text_;
  pugi::xml_document document_;
  std::map<std::string, pugi::xml_node> ids_;
};

}  // namespace saccade
