#include "client/formats/evt/raw_header.h"

#include <stdexcept>

#include "client/formats/evt/evt_words.h"

namespace saccade::client {

// Decoders choose by these keys, and split lines at blanks: there is none at their ends. The keys that name a
// camera (generation, system_ID) are left out, and so is the date: equal recordings are equal files.
std::string rawHeader(const std::string& evt, const std::string& encoding, const v1::Recording& about) {
  const std::string width = std::to_string(about.width()), height = std::to_string(about.height());
  if (about.width() > kEvtEdge || about.height() > kEvtEdge)
    throw std::invalid_argument(encoding + " holds images of at most 2048x2048 pixels, not " + width + "x" +
                                height);
  std::string header = "% camera_integrator_name Prophesee\n% evt " + evt + "\n% format " + encoding +
                       ";height=" + height + ";width=" + width + "\n% geometry " + width + "x" + height +
                       "\n% integrator_name Prophesee\n% plugin_integrator_name Prophesee\n"
                       "% plugin_name hal_plugin_prophesee\n";
  // A converted file of another program may be of a real camera.
  if (about.has_request()) header += "% serial_number simulated\n% simulator Saccade\n";
  return header + "% end\n";
}

}  // namespace saccade::client
