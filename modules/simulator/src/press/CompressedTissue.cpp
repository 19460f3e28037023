#include "press/FaceContact.h"
#include "press/ScenePlane.h"

#include <insonate/simulator/CompressedTissue.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace insonate {
namespace {

using press::FaceContact;
using press::FaceTravel;
using press::ScenePlane;

/// Step below which a moving image is accurate enough; `bench deformation` shows its errors.
constexpr double kEnough_mm = 0.5;
constexpr double kOff_mm = 0.1;       // a distance at which contact is excluded
constexpr double kForceError = 0.01;  // share of the requested force
constexpr double kDeepest_mm = 20, kSearchStep_mm = 2;
constexpr int kSearches = 6;
constexpr double kRounding = 0.005;  // share of a pressure by which tables round it

double snapped(double pressure_kPa, const MechanicalTissue& vessel) {
  return std::abs(pressure_kPa - vessel.pressure_kPa) < kRounding * vessel.pressure_kPa ? vessel.pressure_kPa
                                                                                        : pressure_kPa;
}

/// Engines look up places in an answer; places that are not numbers must be excluded.
bool isSane(const Deformation& answer) {
  constexpr float kFarthest_mm = 100;
  const auto sane = [](const PlaneDisplacement::Shift& shift) {
    return std::abs(shift.x_mm) < kFarthest_mm && std::abs(shift.z_mm) < kFarthest_mm;
  };
  return std::isfinite(answer.force_N) && std::ranges::all_of(answer.displacement.restFromDisplayed, sane);
}

bool near(double force_N, double wanted_N) {
  return std::abs(force_N - wanted_N) <= kForceError * wanted_N;
}

/// Keeps the allocated memory.
void clear(Deformation& answer) {
  answer.displacement.columns = answer.displacement.rows = 0;
  answer.displacement.restFromDisplayed.clear();
  answer.force_N = answer.faceShift_mm = 0;
  answer.lumens.clear();
  answer.iterations = answer.meshColumns = answer.meshRows = 0;
  answer.converged = true;
  answer.moved = false;
  answer.mesh.clear();
  answer.pressure_kPa.clear();
}

Transform movedIn(const Transform& patientFromProbe, double z_mm) {
  Transform moved = patientFromProbe;
  moved.offset = patientFromProbe * Vec3{0, 0, z_mm};
  return moved;
}

/// The body of a label map, without distances: inside or outside.
class LabelPlane final : public TissuePlane {
 public:
  LabelPlane(const LabelMap& labels, const Transform& patientFromProbe)
      : labels_(labels), indexFromProbe_(labels.geometry.indexFromPatient() * patientFromProbe) {}

  void sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const override {
    for (std::size_t n = 0; n < at.size(); ++n) {
      tissue[n] = {};
      tissue[n].label = sampleNearest(labels_, indexFromProbe_ * Vec3{at[n].x_mm, 0, at[n].z_mm});
      tissue[n].skin_mm = tissue[n].label == kBackground ? 1.0F : -1.0F;
    }
  }

 private:
  const LabelMap& labels_;
  Transform indexFromProbe_;
};

}  // namespace

Result<Transform> poseOnSkin(const LabelMap& labels, const ProbeFace& face, const Transform& patientFromProbe) {
  const auto travel = FaceContact(face).find(LabelPlane(labels, patientFromProbe));
  if (!travel)
    return fail(
        "The probe's face meets no skin within 20 mm behind it or 40 mm in front of it. Move the pose onto the skin, "
        "or use auto.");
  return movedIn(patientFromProbe, travel->touch_mm);
}

BloodPressure bloodPressure(const Physiology& physiology, const MechanicalTable& tissues,
                            std::optional<double> time_s) {
  if (time_s) return bloodPressureAt(physiology, *time_s);
  const BloodPressure now = meanBloodPressure(physiology);
  return {snapped(now.artery_kPa, tissues.of(kArtery)), snapped(now.vein_kPa, tissues.of(kVein))};
}

class CompressedTissue::Impl {
 public:
  Impl(const ProbeFace& face, const DeformationWindow& window, const MechanicalTable& tissues,
       std::unique_ptr<DeformationModel> model, bool tellsRest)
      : tellsRest_(tellsRest),
        plane_(window),
        contact_(face),
        model_(std::move(model)),
        rest_{tissues.of(kArtery).pressure_kPa, tissues.of(kVein).pressure_kPa} {
    input_.plane = &plane_;
    input_.face = face;
  }

