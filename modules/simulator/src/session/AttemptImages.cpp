#include "live/ScenesAhead.h"
#include "session/MomentImaging.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/simulator/AttemptImages.h>
#include <insonate/simulator/AttemptOrigin.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace insonate {

struct AttemptImages::State {
  State(std::shared_ptr<const AttemptRecording> of, CaseVolumes its, std::shared_ptr<const SceneSource> scenes)
      : recording(std::move(of)),
        patient(std::move(its)),
        source(std::move(scenes)),
        imaging(*patient.labels, source, *patient.vessels) {}

  Result<const RecordingSegment*> stretchOf(std::size_t index);
  /// The last sample up to this time for which `wanted` is true; none if there is none.
  template <class Wanted>
  Result<std::optional<AttemptSample>> lastSample(std::int64_t time_us, const Wanted& wanted);
  Result<void> useSettingsOf(std::int64_t time_us);
  void workAhead();

  std::shared_ptr<const AttemptRecording> recording;
  CaseVolumes patient;
  std::shared_ptr<const SceneSource> source;
  MomentImaging imaging;
  std::string used;  ///< settings of `imaging`
  std::optional<std::size_t> unpacked;
  RecordingSegment segment;
  std::optional<live::ScenesAhead> ahead;
};

Result<const RecordingSegment*> AttemptImages::State::stretchOf(std::size_t index) {
  if (unpacked == index) return &segment;
  auto made = recording->segment(index);
  if (!made) return tl::unexpected(made.error());
  segment = std::move(*made), unpacked = index;
  return &segment;
}

template <class Wanted>
Result<std::optional<AttemptSample>> AttemptImages::State::lastSample(std::int64_t time_us, const Wanted& wanted) {
  if (recording->segmentCount() == 0) return std::nullopt;
  for (std::size_t i = recording->segmentAt(time_us) + 1; i-- > 0;) {
    const auto part = stretchOf(i);
    if (!part) return tl::unexpected(part.error());
    const auto& samples = (*part)->samples;
    auto after = std::ranges::upper_bound(samples, time_us, {}, &QuantizedSample::time_us);
    while (after != samples.begin())
      if (const AttemptSample sample = dequantize(*--after); wanted(sample)) return sample;
  }
  return std::nullopt;
}

Result<void> AttemptImages::State::useSettingsOf(std::int64_t time_us) {
  auto text = recording->settingsAt(time_us);
  if (!text) return tl::unexpected(text.error());
  if (*text == used) return {};
  auto settings = parseAttemptSettings(*text);
  if (!settings) return tl::unexpected(settings.error());
  if (auto ok = imaging.use(*settings); !ok) return fail("The images cannot be rendered again: " + ok.error().message);
  used = std::move(*text);
  return {};
}

/// Damaged moments are left out, and reported when they are requested.
void AttemptImages::State::workAhead() {
  if (!useSettingsOf(0)) return;
  const live::SceneNeed need = imaging.need();
  std::optional<Region> all;
  for (std::size_t i = 0; i < recording->segmentCount(); ++i) {
    const auto part = stretchOf(i);
    if (!part || (*part)->samples.empty()) continue;
    const AttemptSample sample = dequantize((*part)->samples.front());
    if (!sample.patientFromProbe || need.misses(*sample.patientFromProbe)) continue;
    const Region region = need.at(*sample.patientFromProbe);
    if (!all) all = region;
    for (int axis = 0; axis < 3; ++axis) {
      all->low_mm[axis] = std::min(all->low_mm[axis], region.low_mm[axis]);
      all->high_mm[axis] = std::max(all->high_mm[axis], region.high_mm[axis]);
    }
  }
  if (!all) return;
  ahead.emplace(source);
  ahead->want(*all, need.detail_mm());
}

Result<AttemptImages> AttemptImages::make(std::shared_ptr<const AttemptRecording> recording,
                                          std::shared_ptr<const PatientCase> patient, bool workAhead) {
  const AttemptHeader& header = recording->header();
  if (header.settings.empty()) return fail("The recording has no image settings; its images cannot be rendered again.");
  if (header.caseHash != voxelHashOf(*patient))
    return fail("The recording was made on another case, '" + header.caseName + "', than '" + patient->manifest.title +
                "', or the case was changed since. Open the unchanged case.");
  CaseVolumes volumes(patient, withTissueLabels(patient->manifest.ownLabels, CaseVolumes(patient).labels));
  auto source = makeSceneSource(CaseView(*patient, *volumes.labels));
  if (!source) return tl::unexpected(source.error());
  auto state = std::make_unique<State>(std::move(recording), std::move(volumes), std::move(*source));
  if (workAhead) state->workAhead();
  return AttemptImages(std::move(state));
}

AttemptImages::AttemptImages(std::unique_ptr<State> state) : state_(std::move(state)) {}
AttemptImages::AttemptImages(AttemptImages&&) noexcept = default;
AttemptImages& AttemptImages::operator=(AttemptImages&&) noexcept = default;
AttemptImages::~AttemptImages() = default;

Result<std::shared_ptr<const LiveFrame>> AttemptImages::at(std::int64_t time_us) {
  auto sample = state_->lastSample(time_us, [](const AttemptSample&) { return true; });
  if (sample && *sample && (*sample)->patientFromProbe && !((*sample)->imageDepth_mm > 0))
    sample = state_->lastSample((*sample)->time_us,
                                [](const AttemptSample& s) { return s.patientFromProbe && s.imageDepth_mm > 0; });
  if (!sample) return tl::unexpected(sample.error());
  if (!*sample || !(*sample)->patientFromProbe) return nullptr;
  if (auto ok = state_->useSettingsOf((*sample)->time_us); !ok) return tl::unexpected(ok.error());
  if (!state_->imaging.hasColor()) return state_->imaging.picture(**sample);
  // The motion of the probe over the last image causes the flash of color Doppler.
  constexpr std::int64_t kMotion_us = 50'000;
  const auto before = state_->lastSample((*sample)->time_us - kMotion_us, [](const AttemptSample&) { return true; });
  if (!before) return tl::unexpected(before.error());
  return state_->imaging.picture(**sample, *before ? &**before : nullptr);
}

}  // namespace insonate
