// What `saccade record` says on stdout.
#pragma once

#include <string>
#include <vector>

#include "client/recorder.h"
#include "client/sequence_check.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

// What the server chose for a budget, and promises; nothing where none was asked.
void printChoice(const v1::StreamOpened& opened);
// The same of needs.
void printModel(const v1::StreamOpened& opened);
void printPixelSpeed(const v1::StreamOpened& opened);
void printFiles(std::vector<std::string> files, const std::string& preview);  // preview: empty for none
void printRates(const Recorder& recorder, double wall_s);
void printLosses(const Losses& losses);  // nothing where nothing was lost
void printStages(const v1::StreamInfo& info);

}  // namespace saccade::client