  std::optional<FaceTravel> travelRange(const AcousticScene& scene, const Transform& pose) {
    plane_.look(scene, pose);
    return contact_.find(plane_);
  }

  void hold(const AcousticScene& scene, const Transform& pose, const BloodPressure& pressure) {
    const auto travel = this->travelRange(scene, pose);
    pose_ = pose;
    stopped_ = false;
    indentation_mm_ = travel ? -travel->touch_mm : std::numeric_limits<double>::quiet_NaN();
    const bool touches = travel && travel->touch_mm < 0;
    if (model_ && (touches || !atRest(pressure) || tellsRest_))
      solve(pose, pressure, 0);
    else
      forget();
  }

  void forget() {
    clear(answer_);
    if (model_) model_->reset();
  }

  void push(const AcousticScene& scene, const Transform& pose, const BloodPressure& pressure, double force_N) {
    const auto travel = this->travelRange(scene, pose);
    if (!model_ || !travel) return hold(scene, pose, pressure);
    if (!(force_N > 0)) return leave(scene, pose, pressure, *travel);
    // Starts at the contact of the face, so that the surroundings for the model do not depend on the former position.
    const Transform touching = movedIn(pose, travel->touch_mm);
    const double deepest_mm = travel->deepest_mm - travel->touch_mm;
    plane_.look(scene, touching);
    solve(touching, pressure, force_N);
    stopped_ = false;
    if (!near(answer_.force_N, force_N) || answer_.faceShift_mm > deepest_mm)
      return search(scene, touching, pressure, force_N, deepest_mm);
    indentation_mm_ = answer_.faceShift_mm;
    pose_ = movedIn(touching, answer_.faceShift_mm);
    seeFrom(answer_.faceShift_mm);
  }

  /// For a model that does not find the indentation itself: advances until the force is reached, then bisects.
  void search(const AcousticScene& scene, const Transform& touching, const BloodPressure& pressure, double force_N,
              double deepest_mm) {
    const double max_mm = std::min(deepest_mm, kDeepest_mm);
    const auto forceAt = [&](double indentation_mm) {
      hold(scene, movedIn(touching, indentation_mm), pressure);
      return answer_.converged ? answer_.force_N : HUGE_VAL;
    };
    model_->reset();
    double low_mm = 0, low_N = 0, high_mm = 0, high_N = 0;
    while (high_N < force_N && high_mm < max_mm) {
      low_mm = high_mm, low_N = high_N;
      high_mm = std::min(high_mm + kSearchStep_mm, max_mm);
      high_N = forceAt(high_mm);
    }
    double at_N = high_N;
    for (int i = 0; i < kSearches && high_N > force_N && !near(at_N, force_N); ++i) {
      const double share = std::isfinite(high_N) ? std::clamp((force_N - low_N) / (high_N - low_N), 0.1, 0.9) : 0.5;
      const double at_mm = low_mm + (high_mm - low_mm) * share;
      at_N = forceAt(at_mm);
      (at_N < force_N ? low_mm : high_mm) = at_mm;
      (at_N < force_N ? low_N : high_N) = at_N;
    }
    const bool found = near(at_N, force_N);
    if (!found && high_N > force_N) forceAt(low_mm);
    stopped_ = !found;
  }

  /// Treats the face as off the skin.
  void leave(const AcousticScene& scene, const Transform& pose, const BloodPressure& pressure,
             const FaceTravel& travel) {
    const double back_mm = std::min(travel.touch_mm - kOff_mm, 0.0);
    hold(scene, movedIn(pose, back_mm), pressure);
    seeFrom(-back_mm);
    if (atRest(pressure)) relax();
    pose_ = pose;
    indentation_mm_ = 0;
  }

  void moveLung(const LungMotion& motion) {
    lung_ = motion;
    applySlide();
  }
  void applySlide() { answer_.displacement.lung = lung_; }

  const Deformation& deformation() const { return answer_; }
  const Transform& pose() const { return pose_; }
  double indentation_mm() const { return indentation_mm_; }
  bool isStopped() const { return stopped_; }

