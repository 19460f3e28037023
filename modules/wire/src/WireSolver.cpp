#include "Equilibrium.h"
#include "Rod.h"

#include <insonate/tissue/Labels.h>
#include <insonate/wire/WireSolver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace insonate {
namespace {

using namespace wire;

constexpr double kSteep_deg = 50;      // between needle and vessel; our choice
constexpr double kNearNeedle_mm = 25;  // a bend within this distance of the needle is due to its angle
constexpr double kBehindTip_mm = 20;   // a lumen within this distance behind the tip has been passed through
constexpr double kAtWall_mm = 1;       // a tip up to this distance beyond a round wall still counts as in the lumen
constexpr double kLeastStep_mm = 1e-12;

Frame frameOf(const WireEntry& entry) {
  const Vector z = eigen(entry.direction).normalized();
  Vector x = eigen(entry.bevelNormal);
  x = (x - z * z.dot(x)).normalized();
  Matrix axes;
  axes << x, z.cross(x), z;
  return Frame(axes) * Frame(Eigen::AngleAxisd(entry.roll_deg * std::numbers::pi / 180, Vector::UnitZ()));
}

}  // namespace

std::string_view nameOf(WireRefusal refusal) {
  constexpr std::string_view kNames[]{"",
                                      "against the wall",
                                      "too steep",
                                      "kinked",
                                      "not in a vessel",
                                      "through the posterior wall",
                                      "end of the wire"};
  return kNames[static_cast<int>(refusal)];
}

class WireSolver::Impl {
 public:
  Impl(VesselTree tree, Wire wire, const WireSettings& settings)
      : tree_(std::move(tree)),
        wire_(std::move(wire)),
        settings_(settings),
        length_mm_(lengthOf_mm(wire_)),
        maxSegments_(static_cast<int>(length_mm_ / settings.spacing_mm) + 3),
        step_mm_(std::min(settings.step_mm, settings.spacing_mm / 2)),
        material_(wire_, settings.spacing_mm, maxSegments_),
        energy_(tree_, wire_, settings_, material_),
        rod_(maxSegments_),
        before_(maxSegments_),
        old_(maxSegments_),
        equilibrium_(maxSegments_, settings.tolerance_N, settings.maxIterations),
        nodes_mm_(maxSegments_ + 1) {}

  void start(const WireEntry& entry);
  const WireState& advance(double mm);

  VesselTree tree_;
  Wire wire_;
  WireSettings settings_;
  WireState state_;
  int nodes_ = 0;
  double length_mm_;
  int maxSegments_;

 private:
  void advanceInTissue(double mm);
  bool advanceBy(double step_mm);
  void feed(double step_mm);
  void addSegment();
  void removeSegment();
  void follow(double step_mm);
  void rub(double direction);
  void measure();
  WireRefusal reason(double resistance_N) const;
  void publish();

  double step_mm_;
  RodMaterial material_;

 public:
  RodEnergy energy_;
  Rod rod_;

 private:
  Rod before_, old_;
  Equilibrium equilibrium_;
  WireEntry entry_;
  WireRefusal blocked_ = WireRefusal::None;  ///< reason why the needle's opening leads nowhere
  int kinkedNode_ = 0;                       ///< node with the largest curvature relative to that of a kink
  double kinkShare_ = 0;

 public:
  std::vector<Vec3> nodes_mm_;
};

void WireSolver::Impl::start(const WireEntry& entry) {
  entry_ = entry;
  state_ = {};
  state_.system = tree_.systemAt(entry.tip_mm);
  energy_.setSystem(state_.system);
  rod_.segments = 0;
  rod_.node[0] = eigen(entry.tip_mm);
  rod_.frame[0] = frameOf(entry);
  const auto distance_mm = [&](double behind_mm) {
    return tree_.wallAt(state_.system, entry.tip_mm - entry.direction * behind_mm).distance_mm;
  };
  blocked_ = WireRefusal::None;
  if (distance_mm(0) > -wire_.diameter_mm / 2) {
    blocked_ = distance_mm(0) > 0 ? WireRefusal::NotInVessel : WireRefusal::AgainstWall;
    for (double s = 0.5; s < kBehindTip_mm && distance_mm(0) > 0; s += 0.5)
      if (distance_mm(s) < 0) blocked_ = WireRefusal::ThroughBackWall;
  }
  publish();
}

const WireState& WireSolver::Impl::advance(double mm) {
  state_.refusal = WireRefusal::None;
  state_.iterations = 0;
  if (blocked_ != WireRefusal::None) {
    advanceInTissue(mm);
    return state_;
  }
  double left_mm = std::abs(mm);
  while (left_mm > kLeastStep_mm) {
    const double step_mm = std::min(left_mm, step_mm_);
    if (!advanceBy(mm < 0 ? -step_mm : step_mm)) break;
    left_mm -= step_mm;
  }
  publish();
  return state_;
}

