// What `saccade record` says at the end, on stdout.
#pragma once

#include <string>
#include <vector>

#include "client/recorder.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

void printFiles(std::vector<std::string> files, const std::string& preview);  // preview: empty for none
void printRates(const Recorder& recorder, double wall_s);
void printLosses(const Losses& losses);  // nothing where nothing was lost
void printStages(const v1::StreamInfo& info);

}  // namespace saccade
