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

/// Name and limits of a real haptic device for simulation and tests, from the manufacturer and from published
/// measurements.
struct DeviceProfile {
  std::string_view name;
  DeviceLimits limits;
};
std::span<const DeviceProfile> deviceProfiles();

/// Returns the maximum stiffness of a virtual wall, N/mm, at which a haptic device stays passive (creates no energy).
/// Colgate and Schenkel, J Robot Syst 1997;14:37: b > K T / 2 + |B|, with K the stiffness, T the period, b the device's
/// and B the virtual damping. If friction is the device's only damping, the smaller of two limits holds, with f the
/// friction, d the encoder's step and v the speed: f > K d / 2 (Abbott and Okamura, IEEE Trans Robot 2005;21:952), and
/// f > K T v / 2 at the speed `fastest_mmps` (Diolaiti, Niemeyer, Barbagli and Salisbury, IEEE Trans Robot
/// 2006;22:256).
double passiveStiffness_Npmm(const DeviceLimits& limits, double virtualDamping_Nspm, double fastest_mmps);

/// Mechanics of a hand that holds a stylus: mass of hand and fingers, and the spring and damper between the stylus and
/// the place to which the hand moves. Values from Fu and Cavusoglu, IEEE Trans Syst Man Cybern B 2012;42:1633.
struct Grip {
  double mass_kg = 0.15;
  double stiffness_Npmm = 0.5;
  double damping_Nspm = 5;
};

/// Target position of a simulated hand as a function of time, recorded or synthetic. The path is linear between its
/// points, and constant before the first and after the last point.
struct HandPath {
  struct Point {
    double time_s = 0;  ///< time since the path's beginning; strictly increasing from point to point
    Vec3 position_mm;   ///< position of the stylus, device frame
    Mat3 attitude;      ///< attitude of the stylus, device frame
  };
  std::vector<Point> points;

  /// Returns the interpolated point of the path at a time.
  Point at(double time_s) const;
};

/// Parses a path from text with one line for each point: `time_s,x_mm,y_mm,z_mm`. Either each line or no line continues
/// with the nine elements of the stylus's rotation matrix, column by column. Lines that begin with # are comments.
/// Fails with a sentence that names the line that cannot be parsed.
Result<HandPath> parseHandPath(std::string_view text);
std::string textOf(const HandPath& path);

/// Dynamics of a haptic device (mass, damping, friction, encoders, maximum force) held by a hand. The motion is
/// integrated in steps of 50 us; the force loop's force is constant during a tick. The attitude of the stylus follows
/// the hand without delay.
class SimulatedHand {
 public:
  SimulatedHand(const DeviceLimits& device, const Grip& grip, Vec3 start_mm);

  /// Simulates one tick: the hand moves toward `want`, and the device pushes with `force` (device frame).
  void move(const HandPath::Point& want, const Force& force, double tick_s);

  /// Returns the present state as the device's encoders report it, with the time stamp `time_ns`.
  DeviceState state(std::int64_t time_ns) const;
  Vec3 position_mm() const { return position_mm_; }
  Vec3 velocity_mmps() const { return velocity_mmps_; }

  /// Returns the net energy that the hand and the moving masses have put into the force loop so far.
  double intoLoop_J() const { return intoLoop_mJ_ * 1e-3; }
  /// Returns the energy that the device's damping and friction have dissipated so far.
  double lost_J() const { return lost_mJ_ * 1e-3; }

 private:
  DeviceLimits device_;
  Grip grip_;
  Vec3 position_mm_, velocity_mmps_;
  Mat3 attitude_;
  double intoLoop_mJ_ = 0, lost_mJ_ = 0;
};

/// Checks the passivity of a force loop: a passive loop never returns more energy to the hand than it received
/// (Hannaford and Ryu 2002). Whenever no force acts, the sum of energy restarts at 0, so that energy which friction
/// dissipated in one contact cannot hide energy that the loop returns in a later contact.
class PassivityObserver {
 public:
  /// Adds a measurement. `into_J`: net energy that the hand has put into the loop so far. `felt`, true: the loop exerts
  /// a force now.
  void add(double into_J, bool felt);
  /// Returns the minimum of the net energy put into the loop since a contact began, 0 or less; negative if the loop was
  /// not passive.
  double minEnergy_J() const { return minEnergy_J_; }

 private:
  double begin_J_ = 0, minEnergy_J_ = 0;
};

}  // namespace insonate
