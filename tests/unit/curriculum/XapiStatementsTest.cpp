#include "AttemptMaker.h"
#include "support/TestData.h"

#include <insonate/curriculum/XapiStatements.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace insonate {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const XapiSite kSite{"https://training.example.org/", false};

Person ada() {
  return {"p", "ada", "Ada Lovelace", "ada@example.org"};
}

AttemptFacts attempt() {
  AttemptFacts facts = test::passedAttempt("a");
  facts.begun_us = test::kNoon_us + 250'000;
  facts.length_us = 83'456'789;
  facts.points = 87.5;
  facts.metrics = {{"passes", 1, 1}, {"time_to_vein_s", 1, std::nullopt}, {"odd id/\xC3\xA4", 2, 0.5}};
  return facts;
}

std::vector<json> statementsOf(const std::vector<AttemptFacts>& attempts, const XapiSite& site = kSite) {
  const auto texts = xapiStatements(site, test::courseOf({test::levelNamed("a", 1)}), ada(), attempts);
  EXPECT_TRUE(texts) << (texts ? "" : texts.error().message);
  std::vector<json> statements;
  if (texts)
    for (const std::string& text : texts->statements) statements.push_back(json::parse(text));
  return statements;
}

bool holdsNull(const json& value) {
  if (value.is_null()) return true;
  return value.is_structured() && std::any_of(value.begin(), value.end(), holdsNull);
}

TEST(XapiStatements, APassedAttempt) {
  const json s = statementsOf({attempt()}).at(0);
  EXPECT_EQ(s["verb"]["id"], "http://adlnet.gov/expapi/verbs/passed");
  EXPECT_EQ(s["actor"]["account"], (json{{"homePage", "https://training.example.org"}, {"name", "p"}}));
  EXPECT_FALSE(s["actor"].contains("mbox"));
  EXPECT_EQ(s["object"]["id"], "https://training.example.org/curricula/course/1/a");
  EXPECT_EQ(s["result"]["score"]["scaled"], 0.875);
  EXPECT_EQ(s["result"]["success"], true);
  EXPECT_EQ(s["result"]["completion"], true);
  EXPECT_EQ(s["result"]["duration"], "PT83.45S");
  EXPECT_EQ(s["timestamp"], "2026-11-22T12:01:23.706Z");  // 12:00:00.250 + 83.456 s
  const json& extensions = s["result"]["extensions"];
  EXPECT_EQ(extensions["https://training.example.org/metrics/passes/1"], 1);
  EXPECT_EQ(extensions["https://training.example.org/metrics/odd%20id%2F%C3%A4/2"], 0.5);
  EXPECT_EQ(extensions.size(), 3U);  // and the critical errors; the missing time is left out
  EXPECT_FALSE(holdsNull(s));
}

TEST(XapiStatements, IdsAreVersion5AndStable) {
  const std::string id = statementsOf({attempt()}).at(0)["id"];
  EXPECT_THAT(id, testing::MatchesRegex("[0-9a-f]+-[0-9a-f]+-5[0-9a-f]+-[89ab][0-9a-f]+-[0-9a-f]+"));
  EXPECT_EQ(id.size(), 36U);
  EXPECT_EQ(statementsOf({attempt()}).at(0)["id"], id);
  AttemptFacts other = attempt();
  other.id = "2c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa";
  EXPECT_NE(statementsOf({other}).at(0)["id"], id);
  EXPECT_NE(statementsOf({attempt()}, {"https://elsewhere.example.org", false}).at(0)["id"], id);
  // By RFC 4122: SHA-1 of the URL name space with the home page, then of that with the attempt's id.
  EXPECT_EQ(id, "11776320-f362-5654-9777-f2fb816aca47");
}

