#pragma once

#include <insonate/igtlink/LinkCommand.h>
#include <insonate/igtlink/LinkServer.h>
#include <insonate/simulator/LiveImaging.h>

#include <memory>

namespace insonate {

/// Returns the messages of a live image for LinkServer, under the names that PLUS uses ("Definition of commonly used
/// coordinate systems" in its manual). Reference is the patient space in RAS directions, mm.
///
/// - Image_Reference: the image, whose columns go toward the probe's marker and whose rows go into the body
/// - ImageToReference: pixels (column, row, 0) of the image
/// - ProbeToReference: the probe frame
/// - NeedleToReference, StylusTipToReference: the needle with its tip at the origin, z along the insertion, and the
///   bevel along -y; only while there is a needle
///
/// The frame refers to the pixels of `image`, without a copy. Its time is the present time.
std::shared_ptr<const LinkFrame> linkFrameOf(std::shared_ptr<const LiveFrame> image);

/// Settings that commands of other programs read and change.
struct LinkedSettings {
  ImagingSettings settings;
  bool frozen = false;
};

/// Performs a command of PLUS, SetUsParameter or GetUsParameter, on the settings of a probe. Parameters: DepthMm,
/// FrequencyMhz, GainPercent (0 to 100 for -40 to 40 dB), DynRangeDb as in PLUS; FocusMm, GainDb and Freeze (TRUE or
/// FALSE) in addition. Each parameter that is known and within the probe's range is set; the reply names the others
/// with the reason.
LinkReply performCommand(const LinkCommand& command, const Probe& probe, LinkedSettings& settings);

}  // namespace insonate
