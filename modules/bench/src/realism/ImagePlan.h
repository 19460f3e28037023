#pragma once

#include <insonate/bench/SourceImage.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/Imager.h>

#include <random>
#include <span>

namespace insonate::bench {

/// Random numbers of one set of images; the same seed gives the same numbers.
class Choices {
 public:
  explicit Choices(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::size_t index(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  bool happens(double probability) { return between(0, 1) < probability; }

 private:
  std::mt19937 random_;
};

/// Kind of an image to simulate.
struct ImageKind {
  ProbeShape probe = ProbeShape::Linear;
  std::optional<ScanPlane> plane;  ///< plane of the image; empty: any plane
  bool clip = false, sweeps = false;
};

/// Everything that determines one simulated image or clip, apart from patient and noise.
struct ImagePlan {
  ImagingSetup setup;
  std::vector<Transform> patientFromProbe;  ///< pose of the probe for each frame
  ScanPlane plane = ScanPlane::Transverse;
  double force_N = 0;     ///< compression force of the probe
  double medianGray = 0;  ///< median gray value to which the gain is adjusted
  double start_s = 0;     ///< time of the first frame in heartbeat and breath
  std::string about;

  const Transform& middle() const { return patientFromProbe[patientFromProbe.size() / 2]; }
};

/// Returns the plane of a start pose: transverse or longitudinal if the pose is within 30 degrees of it, else oblique.
ScanPlane planeOf(const StartPose& view);

/// Draws a machine, settings, and a pose near one of the start poses at which the whole face touches the skin. Fails if
/// no such pose is found.
Result<ImagePlan> planImage(const PatientCase& patient, std::span<const StartPose> views, const Probe& probe,
                            const AcousticTable& tissues, const ImageKind& kind, Choices& choices);

}  // namespace insonate::bench
