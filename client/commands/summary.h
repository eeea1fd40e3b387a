// Prints what `saccade record` reports, to `out`.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "client/recording/recorder.h"
#include "saccade/sequence_check.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

// The setting that the server chose for a budget, and its accuracy; nothing without a budget.
void printChoice(std::FILE* out, const v1::StreamOpened& opened);
// The simplification that the server chose for --max-event-change; nothing without it.
void printModel(std::FILE* out, const v1::StreamOpened& opened);
// The objects that move; nothing where all stand.
void printObjects(std::FILE* out, const v1::OpenStream& resolved);
// How fast the picture moves, and how often it is rendered where intervals follow the motion.
void printPixelSpeed(std::FILE* out, const v1::StreamOpened& opened);
// On stderr: the picture moves by more than half a pixel per frame, or in an interval by far more than was
// asked for. Tells the rate that would be enough.
void warnOfFastPicture(const v1::StreamOpened& opened);
void printFiles(std::FILE* out, std::vector<std::string> files,
                const std::string& preview);                               // preview: "" for none
void printRates(std::FILE* out, const Recorder& recorder, double wall_s);  // wall_s: seconds it took
void printTruth(std::FILE* out, const Recorder& recorder);  // samples by channel; nothing without channels
// Events above the sensors' limits, likely artefacts, and those lost in readout; a line for each if any.
void printWithheld(std::FILE* out, const Recorder& recorder, const v1::OpenStream& resolved);
void printLosses(std::FILE* out, const Losses& losses);  // nothing without losses
// CPU time by stage: of a frame, or of a second of the stream where intervals follow the motion.
void printStages(std::FILE* out, const v1::StreamInfo& info, const v1::Timing& timing);

}  // namespace saccade::client
