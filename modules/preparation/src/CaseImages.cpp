#include "CaseImages.h"

#include <insonate/cases/StartPose.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/simulator/ImageFiles.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ultrasound/Probe.h>

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <utility>

namespace insonate::preparation {
namespace {

constexpr int kWidth_px = 320;

using Rgb = std::array<double, 3>;  ///< 0 to 1

/// A color image of square pixels, written as PNG by Cairo.
class RgbImage {
 public:
  RgbImage(int width, int height)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), &cairo_surface_destroy) {
    cairo_surface_flush(surface_.get());
  }
  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }
  void set(int x, int y, const Rgb& color) {
    auto* row = cairo_image_surface_get_data(surface_.get()) +
                std::ptrdiff_t(y) * cairo_image_surface_get_stride(surface_.get());
    std::uint32_t pixel = 0;
    for (const double part : color) pixel = pixel << 8 | std::uint32_t(std::lround(std::clamp(part, 0.0, 1.0) * 255));
    reinterpret_cast<std::uint32_t*>(row)[x] = pixel;
  }
  Result<void> write(const std::filesystem::path& file) const {
    cairo_surface_mark_dirty(surface_.get());
    const cairo_status_t status = cairo_surface_write_to_png(surface_.get(), file.c_str());
    if (status == CAIRO_STATUS_SUCCESS) return {};
    return fail(file.string() + " cannot be written: " + cairo_status_to_string(status) + ".");
  }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
};

/// A plane of the patient: image columns go along `right`, rows along `down`.
struct Plane {
  Vec3 center_mm, right, down;
  double width_mm = 0, height_mm = 0;
};

Rgb colorOf(const CaseView& patient, std::uint8_t label) {
  const LabelColor color = caseLabelColor({}, tissueOf(patient.manifest.ownLabels, label));
  return {color[0] / 255.0, color[1] / 255.0, color[2] / 255.0};
}

/// The soft-tissue window of a CT: center 40, width 400 HU.
double gray(double hounsfield) {
  return std::clamp((hounsfield + 160) / 400, 0.0, 1.0);
}

/// CT in gray, with the edge of each structure except fat and muscle in its color.
RgbImage sliceWithOutlines(const CaseView& patient, const Plane& plane) {
  const double pixel_mm = plane.width_mm / kWidth_px;
  RgbImage image(kWidth_px, std::max(1, int(std::lround(plane.height_mm / pixel_mm))));
  const Transform index = patient.ct.geometry.indexFromPatient();
  const auto place = [&](double x, double y) {
    return index * (plane.center_mm + ((x + 0.5) * pixel_mm - plane.width_mm / 2) * plane.right +
                    ((y + 0.5) * pixel_mm - plane.height_mm / 2) * plane.down);
  };
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const std::uint8_t label = sampleNearest(patient.labels, place(x, y));
      const bool isOutlined = label != kBackground && label != kFat && label != kMuscle && label != kSoftTissue;
      const bool isEdge = isOutlined && (sampleNearest(patient.labels, place(x + 1, y)) != label ||
                                         sampleNearest(patient.labels, place(x, y + 1)) != label ||
                                         sampleNearest(patient.labels, place(x - 1, y)) != label ||
                                         sampleNearest(patient.labels, place(x, y - 1)) != label);
      const double value = gray(sampleLinear(patient.ct, place(x, y)));
      image.set(x, y, isEdge ? colorOf(patient, label) : Rgb{value, value, value});
    }
  return image;
}

Vec3 sizeOf_mm(const VolumeGeometry& g) {
  Vec3 size;
  for (int a = 0; a < 3; ++a)
    for (int axis = 0; axis < 3; ++axis)
      size[axis] = std::max(size[axis], std::abs(g.direction.column[a][axis]) * g.size[a] * g.spacing_mm[a]);
  return size;
}

std::string levelText(double z_mm) {
  char text[64];
  std::snprintf(text, sizeof text, "axial, z = %.0f mm", z_mm);
  return text;
}

/// Brightness of a surface that is lit from the front: the share of its normal toward the viewer, from the depths of
/// the neighboring pixels.
double shade(double left, double right, double up, double down, double pixel_mm) {
  const double slope = std::hypot((right - left) / (2 * pixel_mm), (down - up) / (2 * pixel_mm));
  return 0.25 + 0.75 / std::sqrt(1 + slope * slope);
}

/// Depth along the view, which goes from the patient's front to the back, at which each pixel meets a structure;
/// `far_mm` where it meets none.
struct DepthImage {
  int width = 0, height = 0;
  double far_mm = 0;
  std::vector<double> depth_mm;
  std::vector<std::uint8_t> label;
  double at(int x, int y) const {
    const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
    return depth_mm[std::size_t(row) * std::size_t(width) + std::size_t(column)];
  }
};

template <class IsSeen>
DepthImage depthImage(const CaseView& patient, const Plane& plane, double reach_mm, double step_mm, IsSeen isSeen) {
  const double pixel_mm = plane.width_mm / kWidth_px;
  const Vec3 back = cross(plane.right, plane.down);
  const Transform index = patient.labels.geometry.indexFromPatient();
  DepthImage image{kWidth_px, std::max(1, int(std::lround(plane.height_mm / pixel_mm))), reach_mm, {}, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Vec3 start_mm = plane.center_mm + ((x + 0.5) * pixel_mm - plane.width_mm / 2) * plane.right +
                            ((y + 0.5) * pixel_mm - plane.height_mm / 2) * plane.down - reach_mm / 2 * back;
      double s = 0;
      std::uint8_t label = kBackground;
      for (; s < reach_mm; s += step_mm)
        if (label = sampleNearest(patient.labels, index * (start_mm + s * back)); isSeen(label)) break;
      image.depth_mm.push_back(std::min(s, reach_mm));
      image.label.push_back(s < reach_mm ? label : std::uint8_t(kBackground));
    }
  return image;
}

}  // namespace

