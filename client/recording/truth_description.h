// The truth channels that are recorded, as a stream and its server describe them.
#pragma once

#include "saccade/v1/control.pb.h"
#include "saccade/v1/events.pb.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::client {

// Fills about.truth with the channels that truthOfSensor() gives to the recording of about.sensor. Those of
// another view have it in their name: "depth_view1". Throws StreamFault for a channel that the server does
// not describe.
void describeTruth(const v1::OpenStream& resolved, const v1::ServerDescription& server, v1::Recording& about);

// Throws StreamFault for a packet with samples that are not as described.
void checkTruthPacket(const v1::RecordedTruth& channel, const v1::PacketHeader& header);

}  // namespace saccade::client
