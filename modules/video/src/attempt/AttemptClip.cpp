#include "attempt/ReplayCursor.h"
#include "attempt/ReplayImages.h"

#include <insonate/cases/DicomSegmentation.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/video/AttemptClip.h>
#include <insonate/video/ClipScale.h>

#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

namespace insonate {
namespace {

/// Replays a recording and renders its images at a constant rate.
class AttemptFilm {
 public:
  AttemptFilm(std::shared_ptr<const AttemptRecording> recording, Procedure procedure, AttemptImages pictures,
              int framesPerSecond)
      : replay_(std::move(recording), std::move(procedure)), images_(std::move(pictures)), rate_(framesPerSecond) {}

  std::int64_t time_us(std::size_t index) const { return std::int64_t(index) * 1'000'000 / rate_; }

  /// Returns the image of a frame. Indices must not decrease.
  Result<const LiveFrame*> at(std::size_t index) {
    if (auto played = replay_.advance(time_us(index)); !played) return tl::unexpected(played.error());
    return images_.at(time_us(index), replay_.sample());
  }

 private:
  video::ReplayCursor replay_;
  video::ReplayImages images_;
  int rate_;
};

/// Tells whether any image of the recording has color Doppler.
bool usesColor(const AttemptRecording& recording) {
  const auto hasColor = [](const std::string& text) {
    const auto settings = parseAttemptSettings(text);
    return settings && settings->setup.color;
  };
  return hasColor(recording.header().settings) ||
         std::ranges::any_of(recording.settingsChanges(), hasColor, &SettingsChange::settings);
}

/// Pixels of an image, gray in one channel, or with color Doppler in three.
void copyPixels(const LiveFrame& frame, int channels, std::vector<std::uint8_t>& pixels) {
  if (channels == 1) {
    pixels = frame.image.gray;
    return;
  }
  for (std::size_t i = 0; i < frame.image.gray.size(); ++i)
    std::fill_n(pixels.begin() + std::ptrdiff_t(3 * i), 3, frame.image.gray[i]);
  const ColorImage& color = frame.color;
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      const std::uint8_t* const rgba = color.rgba.data() + 4 * (std::size_t(y) * color.width + x);
      const std::size_t pixel = std::size_t(color.row + y) * frame.image.width + color.column + x;
      if (rgba[3] > 0) std::copy_n(rgba, 3, pixels.begin() + std::ptrdiff_t(3 * pixel));
    }
}

Result<void> copyImage(const LiveFrame& frame, const BModeImage& first, int channels, std::int64_t time_us,
                       std::vector<std::uint8_t>& pixels) {
  if (hasSameGrid(frame.image, first)) {
    copyPixels(frame, channels, pixels);
    return {};
  }
  char time[32];
  std::snprintf(time, sizeof time, "%.1f", double(time_us) * 1e-6);
  return fail("After " + std::string(time) +
              " s of the attempt, the image has another depth or size, and a DICOM clip has one scale. Write a video "
              "(.webm) instead.");
}

/// Header of the clip; `first`: its first image.
DicomClip clipOf(const AttemptRecording& recording, const PatientCase& patient, const BModeImage& first, int rate) {
  const AttemptHeader& header = recording.header();
  DicomClip clip{.identity = dicomIdentityOf(patient)};
  clip.identity.description = header.procedure;
  clip.seed = "attempt/" + header.recordedFor.attempt + "/" + header.begun + "/" + header.settingsHash + "/" +
              std::to_string(recording.end_us()) + "/" + std::to_string(rate);
  clip.width = first.width, clip.height = first.height;
  clip.region = regionOf(first);
  const std::int64_t count = recording.end_us() * rate / 1'000'000 + 1;
  for (std::int64_t i = 0; i < count; ++i) clip.time_s.push_back(double(i) / rate);
  return clip;
}

Result<void> writeImages(const std::shared_ptr<const AttemptRecording>& recording,
                         const std::shared_ptr<const PatientCase>& patient, const std::filesystem::path& target,
                         const AttemptVideoOptions& options, const Progress& progress) {
  if (recording->segmentCount() == 0) return fail("The recording has no samples, so that there are no images of it.");
  auto procedure = builtInProcedure(recording->header().procedure);
  if (!procedure) return tl::unexpected(procedure.error());
  auto pictures = AttemptImages::make(recording, patient, true);
  if (!pictures) return tl::unexpected(pictures.error());
  AttemptFilm film(recording, std::move(*procedure), std::move(*pictures), options.framesPerSecond);
  // The first image gives the scale, which stands before the pixels.
  BModeImage first;
  std::size_t dark = 0;
  for (; film.time_us(dark) <= recording->end_us(); ++dark) {
    const auto image = film.at(dark);
    if (!image) return tl::unexpected(image.error());
    if (!*image) continue;
    first = (*image)->image;
    break;
  }
  if (first.gray.empty()) return fail("No probe is held during the attempt, so that there are no images of it.");
  DicomClip clip = clipOf(*recording, *patient, first, options.framesPerSecond);
  clip.channels = usesColor(*recording) ? 3 : 1;
  const auto draw = [&](std::size_t index, std::vector<std::uint8_t>& pixels) -> Result<void> {
    pixels.assign(first.gray.size() * clip.channels, 0);
    if (index < dark) return {};
    const auto image = film.at(index);
    if (!image) return tl::unexpected(image.error());
    return *image ? copyImage(**image, first, clip.channels, film.time_us(index), pixels) : Result<void>{};
  };
  return writeDicomClip(clip, target, draw, progress);
}

}  // namespace

Result<void> writeAttemptClip(std::shared_ptr<const AttemptRecording> recording,
                              std::shared_ptr<const PatientCase> patient, const std::filesystem::path& target,
                              const AttemptVideoOptions& options, const Progress& progress) {
  tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
  return arena.execute([&] { return writeImages(recording, patient, target, options, progress); });
}

}  // namespace insonate
