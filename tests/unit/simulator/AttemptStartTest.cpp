#include <insonate/cases/Phantom.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/simulator/AttemptStart.h>
#include <insonate/simulator/NeedlePlacement.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ServoRecord.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace insonate {
namespace {

constexpr double kHalfWidth_mm = 19;

/// Standards that all levels with a procedure have in common.
struct Asked {
  bool check = true;  ///< the vein must have been centered and compressed
  double least_deg = 90, most_deg = 0, inImage_percent = 100;
};

Asked askedBy(const std::string& procedure) {
  Asked asked;
  const Curriculum curriculum = *loadCurriculum("central_line");
  for (const Level& level : curriculum.levels) {
    if (level.procedure != procedure) continue;
    Asked here{false, 0, 90, 0};
    for (const MetricStandard& standard : level.pass.standards) {
      if (standard.metric == "vein_checks") here.check = standard.critical;
      if (standard.metric == "tip_in_picture_percent") here.inImage_percent = *standard.minimum;
      if (standard.metric == "insertion_angle_deg" && standard.minimum) here.least_deg = *standard.minimum;
      if (standard.metric == "insertion_angle_deg" && standard.maximum) here.most_deg = *standard.maximum;
    }
    asked.check &= here.check;
    asked.least_deg = std::min(asked.least_deg, here.least_deg);
    asked.most_deg = std::max(asked.most_deg, here.most_deg);
    asked.inImage_percent = std::min(asked.inImage_percent, here.inImage_percent);
  }
  return asked;
}

struct Neck {
  explicit Neck(const std::string& variant, const std::string& procedure = "internal_jugular")
      : patient(*makePhantom(variant, 1)),
        home(*ProbePlacement::make(patient.labels, poseOfStart())),
        vessels(patient.manifest, *loadProcedure(procedure), home.pose().offset),
        target(patient.manifest.vessels[targetIndex()]),
        asked(askedBy(procedure)) {}

  Transform poseOfStart() const {
    const StartPose& start = patient.manifest.startPoses.front();
    return *patientFromProbe(start.position_mm, start.axial, start.lateral);
  }
  std::size_t targetIndex() const {
    const std::string name = vessels.names().front();
    const auto& all = patient.manifest.vessels;
    return static_cast<std::size_t>(std::ranges::find(all, name, &NamedVessel::name) - all.begin());
  }

  /// Distance from the middle line of the image to the center line of the target, and the vein's radius there.
  struct Off {
    double distance_mm = std::numeric_limits<double>::infinity(), radius_mm = 0;
  };
  Off off(const ProbePlacement& hand) const {
    Off least;
    for (double depth_mm = 0; depth_mm < 60; depth_mm += 0.5) {
      const Vec3 at_mm = hand.pose() * Vec3{0, 0, depth_mm};
      const double distance_mm = distanceToCenterLine_mm(target, at_mm);
      if (distance_mm < least.distance_mm) least = {distance_mm, distance_mm - distanceToWall_mm(target, at_mm)};
    }
    return least;
  }
  ProbePlacement startAt(int place, std::uint32_t seed) const {
    ProbePlacement hand = home;
    hand.restore(attemptStart(home, vessels, {}, place, seed));
    return hand;
  }

  PatientCase patient;
  ProbePlacement home;
  VesselLocator vessels;
  NamedVessel target;
  Asked asked;
};

TEST(AttemptStart, IsBesideTheVeinAndOnTheSkinAndVaries) {
  for (const char* variant : {"textbook", "small-vein", "deep-in-fat", "vein-over-artery"}) {
    SCOPED_TRACE(variant);
    const Neck neck(variant);
    std::set<double> places;
    for (int place = 0; place < kAttemptStarts; ++place)
      for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const ProbePlacement start = neck.startAt(place, seed);
        EXPECT_GE(neck.off(start).distance_mm, 9) << place << " " << seed;
        EXPECT_LT(neck.off(start).distance_mm, 50) << place << " " << seed;
        EXPECT_NEAR(start.state().press_mm, neck.home.state().press_mm, 1e-9);
        EXPECT_EQ(start.state(), neck.startAt(place, seed).state()) << "the same seed gives the same start";
        places.insert(start.state().skin_mm.x + start.state().skin_mm.z);
      }
    EXPECT_GE(places.size(), 14U);
  }
}

// Effect of keys on both hands, without looking.

enum class Key { Lateral, Elevation, Rotate, Tilt, Rock, Press, Take, Angle, Heading, Advance };
struct Stroke {
  Key key;
  double amount = 0;
};
using Keys = std::vector<Stroke>;

