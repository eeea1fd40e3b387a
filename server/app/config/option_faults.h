// Why the value of an option cannot be; empty where it can.
#pragma once

#include <string>

namespace saccade {

std::string endpointFault(const std::string& text);  // of ZeroMQ
std::string httpFault(const std::string& text);
std::string foldersFault(const std::string& list);       // "FOLDER:FOLDER", of folders that are there
std::string instructionsFault(const std::string& name);  // that this processor has not; any set that there is

}  // namespace saccade
