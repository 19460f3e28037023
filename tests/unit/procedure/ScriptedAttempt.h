#pragma once

#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/AttemptScore.h>

#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace insonate::test {

/// The sentence of each moment of a score.
inline std::vector<std::string> sentences(const AttemptScore& score) {
  std::vector<std::string> all;
  for (const AttemptMoment& moment : score.moments) all.push_back(moment.description);
  return all;
}

/// A wall that lies across the needle's way: depths along the needle, below the skin.
struct CrossedWall {
  CrossedWall(Label crossed, double from_mm, double to_mm, std::uint8_t number = 0)
      : label(crossed), front_mm(from_mm), back_mm(to_mm), vessel(number) {}
  Label label;
  double front_mm, back_mm;
  std::uint8_t vessel;  ///< AttemptEvent::vessel
};

/// An attempt as the servo would tell it, a sample a millisecond, made from a few words. The skin is the plane z = 0, z
/// into the body. The needle goes along +x and +z at 45 degrees. The probe lies still with its face over x = 20, and
/// shows 40 mm of depth and 38 of width; `probe_y_mm` moves it aside.
class ScriptedAttempt {
 public:
  std::vector<CrossedWall> walls{{kVein, 20, 30}};
  bool aspirating = false;
  bool probeHeld = true;
  bool hasTarget = false;  ///< AttemptMetrics
  double probe_y_mm = 0, force_N = 2;
  std::optional<double> toArtery_mm, toVeinCenter_mm;
  std::optional<double> wire_mm, dilator_mm, catheter_mm, wireToHeart_mm, catheterToHeart_mm;
  std::vector<std::variant<AttemptSample, AttemptEvent>> stream;

  static ImageField picture() { return {.width_mm = 38, .sliceHalf_mm = 1.5}; }
  static Vec3 axis() { return normalized({1, 0, 1}); }

  void hold(double seconds) { travel(depth_mm_, seconds, 0); }
  /// From where it is to this depth along the needle, negative above the skin; 10 mm/s.
  void needleTo(double depth_mm) { travel(depth_mm, std::abs(depth_mm - depth_mm_) / kSpeed_mmps, kSpeed_mmps); }
  /// Outside, sideways to another place of the skin, in no time.
  void aim(double y_mm) { y_mm_ = y_mm; }
  void tell(AttemptEventKind kind, Label wall = kSkin) {
    stream.push_back(AttemptEvent{.time_us = time_us_, .kind = kind, .wall = wall, .tip_mm = tip(), .axis = axis()});
  }

  /// An act of the line, at a vessel with this label.
  void perform(LineAct act, double amount = 0, Label wall = kVein, std::uint8_t vessel = 1) {
    stream.push_back(AttemptEvent{.time_us = time_us_,
                                  .kind = AttemptEventKind::Performed,
                                  .wall = wall,
                                  .vessel = vessel,
                                  .act = act,
                                  .amount = amount});
  }
  void instrument(AttemptEventKind kind, Instrument which, Label into = kVein, std::uint8_t vessel = 1) {
    stream.push_back(AttemptEvent{
        .time_us = time_us_, .kind = kind, .wall = into, .into = into, .vessel = vessel, .instrument = which});
  }

  AttemptMetrics pass() const {
    AttemptMetrics metrics(picture(), hasTarget);
    for (const auto& entry : stream) std::visit([&](const auto& what) { metrics.add(what); }, entry);
    return metrics;
  }
  MetricValues values() const { return pass().values(); }

 private:
  static constexpr double kSpeed_mmps = 10;

  Vec3 tip() const { return Vec3{0, y_mm_, 0} + axis() * depth_mm_; }

  void travel(double to_mm, double seconds, double speed_mmps) {
    const int ticks = static_cast<int>(std::lround(seconds * 1000));
    const double from_mm = depth_mm_, sign = to_mm < from_mm ? -1 : 1;
    for (int i = 1; i <= ticks; ++i) {
      time_us_ += 1000;
      const double before_mm = depth_mm_;
      depth_mm_ = i == ticks && speed_mmps > 0 ? to_mm : from_mm + sign * speed_mmps * 1e-3 * i;
      sample();
      cross(before_mm, depth_mm_);
    }
  }

  void sample() {
    AttemptSample sample;
    sample.time_us = time_us_;
    if (probeHeld) sample.patientFromProbe = Transform{{}, {20, probe_y_mm, 0}};
    const Vec3 z = axis(), y{0, 1, 0};
    sample.patientFromNeedle = Transform{{{insonate::cross(y, z), y, z}}, tip()};
    if (inBody_) sample.needleDepth_mm = depth_mm_;
    sample.probeForce_N = probeHeld ? force_N : 0;
    sample.imageDepth_mm = probeHeld ? 40 : 0;
    sample.aspirating = aspirating;
    sample.toArtery_mm = toArtery_mm, sample.toVeinCenter_mm = toVeinCenter_mm;
    sample.wire_mm = wire_mm, sample.dilator_mm = dilator_mm, sample.catheter_mm = catheter_mm;
    sample.wireToHeart_mm = wireToHeart_mm, sample.catheterToHeart_mm = catheterToHeart_mm;
    stream.push_back(sample);
  }

  void cross(double before_mm, double now_mm) {
    one({kSkin, 0, 1e9}, before_mm, now_mm);
    for (const CrossedWall& wall : walls) one(wall, before_mm, now_mm);
    inBody_ = now_mm >= 0;
  }
  void one(const CrossedWall& wall, double before_mm, double now_mm) {
    const auto crossed = [&](double at_mm, bool down) {
      return down ? before_mm < at_mm && now_mm >= at_mm : before_mm >= at_mm && now_mm < at_mm;
    };
    using enum AttemptEventKind;
    if (crossed(wall.front_mm, true))
      event(wall.label == kBone ? Struck : Entered, wall.label, wall.label == kSkin ? kFat : wall.label, wall.front_mm,
            wall.vessel);
    if (crossed(wall.back_mm, true)) event(Left, wall.label, kFat, wall.back_mm, wall.vessel);
    if (crossed(wall.back_mm, false)) event(Withdrawn, wall.label, wall.label, wall.back_mm, wall.vessel);
    if (crossed(wall.front_mm, false) && wall.label != kBone)
      event(Withdrawn, wall.label, wall.label == kSkin ? kBackground : kFat, wall.front_mm, wall.vessel);
  }
  void event(AttemptEventKind kind, Label wall, Label into, double depth_mm, std::uint8_t vessel) {
    stream.push_back(AttemptEvent{.time_us = time_us_,
                                  .kind = kind,
                                  .wall = wall,
                                  .into = into,
                                  .vessel = vessel,
                                  .tip_mm = tip(),
                                  .axis = axis(),
                                  .depth_mm = depth_mm,
                                  .outward = wall == kSkin ? std::optional(Vec3{0, 0, -1}) : std::nullopt});
  }

  std::int64_t time_us_ = 0;
  double depth_mm_ = -5, y_mm_ = 0;
  bool inBody_ = false;
};

}  // namespace insonate::test
