#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/image/Volume.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <memory>
#include <optional>

namespace insonate {

/// Returns a patient's blood pressure at a time; without a time, the mean pressure. A mean within half a percent of the
/// pressure at which the CT was taken (`tissues`) is replaced by exactly that pressure, so that vessels have their size
/// in the CT.
BloodPressure bloodPressure(const Physiology& physiology, const MechanicalTable& tissues,
                            std::optional<double> time_s = {});

/// Returns the pose moved along the probe's axis until the probe's face first touches the labeled body, accurate to
/// half a millimeter. Use the result to choose the region of a scene (sceneRegion()). Fails if there is no skin within
/// 20 mm behind or 40 mm in front of the face.
Result<Transform> poseOnSkin(const LabelMap& labels, const ProbeFace& face, const Transform& patientFromProbe);

/// Computes the deformation of tissue in the image plane by a probe's face. If the face is inside the undeformed
/// tissue, its depth below the undeformed skin is the indentation. One object must not be used concurrently.
class CompressedTissue {
 public:
  /// Makes an object that computes the compression by one probe. Fails as validate() does. `maxIterations`: maximum
  /// number of iterations per solution; 0: that of `mechanics`. `lumensAtRest`, true: the cross-sectional areas of
  /// vessels are also computed if the tissue is undeformed.
  static Result<CompressedTissue> make(const Probe& probe, const ImagingSettings& settings,
                                       const TissueMechanics& mechanics, int maxIterations = 0,
                                       bool lumensAtRest = false);
  CompressedTissue(CompressedTissue&&) noexcept;
  CompressedTissue& operator=(CompressedTissue&&) noexcept;
  ~CompressedTissue();

  /// Distances along the probe's axis from a pose to first contact and to the deepest possible compression.
  struct Travel {
    /// distance from the pose to first contact with the skin; negative: the pose is this far below first contact
    double touch_mm = 0;
    /// Distance from the pose to the position at which the tissue between face and bone is compressed to a tenth of its
    /// thickness; infinite if there is no bone.
    double deepest_mm = 0;
  };
  /// Returns the range over which the probe's face can be moved along its axis from this pose. Empty if there is no
  /// skin within 20 mm behind or 40 mm in front of the face.
  std::optional<Travel> travelRange(const AcousticScene& scene, const Transform& patientFromProbe);

  /// Computes the deformation with the probe's face at the pose. The scene must cover the region of the pose
  /// (sceneRegion()). Without contact, and with blood at its pressure in the CT, the tissue is undeformed and the last
  /// deformation is discarded. Allocates nothing after the first call.
  void hold(const AcousticScene& scene, const Transform& patientFromProbe, const BloodPressure& pressure);

  /// Moves the probe along its axis until the contact force is `force_N`, but not into bone, and computes the
  /// deformation at the resulting pose, which pose() returns. If `force_N` is 0, the pose stays and nothing is
  /// compressed. If there is no skin nearby, the deformation is computed at the pose itself, as hold() does.
  void push(const AcousticScene& scene, const Transform& patientFromProbe, const BloodPressure& pressure,
            double force_N);

  /// Sets PlaneDisplacement::lung of the present deformation and of those that hold() and push() compute later.
  void moveLung(const LungMotion& motion);

  /// Discards the last deformation. Call it when the probe is taken off the patient.
  void release();

  /// Returns the deformation that hold() or push() computed last, in the probe frame of pose().
  const Deformation& deformation() const;
  /// Returns the probe's pose at which hold() or push() computed the deformation last.
  const Transform& pose() const;
  /// Returns the depth of the probe's face below the position of first contact with the skin. Negative: the face is
  /// this far off the skin. NaN: there is no skin nearby.
  double indentation_mm() const;
  /// Tells whether the last push() stopped before the contact force reached the required force: at bone, at 20 mm of
  /// indentation, or because the model found no equilibrium.
  bool isStopped() const;

 private:
  class Impl;
  explicit CompressedTissue(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
