#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ScriptedSession.h>

#include <gmock/gmock.h>

#include <map>
#include <set>

namespace insonate {
namespace {

/// Outcome of a built-in script, on the case that it is for.
struct Outcome {
  const char* script;
  std::vector<std::string> events;
  NeedlePlace color;  ///< as it ends: green in the vein, red in a wrong place, yellow once used
  bool succeeds;
  std::set<std::string> rules;  ///< that were broken
  AttemptStatus status = AttemptStatus::Completed;
};

using enum NeedlePlace;
const std::vector<Outcome> kOnTheTextbookNeck{
    {"clean-success",
     {"tilt", "entered skin", "entered vein", "frozen", "released", "withdrawn vein", "withdrawn skin", "new"},
     Clean,
     true,
     {}},
    {"posterior-wall",
     {"tilt", "entered skin", "entered vein", "left vein", "withdrawn vein"},
     Vein,
     true,
     {"back wall"}},
    {"carotid-puncture",
     {"tilt", "entered skin", "entered artery", "withdrawn artery", "withdrawn skin"},
     Used,
     false,
     {"artery"},
     AttemptStatus::Abandoned},
    {"used-needle",
     {"tilt", "entered skin", "withdrawn skin", "entered skin", "entered vein"},
     Vein,
     true,
     {"used needle"}},
    {"two-passes", {"tilt", "entered skin", "withdrawn skin", "new", "entered skin", "entered vein"}, Vein, true, {}},
    {"abandoned", {"tilt", "entered skin", "withdrawn skin"}, Used, false, {}, AttemptStatus::Abandoned},
    {"never-in-picture", {"tilt", "entered skin", "entered vein"}, Vein, true, {}},
    {"bone",
     {"tilt", "entered skin", "struck bone", "withdrawn skin"},
     Used,
     false,
     {"bone", "steep"},
     AttemptStatus::Abandoned},
    {"probe-lifted", {"tilt", "entered skin", "entered vein"}, Vein, true, {}},
    // The thesis's figures.
    {"figure-16", {"tilt"}, Clean, false, {}},
    {"figure-17", {}, Clean, false, {}},
    {"figure-18", {"tilt", "entered skin", "entered vein"}, Vein, true, {}},
    {"figure-19", {"tilt", "entered skin", "entered vein"}, Vein, true, {}},
    {"figure-20", {"tilt", "entered skin", "entered vein", "frozen"}, Vein, true, {}},
    {"figure-22", {"tilt", "entered skin", "entered vein"}, Vein, true, {}},
    {"figure-23", {"tilt", "entered skin", "entered artery"}, WrongPlace, false, {"artery"}},
    {"figure-24", {"tilt", "entered skin", "entered vein", "withdrawn vein", "withdrawn skin"}, Used, true, {}},
    {"figure-25", {"tilt", "entered skin", "entered vein"}, Vein, true, {}},
    {"figure-26", {"tilt", "entered skin", "entered vein", "left vein"}, WrongPlace, false, {"back wall"}},
    {"figure-27", {"tilt", "entered skin", "entered vein", "withdrawn vein"}, UnderSkin, true, {}}};
const std::vector<std::string> kNeedleOverWire{"tilt", "entered skin", "entered vein", "withdrawn vein",
                                               "withdrawn skin"};
const std::vector<Outcome> kWholeLine{
    {"line-success", kNeedleOverWire, Used, true, {}},
    {"line-unseen-wire", kNeedleOverWire, Used, false, {"dilated unseen"}},
    {"line-carotid",
     {"tilt", "entered skin", "entered artery", "withdrawn artery", "withdrawn skin"},
     Used,
     false,
     {"artery", "dilated unseen", "dilated artery", "dilator deep", "preparation"}},
    {"line-back-wall",
     {"tilt", "entered skin", "entered vein", "left vein"},
     WrongPlace,
     false,
     {"back wall", "preparation"}},
    {"line-kink",
     {"tilt", "entered skin", "entered vein", "left vein"},
     WrongPlace,
     false,
     {"back wall", "preparation", "wire kinked"}},
    {"line-tachycardia",
     {"tilt", "entered skin", "entered vein"},
     Vein,
     false,
     {"extra beats", "tachycardia", "wire deep"}},
    {"line-air", {"tilt", "entered skin", "entered vein"}, Vein, false, {"air", "open hub"}},
    {"line-wire-in-heart", {"tilt", "entered skin", "entered vein"}, Vein, false, {"extra beats", "wire deep"}},
    {"line-wire-lost",
     kNeedleOverWire,
     Used,
     false,
     {"extra beats", "tachycardia", "wire deep", "wire not held", "wire lost"}},
    {"line-wire-not-held", kNeedleOverWire, Used, false, {"wire not held", "wire deep"}},
    {"line-dilator-deep", kNeedleOverWire, Used, false, {"dilator deep"}},
    {"line-traps", kNeedleOverWire, Used, true, {"blood color", "flushed first"}}};
const std::vector<Outcome> kBelowTheClavicle{
    {"subclavian-success", {"tilt", "entered skin", "entered vein"}, Vein, true, {}},
    {"pneumothorax",
     {"tilt", "entered skin", "entered vein", "left vein", "entered airway and lung", "withdrawn airway and lung",
      "withdrawn vein", "withdrawn vein", "withdrawn skin"},
     Used,
     false,
     {"lung", "near the lung", "back wall", "steep"},
     AttemptStatus::Abandoned}};

const std::vector<Outcome> kOnArm{{"basilic-success", {"entered skin", "entered vein"}, Vein, true, {}},
                                  {"basilic-artery",
                                   {"entered skin", "entered artery", "withdrawn artery", "withdrawn skin"},
                                   Used,
                                   false,
                                   {"artery"},
                                   AttemptStatus::Abandoned}};
const std::vector<Outcome> kAxillary{{"axillary-success", {"tilt", "entered skin", "entered vein"}, Vein, true, {}},
                                     {"axillary-artery",
                                      {"tilt", "entered skin", "entered artery", "withdrawn artery", "withdrawn skin"},
                                      Used,
                                      false,
                                      {"artery", "steep"},
                                      AttemptStatus::Abandoned}};
const std::vector<Outcome> kInGroin{
    {"femoral-success", {"entered skin", "entered vein"}, Vein, true, {}},
    {"femoral-line", {"entered skin", "entered vein", "withdrawn vein", "withdrawn skin"}, Used, true, {}},
    {"femoral-artery",
     {"entered skin", "entered artery", "withdrawn artery", "withdrawn skin"},
     Used,
     false,
     {"artery"},
     AttemptStatus::Abandoned}};

std::vector<std::string> told(const SessionOutcome& outcome) {
  static const char* const kNames[]{"entered", "left", "withdrawn", "struck", "new", "frozen", "released", "tilt"};
  std::vector<std::string> names;
  for (const AttemptEvent& event : outcome.events)
    names.push_back(std::string(kNames[static_cast<int>(event.kind)]) +
                    (event.kind <= AttemptEventKind::Struck ? " " + std::string(labelTable()[event.wall].name) : ""));
  return names;
}

class ScriptLibrary : public testing::Test {
 protected:
  SessionOutcome play(const char* name, const PatientCase& patient) {
    const auto script = loadSessionScript(name, patient);
    if (!script) throw std::runtime_error(script.error().message);
    auto outcome = runSession(*script, patient, "insonate test", folder / name, {});
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
  }
  std::map<std::string, SessionOutcome> expectAll(const std::vector<Outcome>& all, const PatientCase& patient) {
    std::map<std::string, SessionOutcome> played;
    for (const Outcome& expected : all) {
      SCOPED_TRACE(expected.script);
      SessionOutcome outcome = play(expected.script, patient);
      // Figures 16 and 17 describe how the vein was found.
      const auto isOfFinding = [](const AttemptEvent& event) { return event.kind >= AttemptEventKind::Centered; };
      for (const AttemptEvent& event : outcome.events)
        if (isOfFinding(event)) found.emplace(expected.script, event.kind);
      std::erase_if(outcome.events, isOfFinding);
      EXPECT_EQ(outcome.status, expected.status);
      EXPECT_EQ(told(outcome), expected.events);
      EXPECT_EQ(outcome.run.metrics().needle(), expected.color);
      EXPECT_EQ(outcome.run.succeeded(), expected.succeeds);
      std::set<std::string> rules;
      for (const ProcedureRun::Finding& finding : outcome.run.findings())
        rules.insert(outcome.run.procedure().rules[finding.rule].name);
      EXPECT_EQ(rules, expected.rules);
      played.emplace(expected.script, std::move(outcome));
    }
    return played;
  }

