#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/FovFit.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Orientation of an image plane relative to the axis of the neck.
enum class ScanPlane { Transverse, Longitudinal, Oblique };

std::string_view nameOf(ScanPlane plane);
/// Returns the plane with this name: transverse, longitudinal or oblique.
std::optional<ScanPlane> scanPlaneNamed(std::string_view name);

/// Length of a clip, 1 s.
inline constexpr int kClipFrames = 30, kClipFrames_perSecond = 30;

/// An image, or a clip of 1 s, of a field of view, without surrounding text.
struct SourceImage {
  std::string source;  ///< real image: machine or data set; simulated image: neck
  std::string about;   ///< file, or neck, view and settings
  /// The part that is measured, with a resolution of kFeaturePixelsPer_mm and at most 30 mm deep. Linear probe: the
  /// inside of the field of view. Fan: the largest rectangle inside the fan. Clip: this part of the middle frame.
  GrayImage image;
  ProbeShape probe = ProbeShape::Linear;
  std::optional<ScanPlane> plane = std::nullopt;  ///< plane of the image; empty if the list does not state the plane
  /// Frames that the readers of a blind test see, at shownPixelsPer_mm(): one frame for a still of a fan, kClipFrames
  /// for a clip. Empty for a still of a linear probe; its readers see `image`.
  std::vector<GrayImage> frames = {};

  bool isClip() const { return frames.size() > 1; }
  /// Returns the still that the readers of a blind test see; for a clip, its middle frame.
  const GrayImage& shown() const { return frames.empty() ? image : frames[frames.size() / 2]; }
};

/// Returns the resolution of the frames that the readers of a blind test see: kFeaturePixelsPer_mm for linear probes,
/// half of it for fans, which are larger.
double shownPixelsPer_mm(ProbeShape probe);

/// Reads real images and clips. Each line of the list is `file,pixels per mm,source`. If a file shows more than the
/// inside of the field of view, the line also has `,left,top,width,height` of the inside in pixels. Further cells name
/// the probe (`probe=curvilinear`; linear otherwise) and the plane (`plane=longitudinal`). For a curvilinear or phased
/// probe, the fan is found in this box, and everything outside the fan is made black. If `file` is a folder, its images
/// in the order of their names form a clip, whose middle second is read; `fps=25` states the frames per second, which
/// are 30 otherwise. # begins a comment. Paths are relative to the list. Fails, with the line, on a file that cannot be
/// read or measured, and on a list without images.
Result<std::vector<SourceImage>> readRealImages(const std::filesystem::path& list);

}  // namespace insonate
