#include "WebRig.h"

#include <insonate/curriculum/Retention.h>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebRetention : public OnBoth {};
INSONATE_ON_BOTH(WebRetention);

TEST_P(WebRetention, ARuleIsPreviewedAndThenSaved) {
  const WebSchool school(rig->open());
  rig->pass(100 * kDay_us);
  const std::string admin = school.signIn("admin");
  EXPECT_THAT(school.get("/people", admin).body, HasSubstr("href=\"/retention\""));
  const std::string unset = school.get("/retention", admin).body;
  EXPECT_THAT(unset, AllOf(HasSubstr("Trainees are never erased."), Not(HasSubstr("Save rule"))));
  const std::string preview = school.get("/retention?erase=3&recordings=", admin).body;
  EXPECT_THAT(preview, AllOf(HasSubstr("Trainees to be erased now: 3."), HasSubstr("Dr anna"), Not(HasSubstr("Dr ina")),
                             HasSubstr("Save rule")));
  EXPECT_EQ(valueOf(Retention(school.admin).rule()), RetentionRule{}) << "a preview changes nothing";
  EXPECT_EQ(headerOf(school.post("/retention", {{"erase", "3"}, {"recordings", "12"}}, admin), "Location"),
            "/retention");
  EXPECT_EQ(valueOf(Retention(school.admin).rule()), (RetentionRule{.erase_months = 3, .recording_months = 12}));
  EXPECT_THAT(school.get("/retention", admin).body, HasSubstr("Trainees are erased after 3 months without activity."));
  school.post("/retention", {{"erase", ""}, {"recordings", ""}}, admin);
  EXPECT_EQ(valueOf(Retention(school.admin).rule()), RetentionRule{});
}

TEST_P(WebRetention, WhatIsNoNumberOfMonthsIsRefused) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin");
  for (const std::string months : {"0", "-3", "1201", "3x", "<b>", "99999999999999999999"}) {
    EXPECT_EQ(school.get("/retention?erase=" + web::encoded(months), admin).status, 422) << months;
    const web::Response refused = school.post("/retention", {{"erase", months}, {"recordings", ""}}, admin);
    EXPECT_EQ(refused.status, 422) << months;
    EXPECT_THAT(refused.body, AllOf(HasSubstr("1 to 1200 months"), Not(HasSubstr("<b>"))));
  }
  EXPECT_EQ(valueOf(Retention(school.admin).rule()), RetentionRule{});
}

TEST_P(WebRetention, OthersChangeNoRule) {
  const WebSchool school(rig->open());
  for (const std::string who : {"anna", "ben", "carl", "ina", "otto"})
    EXPECT_EQ(school.post("/retention", {{"erase", "1"}}, school.signIn(who)).status, 403) << who;
  EXPECT_EQ(valueOf(Retention(school.admin).rule()), RetentionRule{});
}

}  // namespace
}  // namespace insonate::test
