#include "support/TestData.h"

#include <insonate/procedure/Procedure.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using testing::HasSubstr;

TEST(Procedure, PresetsAreFineAndSayEverything) {
  ASSERT_EQ(procedurePresetNames(),
            (std::vector<std::string>{"axillary", "basilic", "femoral", "femoral_line", "internal_jugular",
                                      "internal_jugular_line", "subclavian"}));
  for (const std::string& name : procedurePresetNames()) {
    const auto procedure = loadProcedure(name);
    ASSERT_TRUE(procedure) << procedure.error().message;
    EXPECT_EQ(procedure->name, name);
    EXPECT_EQ(procedure->steps.at(procedure->passBegins).name, "skin");
    EXPECT_FALSE(procedure->needs.empty() || procedure->target.empty());
    EXPECT_FALSE(procedure->rules.empty() || procedure->success.empty() || procedure->positions.empty());
    for (const ProcedureStep& step : procedure->steps) EXPECT_TRUE(step.instruction.ends_with(".")) << step.name;
    for (const ProcedureRule& rule : procedure->rules) EXPECT_TRUE(rule.text.ends_with(".")) << rule.name;
    for (const MetricNorm& norm : procedure->norms) EXPECT_TRUE(norm.advice.ends_with(".")) << norm.source;
  }
}

/// A procedure of one step, with a piece of its text replaced.
std::string with(const std::string& piece, const std::string& other) {
  std::string text = R"({"name": "p", "title": "P", "version": 2,
    "target": "femoral", "needs": [{"label": "vein", "why": "it is the target"}],
    "positions": [{"name": "supine", "tilt_deg": 0}],
    "steps": [{"name": "skin", "title": "Skin", "say": "Go in.", "until": {"happens": "entered", "wall": "skin"}}],
    "passBegins": "skin",
    "rules": [{"name": "r", "metric": "passes", "over": 2, "severity": "major", "say": "Too many."}],
    "success": [{"metric": "tip_in_vein", "over": 0}],
    "norms": [{"metric": "passes", "novice": 3, "expert": 1, "source": "S", "advice": "A."}]})";
  const auto at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return text.replace(at, piece.size(), other);
}

TEST(Procedure, IsReadAsItIsWritten) {
  const auto procedure = parseProcedure(with("major", "major"));
  ASSERT_TRUE(procedure) << procedure.error().message;
  EXPECT_EQ(procedure->version, 2);
  EXPECT_EQ(procedure->target, "femoral");
  ASSERT_EQ(procedure->needs.size(), 1U);
  EXPECT_EQ(procedure->needs[0].label, kVein);
  EXPECT_EQ(procedure->needs[0].why, "it is the target");
  const auto& until = std::get<EventCondition>(procedure->steps[0].until);
  EXPECT_EQ(until.kind, AttemptEventKind::Entered);
  EXPECT_EQ(until.wall, kSkin);
  EXPECT_EQ(procedure->rules[0].severity, Severity::Major);
  EXPECT_TRUE(procedure->rules[0].limit.isBeyond(3));
  EXPECT_FALSE(procedure->rules[0].limit.isBeyond(2));
  EXPECT_FALSE(procedure->rules[0].limit.isBeyond(std::nullopt));
  EXPECT_EQ(procedure->norms.at(0).metric, Metric::Passes);
  EXPECT_EQ(procedure->norms[0].novice, 3);
}