  const test::TemporaryFolder folder;
  std::set<std::pair<std::string, AttemptEventKind>> found;
};

TEST_F(ScriptLibrary, EachScriptIsExpectedSomewhere) {
  std::vector<std::string> expected;
  for (const auto* outcomes : {&kOnTheTextbookNeck, &kWholeLine, &kBelowTheClavicle, &kOnArm, &kAxillary, &kInGroin})
    for (const Outcome& outcome : *outcomes) expected.emplace_back(outcome.script);
  EXPECT_THAT(sessionScriptNames(), testing::UnorderedElementsAreArray(expected));
}

TEST_F(ScriptLibrary, TheWholeLineOnTheTextbookNeck) {
  const auto patient = makePhantom("textbook", 1);
  ASSERT_TRUE(patient);
  expectAll(kWholeLine, *patient);
}

TEST_F(ScriptLibrary, OnTheTextbookNeck) {
  const auto patient = makePhantom("textbook", 1);
  ASSERT_TRUE(patient);
  const auto played = expectAll(kOnTheTextbookNeck, *patient);

  // Figures 25 to 27: the hole of the first puncture is d1; behind it the back wall, and the way out at d1 again.
  const auto depth = [&](const char* script, std::size_t event) { return played.at(script).events.at(event).depth_mm; };
  const double d1_mm = depth("figure-25", 2);
  EXPECT_GT(d1_mm, 10);
  EXPECT_NEAR(depth("figure-26", 2), d1_mm, 0.01);
  EXPECT_GT(depth("figure-26", 3), d1_mm + 10) << "the vein is 12 mm wide along the needle";
  EXPECT_NEAR(depth("figure-27", 3), d1_mm, 0.01);
  EXPECT_EQ(played.at("figure-26").metrics[Metric::PosteriorWallPunctures], 1);
  EXPECT_EQ(played.at("figure-27").metrics[Metric::PosteriorWallPunctures], 0);

  EXPECT_TRUE(found.contains({"figure-16", AttemptEventKind::Centered})) << "locating the vein";
  EXPECT_TRUE(found.contains({"figure-17", AttemptEventKind::Compressed})) << "compression";

  // Figures 18 and 19: across the image only a spot is seen, as it passes; in its plane the whole way.
  EXPECT_EQ(played.at("figure-18").metrics[Metric::TipInImage], 0);
  EXPECT_GT(*played.at("figure-19").metrics[Metric::TipInImage], 99.9);
}

TEST_F(ScriptLibrary, OnArmAndGroinAndTheAxillaryVein) {
  expectAll(kOnArm, *makePhantom("arm", 1));
  expectAll(kAxillary, *makePhantom("axillary", 1));
  expectAll(kInGroin, *makePhantom("groin", 1));
}

TEST_F(ScriptLibrary, BelowTheClavicle) {
  const auto patient = makePhantom("subclavian", 1);
  ASSERT_TRUE(patient);
  const auto played = expectAll(kBelowTheClavicle, *patient);
  EXPECT_EQ(played.at("pneumothorax").metrics[Metric::Pneumothoraces], 1);
  EXPECT_EQ(played.at("subclavian-success").metrics[Metric::Pneumothoraces], 0);
}

}  // namespace
}  // namespace insonate
