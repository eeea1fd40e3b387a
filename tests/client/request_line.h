// The request that options of a command line make.
#pragma once

#include <stdexcept>
#include <string>

#include "client/options/request_options.h"

namespace saccade::client {

inline RequestOptions parse(const std::string& line) {
  CLI::App app;
  RequestOptions options;
  addRequestOptions(app, options);
  app.parse(line);
  return options;
}

inline const std::string kNeeded = "cornell-box --trajectory right ";

inline v1::OpenStream openStream(const std::string& line) {
  return makeOpenStream(parse(kNeeded + line));
}

inline std::string faultOf(const std::string& line) {
  try {
    openStream(line);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  } catch (const CLI::ParseError& fault) {
    return fault.what();
  }
  return {};
}

}  // namespace saccade::client
