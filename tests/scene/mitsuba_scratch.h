// Small Mitsuba files for the tests of their reader.
#pragma once

#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/scratch.h"

namespace saccade {

// A scene of `body` after a sensor; line 3 is where `body` begins. `files` holds what it names.
inline Scene loadBody(const Scratch& files, const std::string& body, const std::string& version = "3.0.0",
                      const LoadOptions& options = {}) {
  const std::string sensor = "<sensor type='perspective'><float name='fov' value='40'/></sensor>";
  return loadMitsubaXml(
      files.write("scene.xml", "<scene version='" + version + "'>\n" + sensor + "\n" + body + "\n</scene>\n"),
      options);
}

// The error of such a scene.
inline std::string errorOfBody(const std::string& body) {
  const Scratch files;
  return errorOf([&] { loadBody(files, body); });
}

}  // namespace saccade