Result<std::vector<ReportImage>> writeSlices(const CaseView& patient, const std::filesystem::path& folder) {
  const Vec3 size_mm = sizeOf_mm(patient.ct.geometry), center_mm = patient.ct.geometry.center_mm();
  const Vec3 middle_mm = patient.manifest.targets.empty() ? center_mm : patient.manifest.targets.front().position_mm;
  std::vector<ReportImage> images;
  for (const double offset_mm : {-20.0, 0.0, 20.0}) {
    const double z_mm = middle_mm.z + offset_mm;
    if (std::abs(z_mm - center_mm.z) > size_mm.z / 2) continue;
    const Plane axial{{center_mm.x, center_mm.y, z_mm}, {1, 0, 0}, {0, 1, 0}, size_mm.x, size_mm.y};
    const std::string file = "slice" + std::to_string(images.size() + 1) + ".png";
    if (const auto ok = sliceWithOutlines(patient, axial).write(folder / file); !ok) return tl::unexpected(ok.error());
    images.push_back({file, levelText(z_mm)});
  }
  const Plane coronal{{center_mm.x, middle_mm.y, center_mm.z}, {1, 0, 0}, {0, 0, -1}, size_mm.x, size_mm.z};
  if (const auto ok = sliceWithOutlines(patient, coronal).write(folder / "coronal.png"); !ok)
    return tl::unexpected(ok.error());
  images.push_back({"coronal.png", "coronal"});
  return images;
}

Result<ReportImage> writeFront(const CaseView& patient, const std::filesystem::path& folder) {
  const Vec3 size_mm = sizeOf_mm(patient.ct.geometry);
  const Plane front{patient.ct.geometry.center_mm(), {1, 0, 0}, {0, 0, -1}, size_mm.x, size_mm.z};
  const double pixel_mm = front.width_mm / kWidth_px, step_mm = pixel_mm;
  const DepthImage skin =
      depthImage(patient, front, size_mm.y, step_mm, [](std::uint8_t label) { return label != kBackground; });
  const DepthImage inside = depthImage(patient, front, size_mm.y, step_mm, [&](std::uint8_t label) {
    const auto tissue = tissueOf(patient.manifest.ownLabels, label);
    return tissue == kBone || tissue == kVein || tissue == kArtery || tissue == kAirway;
  });
  RgbImage view(skin.width, skin.height);
  for (int y = 0; y < skin.height; ++y)
    for (int x = 0; x < skin.width; ++x) {
      Rgb color{0.08, 0.09, 0.1};
      const auto blend = [&](const DepthImage& image, const Rgb& tint, double share) {
        if (image.at(x, y) >= image.far_mm) return;
        const double light =
            shade(image.at(x - 1, y), image.at(x + 1, y), image.at(x, y - 1), image.at(x, y + 1), pixel_mm);
        for (int c = 0; c < 3; ++c) color[c] = (1 - share) * color[c] + share * light * tint[c];
      };
      const std::size_t offset = std::size_t(y) * std::size_t(skin.width) + std::size_t(x);
      blend(inside, colorOf(patient, inside.label[offset]), 1);
      blend(skin, {0.85, 0.66, 0.55}, inside.at(x, y) < inside.far_mm ? 0.35 : 0.8);
      view.set(x, y, color);
    }
  if (const auto ok = view.write(folder / "front.png"); !ok) return tl::unexpected(ok.error());
  return ReportImage{"front.png", "from the front"};
}

Result<std::vector<ReportImage>> writeUltrasound(const PatientCase& patient, const std::filesystem::path& folder,
                                                 const Progress& progress) {
  constexpr std::size_t kMost = 4;
  std::vector<StartPose> poses = patient.manifest.startPoses;
  if (poses.empty()) {
    auto found = autoStartPose(patient);
    if (!found) return tl::unexpected(found.error());
    poses.push_back(std::move(*found));
  }
  poses.resize(std::min(poses.size(), kMost));
  auto probe = loadProbe("linear");
  auto tissues = loadAcousticTable("neck");
  if (!probe || !tissues) return tl::unexpected(probe ? tissues.error() : probe.error());
  ImagingSetup setup{*probe, settingsFor(*probe), std::move(*tissues)};
  auto imager = Imager::make(setup);
  if (!imager) return tl::unexpected(imager.error());
  std::vector<ReportImage> images;
  for (const StartPose& pose : poses) {
    const auto place = patientFromProbe(pose.position_mm, pose.axial, pose.lateral);
    if (!place) return tl::unexpected(place.error());
    const auto scene = makeScene(patient, setup, sceneRegion(setup, *place), progress);
    if (!scene) return tl::unexpected(scene.error());
    ImagingFrame frame;
    imager->render(**scene, *place, frame);
    const std::string file = "ultrasound" + std::to_string(images.size() + 1) + ".png";
    if (const auto ok = writePng(frame.image, folder / file); !ok) return tl::unexpected(ok.error());
    images.push_back({file, pose.name});
  }
  return images;
}

}  // namespace insonate::preparation
