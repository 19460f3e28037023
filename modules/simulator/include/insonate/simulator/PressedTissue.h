#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/image/Volume.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <memory>
#include <optional>

namespace insonate {

/// Blood pressure of a patient at a time; without a time, the mean pressure. If the mean is within half a percent of
/// the pressure that the table gives for the CT, exactly that pressure is returned, so that a patient at rest shows
/// tissue at rest.
BloodPressure bloodPressure(const Physiology& physiology, const MechanicalTable& tissues,
                            std::optional<double> time_s = {});

/// Moves the pose along its axis until the face first touches the labeled body, to within half a millimeter, which is
/// accurate enough to choose the scene. Fails if the face meets no skin within 20 mm behind or 40 mm before it.
Result<Transform> poseOnSkin(const LabelMap& labels, const ProbeFace& face, const Transform& patientFromProbe);

/// A probe's face on tissue: a deformation model together with the image plane of a scene at a pose. If the pose puts
/// the face inside the undeformed tissue, the depth of the face is its indentation. Not for concurrent use of one
/// object.
class PressedTissue {
 public:
  /// Fails as validate() does. `mostIterations`: maximum number of iterations per solution; 0 takes the number of the
  /// mechanical settings. `lumensAtRest`: the model computes the vessels even if nothing moves.
  static Result<PressedTissue> make(const Probe& probe, const ImagingSettings& settings,
                                    const TissueMechanics& mechanics, int mostIterations = 0,
                                    bool lumensAtRest = false);
  PressedTissue(PressedTissue&&) noexcept;
  PressedTissue& operator=(PressedTissue&&) noexcept;
  ~PressedTissue();

  /// Range over which the face at this pose can be moved along its axis. Empty if it meets no skin within 20 mm behind
  /// or 40 mm before it.
  struct Travel {
    double touch_mm = 0;    ///< from this pose to first contact; below 0: the indentation of this pose
    double deepest_mm = 0;  ///< from this pose until the tissue over bone is squeezed to a tenth of its thickness;
                            ///< infinite without bone
  };
  std::optional<Travel> travel(const AcousticScene& scene, const Transform& patientFromProbe);

  /// Solves the tissue with the face at the pose. The scene must cover the region of the pose (see Imager.h). Without
  /// contact, and with blood at the pressure of the CT, nothing is solved and the last solution is discarded. Allocates
  /// nothing after the first call.
  void hold(const AcousticScene& scene, const Transform& patientFromProbe, const BloodPressure& pressure);

  /// Pushes the face along its axis until it presses with this force (N), but not through bone. pose() is the resulting
  /// pose; the solution is in the frame of that pose. If the force is 0, nothing is compressed and the pose stays. If
  /// no skin is near, this does the same as hold().
  void push(const AcousticScene& scene, const Transform& patientFromProbe, const BloodPressure& pressure,
            double force_N);

  /// Removes the probe from the patient and discards the last solution.
  void release();

  /// The last solution, in the frame of pose().
  const Deformation& deformation() const;
  const Transform& pose() const;
  /// Indentation of the face from first contact; below 0: distance from the skin. NaN if no skin is near.
  double indentation_mm() const;
  /// Tells whether push() stopped the face before it reached the force: at bone, at 20 mm of indentation, or because
  /// the model finds no equilibrium any more.
  bool stopped() const;

 private:
  class Impl;
  explicit PressedTissue(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
