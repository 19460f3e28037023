#include <insonate/simulator/PoseChecks.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insonate {
namespace {

constexpr double kDeepest_mm = 15, kFarthest_mm = 30, kMaxOutside = 0.25;
constexpr double kStep_mm = 0.5;

std::string millimetres(double value_mm) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", value_mm);
  return text;
}

class Places {
 public:
  explicit Places(const LabelMap& labels) : labels_(labels), indexFromPatient_(labels.geometry.indexFromPatient()) {}

  bool inVolume(Vec3 patient_mm) const {
    const Vec3 index = indexFromPatient_ * patient_mm;
    for (int a = 0; a < 3; ++a)
      if (!(index[a] >= -0.5 && index[a] <= labels_.geometry.size[a] - 0.5)) return false;
    return true;
  }
  bool inBody(Vec3 patient_mm) const { return sampleNearest(labels_, indexFromPatient_ * patient_mm) != 0; }

 private:
  const LabelMap& labels_;
  Transform indexFromPatient_;
};

/// A path along a direction, up to `length_mm`, that is entirely in the body; empty if it is not.
bool along(const Places& places, Vec3 from_mm, Vec3 direction, double length_mm, bool inBody) {
  for (double s = 0; s <= length_mm; s += kStep_mm)
    if (places.inBody(from_mm + s * direction) != inBody) return false;
  return true;
}

double shareOutside(const Places& places, const BeamGrid& grid, const Transform& patientFromProbe) {
  constexpr int kAcross = 24, kDeep = 24;
  int outside = 0;
  for (int l = 0; l < kAcross; ++l)
    for (int s = 0; s < kDeep; ++s) {
      const double line = (l + 0.5) / kAcross * (grid.scanlines() - 1);
      const double range_mm = grid.range_mm((s + 0.5) / kDeep * (grid.samples() - 1));
      outside += !places.inVolume(patientFromProbe * (grid.origin(line) + grid.direction(line) * range_mm));
    }
  return double(outside) / (kAcross * kDeep);
}

/// "At this pose" or "At poses 0, 3, 4, 7 and 9 more".
std::string subject(const std::vector<std::size_t>& poses, std::size_t all) {
  if (all == 1) return "At this pose";
  constexpr std::size_t kNamed = 4;
  std::string text = poses.size() == 1 ? "At pose " : "At poses ";
  for (std::size_t n = 0; n < std::min(poses.size(), kNamed); ++n) text += (n ? ", " : "") + std::to_string(poses[n]);
  if (poses.size() > kNamed) text += " and " + std::to_string(poses.size() - kNamed) + " more";
  return text;
}

}  // namespace

std::vector<std::string> poseWarnings(const PatientCase& patient, const ImagingSetup& setup,
                                      std::span<const Transform> path) {
  std::vector<std::string> warnings;
  if (setup.settings.focus_mm > setup.settings.depth_mm)
    warnings.push_back("The focus at " + millimetres(setup.settings.focus_mm) + " is deeper than the image of " +
                       millimetres(setup.settings.depth_mm) + "; set focus_mm within depth_mm.");
  const Places places(patient.labels);
  const BeamGrid grid(setup.probe, setup.settings);
  const bool labeled = std::ranges::any_of(patient.labels.voxels, [](std::uint8_t v) { return v != 0; });
  std::vector<std::size_t> deep, far, outside;
  for (std::size_t n = 0; n < path.size(); ++n) {
    const Vec3 face_mm = path[n].offset, axial = path[n].linear.column[2];
    if (labeled && along(places, face_mm, -axial, kDeepest_mm, true)) deep.push_back(n);
    if (labeled && along(places, face_mm, axial, kFarthest_mm, false)) far.push_back(n);
    if (shareOutside(places, grid, path[n]) > kMaxOutside) outside.push_back(n);
  }
  const auto warn = [&](const std::vector<std::size_t>& poses, const std::string& what) {
    if (!poses.empty()) warnings.push_back(subject(poses, path.size()) + " " + what);
  };
  warn(deep, "the probe's face is more than 15 mm inside the body; move the probe back onto the skin.");
  warn(far, "the probe's face is more than 30 mm off the skin; move the probe onto the skin.");
  warn(outside,
       "more than a quarter of the field of view lies outside the scan, where there are no data. Move the probe.");
  return warnings;
}

}  // namespace insonate
