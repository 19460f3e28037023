#include <insonate/teaching/AttemptTrack.h>

namespace insonate {

void addToTrack(std::vector<TrackPoint>& track, const AttemptSample& sample, NeedlePlace place) {
  constexpr std::int64_t kStep_us = 1'000'000 / kTrack_Hz;
  if (!track.empty() && sample.time_us - track.back().time_us < kStep_us) return;
  TrackPoint point{.time_us = sample.time_us,
                   .needleDepth_mm = sample.needleDepth_mm,
                   .tip_mm = {},
                   .tip_probe = {},
                   .probeForce_N = sample.probeForce_N,
                   .place = place,
                   .probeOnSkin = sample.patientFromProbe && sample.probeForce_N > 0,
                   .aspirating = sample.aspirating};
  if (sample.patientFromNeedle) point.tip_mm = sample.patientFromNeedle->offset;
  if (point.tip_mm && sample.patientFromProbe) point.tip_probe = inverted(*sample.patientFromProbe) * *point.tip_mm;
  track.push_back(point);
}

}  // namespace insonate
