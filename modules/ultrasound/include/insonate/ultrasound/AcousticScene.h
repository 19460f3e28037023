#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Transform.h>
#include <insonate/image/Volume.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/ultrasound/Region.h>
#include <insonate/ultrasound/SceneSource.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

/// A point reflector, such as a wire or bead of a resolution phantom. `amplitude` is the peak of its echo's envelope in
/// focus.
struct PointTarget {
  Vec3 position_mm;  ///< position of the target, patient LPS
  double amplitude = 1;
};

/// Quality of the outlines of structures in a scene. Textures, and the layers at outlines, are the same in all of them.
enum class SceneQuality {
  Full,    ///< independent of the region
  Coarse,  ///< from nodes about 1.4 mm apart, in some hundredths of a second
};

/// The patient's tissue in a region, in the form that engines read: smooth signed distances to every structure,
/// deviations of the CT from the mean of each structure, and the acoustic table. A scene is immutable; any number of
/// threads may read it. With SceneQuality::Full, the values at a point do not depend on the region: scenes of
/// neighboring regions give the same image of tissue that both contain.
class AcousticScene {
 public:
  static constexpr double kFinestDetail_mm = 0.7;
  /// Distance from the trachea, to the left or right, beyond which gas is lung; gas nearer to it is airway.
  static constexpr double kLungFromTrachea_mm = 20;

  /// Makes a scene and copies the data that it needs; `ct` and `labels` must share one grid. Fails if the grids differ
  /// or the region does not touch the volume; warnings() lists unknown labels. Label maps whose voxels are larger than
  /// `detail_mm` are subdivided; sceneDetail_mm() returns a suitable value for a probe.
  static Result<std::shared_ptr<const AcousticScene>> make(const CtVolume& ct, const LabelMap& labels,
                                                           const AcousticTable& table, const Region& region,
                                                           const Progress& progress = {},
                                                           std::vector<PointTarget> points = {},
                                                           double detail_mm = kFinestDetail_mm);
  /// Makes one of several scenes of a case from a common source. The source computes data that the scenes share only
  /// once.
  static Result<std::shared_ptr<const AcousticScene>> make(const SceneSource& source, const AcousticTable& table,
                                                           const Region& region, const Progress& progress = {},
                                                           std::vector<PointTarget> points = {},
                                                           double detail_mm = kFinestDetail_mm,
                                                           SceneQuality quality = SceneQuality::Full);
  ~AcousticScene();

  /// Returns sentences about the case, e.g. unknown labels; empty if there are none.
  const std::vector<std::string>& warnings() const;
  /// Returns the x of the patient's trachea, patient LPS; that of the patient's midline in a case without a trachea.
  double trachea_mm() const;
  /// Returns the table of acoustic properties with which the scene was made.
  const AcousticTable& tissues() const;

  struct Impl;  ///< contents of the scene, read by the engines
  const Impl& impl() const { return *impl_; }

 private:
  explicit AcousticScene(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
