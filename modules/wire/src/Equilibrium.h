#pragma once

#include "Rod.h"

namespace insonate::wire {

/// Finds the equilibrium of a rod near its present shape: Newton steps with exact second derivatives, solved directly
/// in a time that is linear in the number of segments, with a damping that grows until the energy decreases (Levenberg
/// 1944). Allocates only when constructed.
class Equilibrium {
 public:
  Equilibrium(int maxSegments, double tolerance_N, int maxIterations)
      : tolerance_N_(tolerance_N),
        maxIterations_(maxIterations),
        trial_(maxSegments),
        equations_(maxSegments),
        gradient_(maxSegments),
        change_(maxSegments) {}

  struct Outcome {
    double unbalanced_N = 0;  ///< largest force, or moment at a lever of 5 mm, on a segment
    int iterations = 0;
  };
  Outcome solve(Rod& rod, const RodEnergy& energy);

 private:
  bool improve(Rod& rod, const RodEnergy& energy);
  double applyChange(const Rod& rod);

  double tolerance_N_;
  int maxIterations_;
  Rod trial_;
  BlockSolver equations_;
  std::vector<BlockVector> gradient_, change_;
  double energy_Nmm_ = 0, damping_ = 0;
};

}  // namespace insonate::wire