TEST(XapiStatements, FailedAbandonedAndPractice) {
  AttemptFacts failed = attempt(), abandoned = attempt(), practice = attempt();
  failed.criticalErrors = 1;
  abandoned.state = AttemptState::Abandoned;
  practice.curriculum = practice.level = "";
  const auto s = statementsOf({failed, abandoned, practice});
  ASSERT_EQ(s.size(), 3U);
  EXPECT_EQ(s[0]["verb"]["id"], "http://adlnet.gov/expapi/verbs/failed");
  EXPECT_EQ(s[0]["result"]["success"], false);
  EXPECT_EQ(s[1]["verb"]["id"], "https://w3id.org/xapi/adl/verbs/abandoned");
  EXPECT_FALSE(s[1]["result"].contains("score")) << "as in the window";
  EXPECT_EQ(s[1]["result"]["completion"], false);
  EXPECT_EQ(s[2]["verb"]["id"], "http://adlnet.gov/expapi/verbs/completed");
  EXPECT_EQ(s[2]["object"]["id"], "https://training.example.org/practice/line");
  EXPECT_FALSE(s[2]["context"].contains("contextActivities"));
}

TEST(XapiStatements, AVoidedAttemptVoidsItsStatement) {
  AttemptFacts voided = attempt();
  voided.state = AttemptState::Voided;
  const json s = statementsOf({voided}).at(0);
  EXPECT_EQ(s["verb"]["id"], "http://adlnet.gov/expapi/verbs/voided");
  EXPECT_EQ(s["object"], (json{{"objectType", "StatementRef"}, {"id", statementsOf({attempt()}).at(0)["id"]}}));
  EXPECT_NE(s["id"], s["object"]["id"]);
}

TEST(XapiStatements, WhatIsLeftOutIsToldWithItsReason) {
  std::vector<AttemptFacts> attempts(7, attempt());
  for (std::size_t i = 0; i < attempts.size(); ++i) attempts[i].id = "attempt " + std::to_string(i);
  attempts[0].person = "q";
  attempts[1].state = AttemptState::Open;
  attempts[2].curriculum = "another";
  attempts[3].curriculumVersion = 2;
  attempts[4].level = "z";
  attempts[5].state = AttemptState::Abandoned, attempts[5].metrics = {{"passes", 1, 0}};
  attempts[6].curriculumVersion = 2;
  const auto made = xapiStatements(kSite, test::courseOf({test::levelNamed("a", 1)}), ada(), attempts);
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->statements.empty());
  ASSERT_EQ(made->leftOut.size(), 6U) << "another person's is not theirs to leave out";
  EXPECT_EQ(made->leftOut[0].attempt, "attempt 1");
  EXPECT_EQ(leftOutSentence(made->leftOut),
            "Left out: 6 attempts (1 abandoned before the skin was punctured; 1 not ended; 1 of the curriculum "
            "'another'; 1 of the "
            "level 'z', which the curriculum lacks; 2 of version 2 of the curriculum).");
  EXPECT_EQ(leftOutSentence({}), "");
}

TEST(XapiStatements, ARecordingThatBrokeOffIsAbandoned) {
  AttemptFacts broken = attempt();
  broken.state = AttemptState::Abandoned, broken.metrics.clear(), broken.points.reset();
  const json s = statementsOf({broken}).at(0);
  EXPECT_EQ(s["verb"]["id"], "https://w3id.org/xapi/adl/verbs/abandoned");
  EXPECT_EQ(s["result"]["success"], false);
}

TEST(XapiStatements, ALevelsActivityTellsItsAssistance) {
  Level level = test::levelNamed("a", 1);
  level.assistance = Assistance::Hints;
  const auto made = xapiStatements(kSite, test::courseOf({level}), ada(), std::vector<AttemptFacts>{attempt()});
  ASSERT_TRUE(made);
  EXPECT_EQ(json::parse(made->statements.at(0))["object"]["definition"]["extensions"],
            (json{{"https://training.example.org/assistance", "hints"}}));
}

/// A learning record store would take it for passed.
TEST(XapiStatements, APassThatNothingProvesIsLeftOutUntilItIsAccepted) {
  AttemptFacts passed = attempt();
  passed.proof = AttemptProof::Unproven;
  EXPECT_TRUE(statementsOf({passed}).empty());
  passed.proof = AttemptProof::Accepted;
  EXPECT_EQ(statementsOf({passed}).size(), 1u);
  passed.proof = AttemptProof::Unproven, passed.succeeded = false;
  EXPECT_EQ(statementsOf({passed}).at(0)["verb"]["id"], "http://adlnet.gov/expapi/verbs/failed");
}