/// Tissue has no channel for a blunt wire: it yields like a spring until the user stops.
void WireSolver::Impl::advanceInTissue(double mm) {
  const double most_mm = settings_.maxForce_N / settings_.tissueStiffness_Npmm;
  const double wanted_mm = std::max(state_.inserted_mm + mm, 0.0);
  state_.inserted_mm = std::min(wanted_mm, most_mm);
  state_.resistance_N = settings_.tissueStiffness_Npmm * state_.inserted_mm;
  if (wanted_mm > most_mm) state_.refusal = blocked_;
  state_.tip = state_.inserted_mm > 0 ? WireTip::Tissue : WireTip::InNeedle;
  nodes_mm_[0] = entry_.tip_mm;
  nodes_mm_[1] = entry_.tip_mm + entry_.direction * state_.inserted_mm;
  nodes_ = state_.inserted_mm > 0 ? 2 : 1;
  state_.at = tree_.locate(state_.system, nodes_mm_[nodes_ - 1]);
}

/// One equilibrium farther in, or out if the step is negative. False if the wire has not moved.
bool WireSolver::Impl::advanceBy(double step_mm) {
  if (state_.inserted_mm + step_mm > length_mm_) {
    state_.refusal = WireRefusal::EndOfWire;
    return false;
  }
  if (state_.inserted_mm + step_mm <= 0) {
    const Vector tip = rod_.node[rod_.segments];
    const Frame clamp = rod_.frame[rod_.segments];
    rod_.segments = 0, rod_.node[0] = tip, rod_.frame[0] = clamp;
    state_.inserted_mm = 0, state_.resistance_N = 0, state_.maxCurvature_1pmm = 0;
    return false;
  }
  before_.copyFrom(rod_);
  const double inserted_mm = state_.inserted_mm;
  feed(step_mm);
  if (rod_.segments == 0) return true;
  const Equilibrium::Outcome outcome = equilibrium_.solve(rod_, energy_);
  state_.unbalanced_N = outcome.unbalanced_N, state_.iterations += outcome.iterations;
  measure();
  if (step_mm > 0 && (state_.resistance_N > settings_.maxForce_N || kinkShare_ > 1)) {
    state_.refusal = reason(state_.resistance_N);
    const double resistance_N = std::min(state_.resistance_N, settings_.maxForce_N);
    rod_.copyFrom(before_);
    state_.inserted_mm = inserted_mm;
    if (rod_.segments > 0) measure();
    state_.resistance_N = resistance_N;
    return false;
  }
  rub(step_mm > 0 ? 1 : -1);
  return true;
}

/// Moves the wire along its own course, the first guess of the next equilibrium.
void WireSolver::Impl::feed(double step_mm) {
  state_.inserted_mm += step_mm;
  const double spacing_mm = settings_.spacing_mm;
  if (rod_.segments == 0) {
    if (state_.inserted_mm < spacing_mm / 2) return;
    rod_.node[1] = rod_.node[0], rod_.frame[1] = rod_.frame[0];
    rod_.node[0] = rod_.node[1] + rod_.frame[0] * Vector::UnitZ() * state_.inserted_mm;
    rod_.length_mm[0] = state_.inserted_mm;
    rod_.load_N[0].setZero(), rod_.load_N[1].setZero();
    rod_.segments = 1;
    return;
  }
  follow(step_mm);
  double& base_mm = rod_.length_mm[rod_.segments - 1];
  base_mm += step_mm;
  if (base_mm > 1.5 * spacing_mm)
    addSegment();
  else if (base_mm < 0.5 * spacing_mm && rod_.segments > 1)
    removeSegment();
  // Without stretch, since the first guess would otherwise push with tens of newtons.
  for (int j = rod_.segments - 1; j >= 0; --j)
    rod_.node[j] = rod_.node[j + 1] + rod_.frame[j] * Vector::UnitZ() * rod_.length_mm[j];
}

void WireSolver::Impl::addSegment() {
  const int last = rod_.segments;
  const double base_mm = rod_.length_mm[last - 1], share = settings_.spacing_mm / base_mm;
  rod_.node[last + 1] = rod_.node[last], rod_.frame[last + 1] = rod_.frame[last];
  rod_.node[last] = rod_.node[last - 1] + (rod_.node[last + 1] - rod_.node[last - 1]) * share;
  rod_.frame[last] = rod_.frame[last - 1];
  rod_.length_mm[last - 1] = settings_.spacing_mm;
  rod_.length_mm[last] = base_mm - settings_.spacing_mm;
  rod_.load_N[last].setZero(), rod_.load_N[last + 1].setZero();
  ++rod_.segments;
}

