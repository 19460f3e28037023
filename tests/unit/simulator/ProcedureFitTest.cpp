#include "support/AttemptBlock.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ProcedureFit.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using testing::HasSubstr;

Result<void> fits(const char* procedure, const PatientCase& patient) {
  return checkProcedureFits(*loadProcedure(procedure), patient);
}

TEST(ProcedureFit, ABuiltInNeckIsForOneProcedureAndSaysWhichForTheOther) {
  for (const std::string variant : {"textbook", "subclavian"}) {
    SCOPED_TRACE(variant);
    const auto neck = makePhantom(variant, 1);
    ASSERT_TRUE(neck) << neck.error().message;
    const bool chest = variant == "subclavian";
    EXPECT_TRUE(fits(chest ? "subclavian" : "internal_jugular", *neck));
    const auto other = fits(chest ? "internal_jugular" : "subclavian", *neck);
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().message,
                HasSubstr("does not fit the case '" + neck->manifest.title + "': the case is for '"));
    EXPECT_THAT(other.error().message, HasSubstr(chest ? "Choose 'Subclavian vein with ultrasound'"
                                                       : "Choose 'Internal jugular vein with ultrasound'"));
  }
}

TEST(ProcedureFit, EachRegionIsForItsProcedure) {
  for (const auto& [variant, procedure] : std::initializer_list<std::pair<const char*, const char*>>{
           {"arm", "basilic"}, {"axillary", "axillary"}, {"groin", "femoral"}, {"groin-thrombus", "femoral"}}) {
    const auto patient = makePhantom(variant, 1);
    ASSERT_TRUE(patient) << patient.error().message;
    for (const std::string& name : procedurePresetNames())
      EXPECT_EQ(fits(name.c_str(), *patient).has_value(), name == procedure || name == std::string(procedure) + "_line")
          << name << " on " << variant;
  }
}

TEST(ProcedureFit, ATargetMayBeNamedInAnotherLanguage) {
  auto neck = makePhantom("textbook", 1);
  ASSERT_TRUE(neck) << neck.error().message;
  for (const char* name : {"V. jugularis interna rechts", "veine jugulaire interne droite"}) {
    for (Target& target : neck->manifest.targets) target.name = name;
    EXPECT_TRUE(fits("internal_jugular", *neck)) << name;
    EXPECT_FALSE(fits("subclavian", *neck)) << name;
  }
}

TEST(ProcedureFit, WhatIsNotLabeledIsNamedWithWhatWouldBeLost) {
  PatientCase block = test::attemptBlock();  // its target, "vein", states no procedure
  for (const char* name : {"internal_jugular", "subclavian"}) EXPECT_TRUE(fits(name, block)) << name;
  const auto without = [&](Label label) {
    PatientCase less = block;
    for (std::uint8_t& voxel : less.labels.voxels)
      if (voxel == label) voxel = kSoftTissue;
    return less;
  };
  EXPECT_TRUE(fits("internal_jugular", without(kAirway)));
  EXPECT_THAT(fits("subclavian", without(kAirway)).error().message,
              HasSubstr("nothing is labeled airway and lung, so a pneumothorax would not be noticed."));
  EXPECT_THAT(fits("internal_jugular", without(kArtery)).error().message, HasSubstr("nothing is labeled artery"));
  EXPECT_THAT(fits("internal_jugular", without(kVein)).error().message, HasSubstr("nothing is labeled vein"));
}

TEST(ProcedureFit, AProcedureThatNeedsNothingFitsAnyCase) {
  EXPECT_TRUE(checkProcedureFits(Procedure{}, PatientCase{}));
}

}  // namespace
}  // namespace insonate
