#pragma once

#include <insonate/core/Result.h>
#include <insonate/haptics/DeviceLimits.h>
#include <insonate/haptics/DeviceState.h>
#include <insonate/haptics/Force.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Published properties of real devices, from manufacturers and measurements; for simulated hands and tests.
struct DeviceProfile {
  std::string_view name;
  DeviceLimits limits;
};
std::span<const DeviceProfile> deviceProfiles();

/// The maximum stiffness of a virtual wall, N/mm, at which a device stays passive. Colgate and Schenkel, J Robot Syst
/// 1997;14:37: b > K T / 2 + |B|, with K the stiffness, T the period, b the device's and B the virtual damping. If
/// friction is the device's only damping, the smaller of two limits holds, with f the friction, d the encoder's step
/// and v the speed: f > K d / 2 (Abbott and Okamura, IEEE Trans Robot 2005;21:952), and f > K T v / 2 at the speed
/// `fastest_mmps` (Diolaiti, Niemeyer, Barbagli and Salisbury, IEEE Trans Robot 2006;22:256).
double passiveStiffness_Npmm(const DeviceLimits& limits, double virtualDamping_Nspm, double fastest_mmps);

/// Mechanics of a hand that holds a stylus: mass of hand and fingers, and the spring and damper between the stylus and
/// the place to which the hand moves. Values from Fu and Cavusoglu, IEEE Trans Syst Man Cybern B 2012;42:1633.
struct Grip {
  double mass_kg = 0.15;
  double stiffness_Npmm = 0.5;
  double damping_Nspm = 5;
};

/// Places to which a hand moves, by time: a recorded or synthetic path, linear between its points, constant before the
/// first and after the last.
struct HandPath {
  struct Point {
    double time_s = 0;  ///< strictly increasing
    Vec3 position_mm;   ///< position of the stylus, device frame
    Mat3 attitude;      ///< attitude of the stylus, device frame
  };
  std::vector<Point> points;

  Point at(double time_s) const;
};

/// Parses a path from text: one line for each point, `time_s,x_mm,y_mm,z_mm`, optionally followed by the stylus's nine
/// direction cosines, columns first (on all lines or on none). Lines that begin with # are comments. Fails with the
/// line that is not understood.
Result<HandPath> parseHandPath(std::string_view text);
std::string textOf(const HandPath& path);

/// A device with mass, damping, friction, encoders and a maximum force, held by a hand. The motion is computed in steps
/// of 50 us; the servo's force is constant during a tick. The attitude follows the hand.
class SimulatedHand {
 public:
  SimulatedHand(const DeviceLimits& device, const Grip& grip, Vec3 start_mm);

  /// Simulates one tick: the hand moves toward `want`, and the device pushes with `force` (device frame).
  void move(const HandPath::Point& want, const Force& force, double tick_s);

  /// Readings of the encoders at `time_ns`.
  DeviceState state(std::int64_t time_ns) const;
  Vec3 position_mm() const { return position_mm_; }
  Vec3 velocity_mmps() const { return velocity_mmps_; }

  /// Energy that the hand and the moving masses have put into the servo so far, minus the energy that came back.
  double intoLoop_J() const { return intoLoop_mJ_ * 1e-3; }
  /// Energy that the device's damping and friction have dissipated.
  double lost_J() const { return lost_mJ_ * 1e-3; }

 private:
  DeviceLimits device_;
  Grip grip_;
  Vec3 position_mm_, velocity_mmps_;
  Mat3 attitude_;
  double intoLoop_mJ_ = 0, lost_mJ_ = 0;
};

/// Measures the energy that a hand puts into a loop and gets back. A passive loop never returns more than it received
/// (Hannaford and Ryu 2002). The measurement restarts whenever no force acts, so that energy dissipated by friction is
/// not credited later.
class PassivityObserver {
 public:
  /// Adds a measurement: `into_J` is the energy put in so far; `felt` tells whether the loop exerts a force now.
  void look(double into_J, bool felt);
  double least_J() const { return least_J_; }

 private:
  double begin_J_ = 0, least_J_ = 0;
};

}  // namespace insonate