void WireSolver::Impl::removeSegment() {
  const int last = rod_.segments;
  rod_.length_mm[last - 2] += rod_.length_mm[last - 1];
  rod_.node[last - 1] = rod_.node[last], rod_.frame[last - 1] = rod_.frame[last];
  --rod_.segments;
}

/// Turns each segment to the direction of the place that it reaches. The J keeps its shape, which belongs to the wire.
void WireSolver::Impl::follow(double step_mm) {
  const int count = rod_.segments, pivot = std::min(material_.curvedNodes(), count);
  const double share = std::min(std::abs(step_mm) / settings_.spacing_mm, 1.0);
  old_.copyFrom(rod_);
  for (int k = pivot; k < count; ++k)
    rod_.frame[k] = old_.frame[k].slerp(share, old_.frame[step_mm > 0 ? std::max(k - 1, 0) : k + 1]);
  const Frame turn = rod_.frame[pivot] * old_.frame[pivot].conjugate();
  for (int k = 0; k < pivot; ++k) rod_.frame[k] = (turn * old_.frame[k]).normalized();
}

/// Friction of the next step, from the contact forces of this one.
void WireSolver::Impl::rub(double direction) {
  for (int j = 0; j < rod_.segments; ++j) {
    const auto contact = energy_.contactAt(rod_, j);
    const double force_N = wire_.friction * contact.stiffness_Npmm * contact.depth_mm;
    rod_.load_N[j] = rod_.frame[j] * Vector::UnitZ() * (-direction * force_N);
  }
}

void WireSolver::Impl::measure() {
  state_.resistance_N = energy_.pushOnNeedle_N(rod_);
  state_.maxCurvature_1pmm = 0, state_.deepest_mm = 0;
  kinkShare_ = 0, kinkedNode_ = rod_.segments;
  for (int n = 1; n <= rod_.segments; ++n) {
    const double curvature = energy_.curvature_1pmm(rod_, n);
    state_.maxCurvature_1pmm = std::max(state_.maxCurvature_1pmm, curvature);
    const double share = curvature / material_.kinkCurvature_1pmm(n);
    if (share > kinkShare_) kinkShare_ = share, kinkedNode_ = n;
  }
  for (int n = 0; n < rod_.segments; ++n)
    state_.deepest_mm = std::max(state_.deepest_mm, energy_.contactAt(rod_, n).depth_mm);
}

WireRefusal WireSolver::Impl::reason(double resistance_N) const {
  const VesselTree::Wall wall = tree_.wallAt(state_.system, entry_.tip_mm);
  const double cosine = std::abs(dot(entry_.direction, wall.axis));
  const double angle_deg = std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi;
  const double fromNeedle_mm = (rod_.segments - kinkedNode_) * settings_.spacing_mm;
  if (angle_deg > kSteep_deg && fromNeedle_mm < kNearNeedle_mm) return WireRefusal::TooSteep;
  return resistance_N > settings_.maxForce_N ? WireRefusal::AgainstWall : WireRefusal::Kinked;
}

void WireSolver::Impl::publish() {
  nodes_ = rod_.segments + 1;
  for (int n = 0; n < nodes_; ++n) nodes_mm_[n] = vec3(rod_.node[rod_.segments - n]);
  state_.at = tree_.locate(state_.system, nodes_mm_[nodes_ - 1]);
  state_.tip = rod_.segments == 0                    ? WireTip::InNeedle
               : state_.at.distance_mm <= kAtWall_mm ? WireTip::Lumen
                                                     : WireTip::Tissue;
}

WireSolver::WireSolver(VesselTree tree, Wire wire, const WireSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(tree), std::move(wire), settings)) {
  start({});
}
WireSolver::~WireSolver() = default;
WireSolver::WireSolver(WireSolver&&) noexcept = default;
WireSolver& WireSolver::operator=(WireSolver&&) noexcept = default;

void WireSolver::start(const WireEntry& entry) {
  impl_->start(entry);
}
const WireState& WireSolver::advance(double mm) {
  return impl_->advance(mm);
}
const WireState& WireSolver::state() const {
  return impl_->state_;
}
const Wire& WireSolver::wire() const {
  return impl_->wire_;
}
std::span<const Vec3> WireSolver::nodes_mm() const {
  return {impl_->nodes_mm_.data(), static_cast<std::size_t>(impl_->nodes_)};
}
double WireSolver::energy_Nmm() const {
  return impl_->energy_.energy(impl_->rod_);
}

}  // namespace insonate