Keys anyKeys(std::mt19937& random) {
  const auto number = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  const auto sign = [&] { return number(0, 1) ? 1.0 : -1.0; };
  Keys keys;
  for (int i = number(30, 150); i > 0; --i) {
    const bool wide = number(0, 3) == 0;
    switch (number(0, 9)) {
      case 0:
      case 1:
        keys.push_back({Key::Lateral, sign() * (wide ? 5 : 1)});
        break;
      case 2:
        keys.push_back({Key::Elevation, sign() * (wide ? 5 : 1)});
        break;
      case 3:
        keys.push_back({Key::Rotate, sign() * (wide ? 10 : 2)});
        break;
      case 4:
        keys.push_back({number(0, 1) ? Key::Tilt : Key::Rock, sign() * (wide ? 5 : 1)});
        break;
      case 5:
      case 6:
        keys.push_back({Key::Press, sign() * 2});
        break;
      case 7:
        keys.push_back({number(0, 4) == 0 ? Key::Take : Key::Advance, 5});
        break;
      case 8:
        keys.push_back({Key::Angle, wide ? 5.0 : 1.0});
        break;
      default:
        keys.push_back({Key::Advance, wide ? 5.0 : 1.0});
    }
  }
  return keys;
}

/// In the order of somebody who knows what to do, but does not look.
Keys plannedKeys(std::mt19937& random) {
  const auto number = [&](int low, int high) {
    return static_cast<double>(std::uniform_int_distribution(low, high)(random));
  };
  const double press_mm = number(2, 16);
  return {{Key::Lateral, number(-35, 35)}, {Key::Elevation, number(-15, 15)}, {Key::Rotate, number(-20, 20)},
          {Key::Press, press_mm},          {Key::Press, -press_mm},           {Key::Take},
          {Key::Angle, number(0, 40)},     {Key::Advance, number(20, 60)}};
}

/// Tells whether the needle has met neither artery, lung nor bone.
bool isHarmless(const Neck& neck, const NeedlePlacement& needle) {
  constexpr double kStep_mm = 0.5;
  const auto& labels = neck.patient.labels;
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  const Transform patientFromNeedle = needle.patientFromNeedle();
  for (double back_mm = 0; back_mm < needle.state().advance_mm; back_mm += kStep_mm) {
    const Vec3 at = indexFromPatient * (patientFromNeedle * Vec3{0, 0, -back_mm});
    const int i = int(std::lround(at.x)), j = int(std::lround(at.y)), k = int(std::lround(at.z));
    if (!labels.geometry.contains(i, j, k)) continue;
    const std::uint8_t label = labels.at(i, j, k);
    if (label == kArtery || label == kAirway || label == kBone) return false;
  }
  return true;
}

/// Steps of the needle under the skin, and how many of them leave the tip in the image.
struct Sight {
  int steps = 0, seen = 0;
  double percent() const { return steps ? 100.0 * seen / steps : 0; }
};

void advance(NeedlePlacement& needle, const ProbePlacement& probe, double by_mm, Sight& sight) {
  static const ImageField field = imageFieldOf(*loadProbe("linear"));
  constexpr double kStep_mm = 0.5, kDepth_mm = 40;
  for (double left_mm = by_mm; left_mm > 0; left_mm -= kStep_mm) {
    needle.advance(std::min(left_mm, kStep_mm));
    if (!needle.isInBody()) continue;
    ++sight.steps;
    sight.seen += isTipInView(field, kDepth_mm, inverted(probe.pose()) * needle.patientFromNeedle().offset);
  }
}

/// Tells whether these keys could pass: the tip ends in the vein's lumen without harm, and at most one of the standards
/// that need not be met is missed. Generous, since tissue is taken at rest, and since the standards of
/// passes and aspiration count as met: more lists pass here than in an attempt.
bool couldPass(const Neck& neck, ProbePlacement probe, const Keys& keys) {
  constexpr double kSpare_mm = 1, kMinPress_mm = 2;
  Sight sight;
  bool isFound = false;
  std::optional<NeedlePlacement> needle;
  for (const auto& [key, amount] : keys) {
    if (key == Key::Lateral) probe.slide(amount, 0);
    if (key == Key::Elevation) probe.slide(0, amount);
    if (key == Key::Rotate) probe.rotate(amount);
    if (key == Key::Tilt) probe.tilt(amount);
    if (key == Key::Rock) probe.rock(amount);
    if (key == Key::Press) probe.press(amount);
    if (key == Key::Press && amount > 0 && probe.state().press_mm - neck.home.state().press_mm > kMinPress_mm) {
      const Neck::Off off = neck.off(probe);
      isFound |= off.distance_mm < 0.6 * off.radius_mm + 0.5;
    }
    if (key == Key::Take) needle = NeedlePlacement::makeBeside(probe, kHalfWidth_mm, NeedlePlane::InPlane, {});
    if (!needle) continue;
    if (key == Key::Angle) needle->tilt(amount);
    if (key == Key::Heading) needle->turn(amount);
    if (key == Key::Advance) advance(*needle, probe, amount, sight);
  }
  if (!needle || !needle->isInBody() ||
      distanceToWall_mm(neck.target, needle->patientFromNeedle().offset) >= kSpare_mm || !isHarmless(neck, *needle))
    return false;
  if (neck.asked.check && !isFound) return false;
  const double angle_deg = needle->state().angle_deg;
  const bool isAngleMet = angle_deg >= neck.asked.least_deg && angle_deg <= neck.asked.most_deg;
  return isAngleMet || sight.percent() >= neck.asked.inImage_percent;
}

