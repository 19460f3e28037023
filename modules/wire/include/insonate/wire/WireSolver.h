#pragma once

#include <insonate/wire/VesselTree.h>
#include <insonate/wire/Wire.h>

#include <memory>
#include <span>

namespace insonate {

/// Opening of the needle through which a wire enters, or the site from which a catheter enters. Patient LPS.
struct WireEntry {
  Vec3 tip_mm{};
  Vec3 direction{0, 0, 1};    ///< unit direction of the needle's shaft, toward the tip
  Vec3 bevelNormal{1, 0, 0};  ///< direction in which the bevel faces; only its part across the shaft is used
  /// angle about the shaft from the bevel to the side toward which the J bends, right-handed about `direction`
  double roll_deg = 0;
};

/// Accuracy and constants of the solver. The defaults are those of training.
struct WireSettings {
  double spacing_mm = 2;              ///< distance between nodes, 0.25 to 5
  double step_mm = 1;                 ///< maximum advance between two equilibria, 0.05 to 2
  double tolerance_N = 1e-4;          ///< maximum force on a node that is not balanced
  int maxIterations = 60;             ///< maximum number of Newton steps for one equilibrium
  double wallStiffness_Npmm2 = 1;     ///< force on each millimeter of wire per millimeter into the wall; our choice
  double tipStiffness_Npmm = 4;       ///< force on the tip per millimeter into the wall; our choice
  double tissueStiffness_Npmm = 0.5;  ///< force at the needle per millimeter of wire pushed into tissue; our choice
  double maxForce_N = 2;              ///< resistance at which the user stops; our choice
};

enum class WireRefusal { None, AgainstWall, TooSteep, Kinked, NotInVessel, ThroughBackWall, EndOfWire };
/// Returns "against the wall", "too steep", "kinked", "not in a vessel", "through the posterior wall", "end of the
/// wire" or "".
std::string_view nameOf(WireRefusal refusal);

enum class WireTip { InNeedle, Lumen, Tissue };

/// State of a wire after an advance.
struct WireState {
  double inserted_mm = 0;   ///< length of wire beyond the tip of the needle
  double resistance_N = 0;  ///< force at the needle against the advance; negative while the wire is held back
  WireRefusal refusal = WireRefusal::None;  ///< reason why the last advance stopped before its end
  WireTip tip = WireTip::InNeedle;
  std::uint8_t system = 0;    ///< label of the vessels in which the wire runs: kVein or kArtery
  VesselTree::Location at{};  ///< location of the wire's tip
  double maxCurvature_1pmm = 0;
  double deepest_mm = 0;    ///< maximum distance of a node beyond the wall, less the wire's radius; 0 or more
  double unbalanced_N = 0;  ///< largest force on a node that the solver left
  int iterations = 0;       ///< number of Newton steps of the last advance
};

/// A guidewire or catheter in static equilibrium in the lumens of a patient: a Cosserat rod (positions and frames of
/// segments; bending, twist, stretch) with one-sided elastic contact to the walls and Coulomb friction. Newton steps
/// use a direct factorization whose time is linear in the number of nodes. The same calls give the same result bit for
/// bit. Only the part beyond the needle's tip is computed; there the rod is clamped along the shaft.
///
/// No member function except the constructor allocates. One object must not be used concurrently.
class WireSolver {
 public:
  /// `wire` must be valid (see validate()).
  WireSolver(VesselTree tree, Wire wire, const WireSettings& settings = {});
  ~WireSolver();
  WireSolver(WireSolver&&) noexcept;
  WireSolver& operator=(WireSolver&&) noexcept;

  /// Puts the wire's tip into the opening of the needle.
  void start(const WireEntry& entry);
  /// Advances the wire by `mm`, or withdraws it if `mm` is negative. Stops early if the resistance exceeds the limit,
  /// or if the wire kinks; `refusal` of the state tells the reason.
  const WireState& advance(double mm);
  const WireState& state() const;
  const Wire& wire() const;
  /// Returns the positions of the nodes from the tip of the needle to the tip of the wire.
  std::span<const Vec3> nodes_mm() const;
  /// Returns the energy of the rod and of its contacts, in N mm.
  double energy_Nmm() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
