#include "ClipExport.h"

#include "PictureExport.h"
#include "ScaledPicture.h"

#include <insonate/cases/DicomClip.h>
#include <insonate/cases/DicomSegmentation.h>
#include <insonate/video/ClipScale.h>
#include <insonate/video/ClipVideo.h>

#include <QImage>
#include <QPoint>
#include <algorithm>
#include <cstdint>

namespace insonate::train {
namespace {

void copyPixels(const QImage& picture, std::vector<std::uint8_t>& pixels) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  const auto row = std::size_t(rgb.width()) * 3;
  pixels.resize(row * std::size_t(rgb.height()));
  for (int y = 0; y < rgb.height(); ++y)
    std::copy_n(rgb.constScanLine(y), row, pixels.begin() + std::ptrdiff_t(row) * y);
}

Result<int> writeAsVideo(const SavedClip& clip, const std::filesystem::path& file, const Progress& progress) {
  ClipVideo video;
  for (const auto& frame : clip.frames) {
    const QSize size = scaledPictureSize(frame->image, clip.calipers.size());
    video.width = std::max(video.width, size.width()), video.height = std::max(video.height, size.height());
    video.time_s.push_back(frame->time_s);
  }
  const auto draw = [&](std::size_t index, VideoFrame& into) -> Result<void> {
    const QImage picture = scaledPicture(*clip.frames[index], clip.calipers);
    into.width = picture.width(), into.height = picture.height(), into.channels = 3;
    copyPixels(picture, into.pixels);
    return {};
  };
  if (auto written = writeClipVideo(video, file, draw, progress); !written) return tl::unexpected(written.error());
  return int(clip.frames.size());
}

/// Index of the first image after the last change of the scale.
std::size_t beginOfScale(const SavedClip& clip) {
  const BModeImage& last = clip.frames.back()->image;
  std::size_t first = clip.frames.size() - 1;
  while (first > 0 && hasSameGrid(clip.frames[first - 1]->image, last)) --first;
  return first;
}

Result<int> writeAsDicom(const SavedClip& clip, const std::filesystem::path& file, const Progress& progress) {
  const std::size_t first = beginOfScale(clip);
  const BModeImage& image = clip.frames[first]->image;
  const bool isMeasured = !clip.calipers.empty();
  const QSize size = isMeasured ? scaledPictureSize(image, clip.calipers.size()) : QSize(image.width, image.height);
  const QPoint origin = isMeasured ? pictureOrigin(image) : QPoint(0, 0);
  DicomClip head;
  head.identity = dicomIdentityOf(*clip.patient);
  head.identity.description = clip.frames[first]->setup->probe.name;
  head.seed = clip.seed;
  head.width = size.width(), head.height = size.height(), head.channels = isMeasured ? 3 : 1;
  head.region = regionOf(image, origin.x(), origin.y());
  for (std::size_t i = first; i < clip.frames.size(); ++i) head.time_s.push_back(clip.frames[i]->time_s);
  const auto draw = [&](std::size_t index, std::vector<std::uint8_t>& pixels) -> Result<void> {
    const LiveFrame& shown = *clip.frames[first + index];
    if (isMeasured)
      copyPixels(scaledPicture(shown, clip.calipers), pixels);
    else
      pixels = shown.image.gray;
    return {};
  };
  if (auto written = writeDicomClip(head, file, draw, progress); !written) return tl::unexpected(written.error());
  return int(head.time_s.size());
}

}  // namespace

ClipFormat clipFormatOf(const std::filesystem::path& target) {
  if (target.extension() == ".webm") return ClipFormat::Video;
  return target.extension() == ".dcm" ? ClipFormat::Dicom : ClipFormat::Images;
}

Result<int> writeClip(const SavedClip& clip, const std::filesystem::path& target, const Progress& progress) {
  switch (clipFormatOf(target)) {
    case ClipFormat::Video:
      return writeAsVideo(clip, target, progress);
    case ClipFormat::Dicom:
      return writeAsDicom(clip, target, progress);
    default:
      return writeImages(clip.frames, clip.calipers, target, progress);
  }
}

}  // namespace insonate::train