/// Keys that used to master the first level: take the needle, push it in.
TEST(AttemptStart, TheNeedleIsNotAimedAtTheVein) {
  const Neck neck("textbook");
  Keys keys{{Key::Press, 4}, {Key::Press, -4}, {Key::Take}};
  for (int i = 0; i < 60; ++i) {
    keys.push_back({Key::Advance, 1});
    EXPECT_FALSE(couldPass(neck, neck.home, keys)) << i << ": even from the case's own start";
    for (int place = 0; place < kAttemptStarts; ++place) EXPECT_FALSE(couldPass(neck, neck.startAt(place, 7), keys));
  }
}

/// On the other regions, too, an attempt begins beside the vein, and its needle is aimed at another place.
TEST(AttemptStart, InGroinAndArmTheVeinHasToBeFound) {
  for (const auto& [variant, procedure] : std::initializer_list<std::pair<const char*, const char*>>{
           {"arm", "basilic"}, {"axillary", "axillary"}, {"groin", "femoral"}, {"groin-obese", "femoral"}}) {
    SCOPED_TRACE(variant);
    const Neck region(variant, procedure);
    Keys keys{{Key::Press, 4}, {Key::Press, -4}, {Key::Take}};
    for (int i = 0; i < 60; ++i) {
      keys.push_back({Key::Advance, 1});
      for (int place = 0; place < kAttemptStarts; ++place) {
        const ProbePlacement start = region.startAt(place, 7);
        if (i == 0) {
          EXPECT_GT(region.off(start).distance_mm, 8) << place;
        }
        EXPECT_FALSE(couldPass(region, start, keys)) << i;
      }
    }
  }
}

using CaseAndProcedure = std::pair<std::string, std::string>;

/// The cases and procedures of all levels, each pair once.
std::set<CaseAndProcedure> exercises() {
  const Curriculum curriculum = *loadCurriculum("central_line");
  std::set<CaseAndProcedure> all;
  for (const Level& level : curriculum.levels) all.emplace(level.caseName, level.procedure);
  return all;
}

class BlindKeys : public testing::TestWithParam<CaseAndProcedure> {};

/// An attempt never begins where the last one did, so that a list which passes from one place only masters no level.
TEST_P(BlindKeys, PassNotTwice) {
  const auto& [variant, procedure] = GetParam();
  std::mt19937 random(1);
  std::vector<Keys> lists;
  for (int i = 0; i < 100; ++i) lists.push_back(anyKeys(random)), lists.push_back(plannedKeys(random));
  const Neck neck(variant, procedure);
  std::vector<std::pair<int, ProbePlacement>> starts;
  for (int place = 0; place < kAttemptStarts; ++place)
    for (std::uint32_t seed = 1; seed <= 4; ++seed) starts.emplace_back(place, neck.startAt(place, seed));
  int once = 0, twice = 0;
  for (const Keys& list : lists) {
    std::set<int> passes;
    for (const auto& [place, start] : starts)
      if (couldPass(neck, start, list)) passes.insert(place);
    once += passes.size() == 1;
    twice += passes.size() > 1;
  }
  std::cout << once << " of " << lists.size() << " lists could pass from one of " << kAttemptStarts << " places, "
            << twice << " from several\n";
  // Below the clavicle and at the axilla, the skin ends near the vein: a probe that is pushed to the edge comes to the
  // same place from several starts.
  EXPECT_LE(twice, procedure == "subclavian" || procedure == "axillary" ? 2 : 0);
}

INSTANTIATE_TEST_SUITE_P(Levels, BlindKeys, testing::ValuesIn(exercises()), [](const auto& one) {
  std::string name = one.param.first + "_" + one.param.second;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

/// The test above can fail: somebody who looks passes everywhere.
TEST(AttemptStart, WhoLooksPassesFromEachStart) {
  const Neck neck("textbook");
  for (int place = 0; place < kAttemptStarts; ++place) {
    const ProbePlacement start = neck.startAt(place, 3);
    Keys keys;
    ProbePlacement probe = start;
    const auto best = [&](Key key) {
      double least = 0;
      const auto off = [&](double mm) {
        ProbePlacement there = probe;
        key == Key::Lateral ? there.slide(mm, 0) : there.slide(0, mm);
        return neck.off(there).distance_mm;
      };
      for (double mm = -50; mm <= 50; mm += 1)
        if (off(mm) < off(least)) least = mm;
      keys.push_back({key, least});
      key == Key::Lateral ? probe.slide(least, 0) : probe.slide(0, least);
    };
    best(Key::Lateral);
    keys.insert(keys.end(), {{Key::Press, 8}, {Key::Press, -8}, {Key::Take}});
    bool passes = false;
    for (double angle_deg = 10; angle_deg <= 35 && !passes; angle_deg += 5)
      for (double advance_mm = 20; advance_mm <= 50 && !passes; advance_mm += 2) {
        Keys all = keys;
        all.push_back({Key::Angle, angle_deg}), all.push_back({Key::Advance, advance_mm});
        passes = couldPass(neck, start, all);
      }
    EXPECT_TRUE(passes) << place;
  }
}

}  // namespace
}  // namespace insonate
