#include "WebRig.h"

#include <insonate/curriculum/CommentStore.h>

#include <filesystem>
#include <fstream>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// The address in the link with these words; "" if there is none.
std::string linkTo(const std::string& page, const std::string& words) {
  const std::size_t end = page.find("\">" + words + "</a>");
  if (end == std::string::npos) return {};
  const std::size_t begin = page.rfind("href=\"", end) + 6;
  std::string address = page.substr(begin, end - begin);
  for (std::size_t at = address.find("&amp;"); at != std::string::npos; at = address.find("&amp;"))
    address.replace(at, 5, "&");
  return address.substr(0, address.find('#'));
}

class WebAttemptList : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    std::filesystem::create_directories(rig->services.recordings);
    school.emplace(rig->open());
    curriculum = valueOf(loadCurriculum("central_line"));
    member = "/classes/" + school->spring.id + "/people/" + school->anna.id;
  }
  AttemptFacts attemptAt(const std::string& level) const {
    AttemptFacts facts = begunFacts();
    facts.curriculumVersion = curriculum.version, facts.level = level;
    if (level.empty()) facts.curriculum.clear(), facts.curriculumVersion = 0;
    return facts;
  }
  std::string open(const std::string& address, const std::string& secret) const {
    return school->get(address, secret).body;
  }

  std::optional<WebSchool> school;
  Curriculum curriculum;
  std::string member;
};
INSONATE_ON_BOTH(WebAttemptList);

TEST_P(WebAttemptList, AllAttemptsAreReachedPageByPage) {
  const SignedIn anna = school->as(school->anna);
  for (int i = 0; i < 219; ++i) keepAttempt(anna, attemptAt(i % 2 == 0 ? "" : curriculum.levels[0].name));
  const std::string ina = school->signIn("ina");
  std::string page = open(member, ina);
  EXPECT_EQ(countOf(page, "href=\"/attempts/"), 100U);
  EXPECT_EQ(linkTo(page, "Newest attempts"), "") << "this is the first page";
  const std::string second = linkTo(page, "Earlier attempts");
  ASSERT_NE(second, "");
  page = open(second, ina);
  EXPECT_EQ(countOf(page, "href=\"/attempts/"), 100U);
  EXPECT_EQ(linkTo(page, "Newest attempts"), member);
  page = open(linkTo(page, "Earlier attempts"), ina);
  EXPECT_EQ(countOf(page, "href=\"/attempts/"), 20U);
  EXPECT_THAT(page, HasSubstr("/attempts/" + school->annas)) << "the first attempt of all";
  EXPECT_EQ(linkTo(page, "Earlier attempts"), "");
}

TEST_P(WebAttemptList, AUserChoosesTheLevelWhoseAttemptsAreListed) {
  const SignedIn anna = school->as(school->anna);
  for (int i = 0; i < 105; ++i) keepAttempt(anna, attemptAt(""));
  const std::string level = keepAttempt(anna, attemptAt(curriculum.levels[1].name)).id, ina = school->signIn("ina");
  EXPECT_THAT(open(member, ina), HasSubstr("<option value=\"*\" selected=\"\">All attempts</option>"));
  const std::string chosen = open(member + "?attempts=" + curriculum.levels[1].name, ina);
  EXPECT_EQ(countOf(chosen, "href=\"/attempts/"), 1U);
  EXPECT_THAT(chosen, HasSubstr("/attempts/" + level));
  const std::string free = open(member + "?attempts=&metric=points", ina);
  EXPECT_EQ(countOf(free, "href=\"/attempts/"), 100U);
  EXPECT_THAT(free, HasSubstr("<input type=\"hidden\" name=\"attempts\" value=\"\""))
      << "the choice of the chart keeps that of the list";
  const std::string earlier = linkTo(free, "Earlier attempts");
  EXPECT_THAT(earlier, AllOf(HasSubstr("attempts="), HasSubstr("metric=points"))) << "and so do links";
  EXPECT_EQ(countOf(open(earlier, ina), "href=\"/attempts/"), 5U);
  EXPECT_THAT(open(member + "?attempts=unknown", ina), HasSubstr("There are no such attempts."));
  EXPECT_EQ(countOf(open(member + "?before=x", ina), "href=\"/attempts/"), 100U) << "no number";
}

TEST_P(WebAttemptList, EachAttemptHasItsRecordingFormsAndComments) {
  const std::string anna = school->signIn("anna"), ina = school->signIn("ina");
  EXPECT_THAT(open(member, ina), HasSubstr("<td>on ward 7</td>"));
  std::ofstream(rig->services.recordings / (school->annas + ".attempt")) << "a recording";
  EXPECT_THAT(open(member, ina), AllOf(HasSubstr("<td>on the server</td>"), Not(HasSubstr("unread by trainee"))));
  valueOf(CommentStore(school->as(school->ina)).add(school->annas, 0, "Hold still."));
  EXPECT_THAT(open(member, ina), HasSubstr("<td>1, 1 unread by trainee</td>"));
  EXPECT_THAT(open("/me", anna), HasSubstr("<td>1, 1 unread</td>"));
  (void)open("/attempts/" + school->annas, anna);
  EXPECT_THAT(open(member, ina), AllOf(HasSubstr("<td>1</td>"), Not(HasSubstr("unread by trainee"))))
      << "anna has read it";
}

TEST_P(WebAttemptList, OnlyInstructorsSeeWhyAnAttemptNeedsAttention) {
  const SignedIn anna = school->as(school->anna);
  AttemptFacts begun = attemptAt(curriculum.levels[0].name);
  AttemptFacts facts = endedFacts(begun);
  facts.length_us = 5 * kSecond_us, facts.proof = AttemptProof::Unproven;
  valueOf(AttemptStore(anna).begin(facts));
  succeed(AttemptStore(anna).end(facts));
  const std::string page = open(member, school->signIn("ina"));
  EXPECT_THAT(page, AllOf(HasSubstr("\u25b2 "), HasSubstr("implausibly short"), HasSubstr("not proven")));
  EXPECT_THAT(open("/me", school->signIn("anna")), Not(HasSubstr("implausibly short")));
  const std::string classPage = open("/classes/" + school->spring.id, school->signIn("ina"));
  EXPECT_THAT(classPage, AllOf(HasSubstr("implausible attempt"), HasSubstr("/attempts/" + facts.id + "?class=")))
      << "the class leads to the attempt";
}

}  // namespace
}  // namespace insonate::test