 private:
  void solve(const Transform& pose, const BloodPressure& pressure, double force_N) {
    input_.pressure = pressure;
    input_.patientFromProbe = pose;
    input_.force_N = force_N;
    model_->solve(input_, answer_);
    if (!isSane(answer_)) {
      forget();
      model_->solve(input_, answer_);
    }
    if (!isSane(answer_)) {
      forget();
      answer_.converged = false;
    }
    if (!answer_.moved) answer_.displacement.columns = answer_.displacement.rows = 0;
  }

  bool atRest(const BloodPressure& pressure) const {
    return pressure.artery_kPa == rest_.artery_kPa && pressure.vein_kPa == rest_.vein_kPa;
  }

  /// A model's mesh may be in contact although the face is off the skin.
  void relax() {
    std::vector<LumenArea> lumens = std::move(answer_.lumens);
    clear(answer_);
    for (LumenArea& lumen : lumens) lumen.area_mm2 = lumen.rest_mm2;
    answer_.lumens = std::move(lumens);
  }

  /// Converts from a frame that is deeper by `z_mm`. Shifts, as differences of places, do not change.
  void seeFrom(double z_mm) {
    answer_.displacement.top_mm -= z_mm;
    const auto z = static_cast<float>(z_mm);
    for (MeshNode& node : answer_.mesh) node.restZ_mm -= z, node.z_mm -= z;
  }

  const bool tellsRest_;
  ScenePlane plane_;
  FaceContact contact_;
  std::unique_ptr<DeformationModel> model_;
  BloodPressure rest_;
  DeformationInput input_;
  Deformation answer_;
  Transform pose_;
  double indentation_mm_ = std::numeric_limits<double>::quiet_NaN();
  bool stopped_ = false;
  LungMotion lung_;
};

CompressedTissue::CompressedTissue(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
CompressedTissue::CompressedTissue(CompressedTissue&&) noexcept = default;
CompressedTissue& CompressedTissue::operator=(CompressedTissue&&) noexcept = default;
CompressedTissue::~CompressedTissue() = default;

Result<CompressedTissue> CompressedTissue::make(const Probe& probe, const ImagingSettings& settings,
                                                const TissueMechanics& mechanics, int maxIterations,
                                                bool lumensAtRest) {
  if (auto ok = validate(mechanics); !ok) return tl::unexpected(ok.error());
  std::unique_ptr<DeformationModel> model;
  if (mechanics.model != kNoDeformation) {
    DeformationSettings own = mechanics.settings;
    if (maxIterations > 0) own.maxIterations = maxIterations, own.movingTolerance_mm = kEnough_mm;
    auto made = makeDeformationModel(mechanics.model, mechanics.tissues, own);
    if (!made) return tl::unexpected(made.error());
    model = std::move(*made);
  }
  return CompressedTissue(std::make_unique<Impl>(probeFaceOf(probe, mechanics),
                                                 deformationWindow(probe, settings, mechanics), mechanics.tissues,
                                                 std::move(model), lumensAtRest));
}

std::optional<CompressedTissue::Travel> CompressedTissue::travelRange(const AcousticScene& scene,
                                                                      const Transform& patientFromProbe) {
  const auto found = impl_->travelRange(scene, patientFromProbe);
  if (!found) return {};
  return Travel{found->touch_mm, found->deepest_mm};
}

void CompressedTissue::hold(const AcousticScene& scene, const Transform& patientFromProbe,
                            const BloodPressure& pressure) {
  impl_->hold(scene, patientFromProbe, pressure);
  impl_->applySlide();
}

void CompressedTissue::push(const AcousticScene& scene, const Transform& patientFromProbe,
                            const BloodPressure& pressure, double force_N) {
  impl_->push(scene, patientFromProbe, pressure, force_N);
  impl_->applySlide();
}

void CompressedTissue::moveLung(const LungMotion& motion) {
  impl_->moveLung(motion);
}

void CompressedTissue::release() {
  impl_->forget();
}

const Deformation& CompressedTissue::deformation() const {
  return impl_->deformation();
}

const Transform& CompressedTissue::pose() const {
  return impl_->pose();
}

double CompressedTissue::indentation_mm() const {
  return impl_->indentation_mm();
}

bool CompressedTissue::isStopped() const {
  return impl_->isStopped();
}

}  // namespace insonate
