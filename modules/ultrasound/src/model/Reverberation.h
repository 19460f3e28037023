#pragma once

#include "model/FramePlan.h"

#include <span>
#include <vector>

namespace insonate {

/// Echoes behind a surface of gas. Only two kinds of echoes arrive from there: the tissue above, mirrored, and rings
/// (echoes that go back and forth between gas and probe), each of which repeats the surface's own echo. The surface is
/// a rough mucosa: the strength of each ring varies along the surface independently.
class Reverberation {
 public:
  /// Number of gates behind the gas surface from which on echoes are replaced, so that the surface keeps its own echo.
  static constexpr int kFirstGate = 2;

  /// A repeated echo: the echo of the gate `gatesAbove` gates above the gas surface is repeated with the factor `share`
  /// and the strength of its ring.
  struct Repeat {
    int gatesAbove;
    float share;
    int ring;  ///< number of the ring; 0: the mirrored tissue
  };

  explicit Reverberation(const FramePlan& plan);

  /// Computes the strength of each ring at a point of the gas surface; 1 on average.
  void strengthsAt(Vec3 surface_mm, std::span<float> strength) const;
  int rings() const { return rings_; }

  /// Returns the repeated echoes that arrive at a gate this number of gates behind the gas surface.
  std::span<const Repeat> at(int gatesBehind) const {
    return {repeats_.data() + first_[gatesBehind], repeats_.data() + first_[gatesBehind + 1]};
  }

 private:
  std::vector<Repeat> repeats_;
  std::vector<int> first_;
  int rings_ = 1;
};

}  // namespace insonate