TEST(Procedure, BadInputIsToldWhereAndWhatElse) {
  struct Case {
    const char *piece, *other, *sentence;
  };
  for (const Case& c : std::initializer_list<Case>{
           {"{\"name\": \"p\"", "{{", "The procedure is not valid JSON: line 1"},
           {"\"title\": \"P\",", "", "The procedure has no 'title'."},
           {"\"title\": \"P\"", "\"title\": 7", "The procedure needs a text as 'title', not 7."},
           {"\"title\"", "\"titel\"", "The procedure has an unknown 'titel'; did you mean 'title'?"},
           {"\"version\": 2", "\"version\": 0", "needs a number from 1 to 1e+06 as 'version', not 0."},
           {"\"tilt_deg\": 0", "\"tilt_deg\": 90",
            "position 'supine' needs a number from -45 to 45 as 'tilt_deg', not 90."},
           {"\"label\": \"vein\"", "\"label\": \"vien\"", "need 1 has the unknown label 'vien'; did you mean 'vein'?"},
           {", \"why\": \"it is the target\"", "", "need 1 has no 'why'."},
           {"entered", "entred", "step 'skin', until, has the unknown happens 'entred'; did you mean 'entered'?"},
           {"\"wall\": \"skin\"", "\"wall\": \"vien\"", "has the unknown wall 'vien'; did you mean 'vein'?"},
           {"\"happens\": \"entered\", \"wall\": \"skin\"", "",
            "step 'skin', until, needs one of 'happens' and 'holds'."},
           {"\"wall\": \"skin\"", "\"for_s\": 1", "has 'for_s', which goes with 'holds'."},
           {"\"wall\": \"skin\"", "\"veins\": 2", "has 'veins', which goes with 'holds'."},
           {"\"happens\": \"entered\", \"wall\": \"skin\"", "\"holds\": \"probe on skin\"", "has no 'for_s'."},
           {"\"metric\": \"passes\"", "\"metric\": \"pases\"",
            "rule 'r' has the unknown metric 'pases'; did you mean 'passes'?"},
           {"\"over\": 2, ", "", "rule 'r' needs one of 'over' and 'under'."},
           {"\"over\": 2", "\"over\": 2, \"under\": 1", "rule 'r' needs one of 'over' and 'under'."},
           {"major", "grave", "has the unknown severity 'grave'; it is one of minor, major, critical."},
           {"\"passBegins\": \"skin\"", "\"passBegins\": \"sink\"", "has the unknown passBegins 'sink'"},
           {"\"rules\": [", "\"rules\": [3, ",
            "The procedure cannot be used: rule 1 must be an object { ... }, not 3."},
           {"\"steps\": [", "\"steps\": [], \"description\": [", "needs a text as 'description'"},
           {"\"success\": [{\"metric\": \"tip_in_vein\", \"over\": 0}]", "\"success\": {}",
            "needs a list [ ... ] as 'success', not {}."},
           {"\"expert\": 1", "\"expert\": 3", "norm 1 has an 'expert' that is no better than the 'novice'."},
           {"\"passes\", \"novice\"", "\"vein_punctures\", \"novice\"", "without a better direction"},
           {", \"source\": \"S\"", "", "norm 1 has no 'source'."},
           {"\"norms\": [",
            R"("norms": [{"metric": "passes", "novice": 2, "expert": 1, "source": "S", "advice": "A."}, )",
            "'passes' has two norms."}}) {
    const auto procedure = parseProcedure(with(c.piece, c.other));
    ASSERT_FALSE(procedure) << c.other;
    EXPECT_THAT(procedure.error().message, HasSubstr(c.sentence));
  }
  EXPECT_THAT(parseProcedure("[]").error().message, HasSubstr("must be an object"));
  const std::string twice = R"([{"name": "supine", "tilt_deg": 1}, )";
  EXPECT_THAT(parseProcedure(with("\"positions\": [", "\"positions\": " + twice)).error().message,
              HasSubstr("position 'supine' occurs twice"));
}

TEST(Procedure, FilesAndNames) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(loadProcedure("internal_jugluar").error().message, HasSubstr("did you mean 'internal_jugular'?"));
  std::ofstream(folder / "p.json") << with("major", "minor");
  EXPECT_TRUE(loadProcedure((folder / "p.json").string()));
  std::ofstream(folder / "q.json") << "{}";
  EXPECT_THAT(loadProcedure((folder / "q.json").string()).error().message,
              HasSubstr("q.json: The procedure has no 'name'"));
}

TEST(Procedure, ABuiltInOneIsNoFile) {
  for (const std::string& name : procedurePresetNames()) {
    const auto procedure = builtInProcedure(name);
    ASSERT_TRUE(procedure) << procedure.error().message;
    EXPECT_EQ(procedure->name, name);
  }
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "p.json";
  std::ofstream(file) << with("major", "minor");
  for (const std::string& name : {file.string(), std::filesystem::relative(file).string(), std::string("/etc/passwd")})
    EXPECT_THAT(builtInProcedure(name).error().message, HasSubstr("'" + name + "' is not a built-in procedure ("));
  EXPECT_THAT(builtInProcedure("internal_jugluar").error().message, HasSubstr("did you mean 'internal_jugular'?"));
}

}  // namespace
}  // namespace insonate
