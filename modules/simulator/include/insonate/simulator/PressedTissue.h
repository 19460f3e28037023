#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/image/Volume.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <memory>
#include <optional>

namespace insonate {

/// Blood pressure of a patient at a time; without one, its mean, and where that is within half a percent of the
/// pressure that the table says the CT was taken under, exactly that: so that a patient at rest is at rest.
BloodPressure bloodPressure(const Physiology& physiology, const MechanicalTable& tissues,
                            std::optional<double> time_s = {});

/// The pose, moved along its axis until the face first touches the labeled body, to within half a millimeter: near
/// enough to know which scene is needed. Fails where the face meets no skin within 20 mm behind or 40 mm before it.
Result<Transform> poseOnSkin(const LabelMap& labels, const ProbeFace& face, const Transform& patientFromProbe);

/// A probe's face on tissue: a deformation model with the plane that a scene shows at a pose. A pose whose face lies
/// inside the undeformed tissue presses: that is its indentation. Not for concurrent use of one object.
class PressedTissue {
 public:
  /// Fails as validate() does. `mostIterations`: maximum number of iterations per answer; 0 takes the number of the
  /// mechanical settings. `lumensAtRest`: the model computes the vessels even where nothing moves.
  static Result<PressedTissue> make(const Probe& probe, const ImagingSettings& settings,
                                    const TissueMechanics& mechanics, int mostIterations = 0,
                                    bool lumensAtRest = false);
  PressedTissue(PressedTissue&&) noexcept;
  PressedTissue& operator=(PressedTissue&&) noexcept;
  ~PressedTissue();

  /// Range over which the face at this pose can be moved along its axis. Empty if it meets no skin within 20 mm behind
  /// or 40 mm before it.
  struct Travel {
    double touch_mm = 0;    ///< until it first touches; below 0: the indentation of this pose
    double deepest_mm = 0;  ///< until the tissue over bone is squeezed to a tenth; infinite without bone
  };
  std::optional<Travel> travel(const AcousticScene& scene, const Transform& patientFromProbe);

  /// Solves the tissue with the face at the pose. The scene must cover its region (see Imager.h). Without contact, and
  /// with blood at the pressure of the CT, it solves nothing and discards the last solution. Allocates nothing after
  /// the first call.
  void hold(const AcousticScene& scene, const Transform& patientFromProbe, const BloodPressure& pressure);

  /// The face is pushed along its axis until it presses with this force (N), but not through bone. pose() is where it
  /// then is; the answer is in the frame of that pose. Without a force nothing is pressed, wherever the face is, and
  /// the pose stays. As hold() where no skin is near.
  void push(const AcousticScene& scene, const Transform& patientFromProbe, const BloodPressure& pressure,
            double force_N);

  /// Removes the probe from the patient and discards the last solution.
  void release();

  /// The last answer, in the frame of pose().
  const Deformation& deformation() const;
  const Transform& pose() const;
  /// Indentation of the face from first contact; below 0: distance from the skin. NaN if no skin is near.
  double indentation_mm() const;
  /// push(): the face was stopped before the force was reached, by bone, by 20 mm of indentation, or where the model
  /// finds no equilibrium any more.
  bool stopped() const;

 private:
  class Impl;
  explicit PressedTissue(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