TEST(XapiStatements, ATestThatWasNotOpenIsLeftOut) {
  Level level = test::levelNamed("a", 1);
  level.assistance = Assistance::Test;
  AttemptFacts taken = attempt();
  const auto made = [&](TestConditions testConditions) {
    taken.testConditions = testConditions;
    return xapiStatements(kSite, test::courseOf({level}), ada(), std::vector{taken}).value();
  };
  EXPECT_EQ(json::parse(made(TestConditions::SelfAdministered)
                            .statements.at(0))["context"]["extensions"]["https://training.example.org/sitting"],
            "self-administered");
  const XapiExport practice = made(TestConditions::Practice);
  EXPECT_TRUE(practice.statements.empty());
  EXPECT_EQ(leftOutSentence(practice.leftOut), "Left out: 1 attempt (1 practice, since no test was open).");
}

TEST(XapiStatements, ActorsByMailWhereTheyHaveOne) {
  const json s = statementsOf({attempt()}, {"https://training.example.org", true}).at(0);
  EXPECT_EQ(s["actor"]["mbox"], "mailto:ada@example.org");
  EXPECT_FALSE(s["actor"].contains("account"));
}

TEST(XapiStatements, MailAddressesAreWrittenAsAddresses) {
  // RFC 6068, 2: % and what means something in an address of the web is written as %HH.
  Person odd = ada();
  odd.email = "a+b%c?d&\xC3\xA9'@example.org";
  const auto texts = xapiStatements({"https://training.example.org", true}, test::courseOf({test::levelNamed("a", 1)}),
                                    odd, std::vector<AttemptFacts>{attempt()});
  ASSERT_TRUE(texts);
  EXPECT_EQ(json::parse(texts->statements.at(0))["actor"]["mbox"], "mailto:a+b%25c%3Fd%26%C3%A9'@example.org");
}

TEST(XapiStatements, OddFactsStayWithinTheStandard) {
  for (const std::int64_t time : {INT64_MIN, INT64_MAX, std::int64_t{0}})
    for (const double points : {-1.0, 101.0, std::numeric_limits<double>::quiet_NaN()}) {
      AttemptFacts odd = attempt();
      odd.begun_us = odd.length_us = time;
      odd.points = points;
      odd.metrics[0].value = std::numeric_limits<double>::infinity();
      odd.caseName = "broken \xFF text";
      const json s = statementsOf({odd}).at(0);
      EXPECT_FALSE(s["result"].contains("score"));
      EXPECT_FALSE(holdsNull(s));
      EXPECT_EQ(s.contains("timestamp"), time == 0);
      EXPECT_EQ(s["result"].contains("duration"), time >= 0);
    }
}

TEST(XapiStatements, HomePagesAreAddresses) {
  for (const char* page : {"", "training.example.org", "https://", "ftp://x", "https://a b", "https://a\"b", "http:///",
                           "https://a\\b", "https://{a}", "https://a|b", "https://a`b^"})
    EXPECT_THAT(xapiStatements({page, false}, {}, ada(), {}).error().message, HasSubstr("is not a home page")) << page;
}

TEST(XapiStatements, AreWrittenAsOneList) {
  const test::TemporaryFolder folder;
  const auto texts = xapiStatements(kSite, test::courseOf({test::levelNamed("a", 1)}), ada(),
                                    std::vector<AttemptFacts>{attempt(), attempt()});
  ASSERT_TRUE(writeXapi(folder / "x.json", texts->statements));
  EXPECT_EQ(json::parse(test::bytesOf(folder / "x.json")).size(), 2U);
  ASSERT_TRUE(writeXapi(folder / "x.json", {}));
  EXPECT_EQ(json::parse(test::bytesOf(folder / "x.json")), json::array());
  EXPECT_FALSE(writeXapi(folder / "missing" / "x.json", texts->statements));
}

}  // namespace
}  // namespace insonate
