#pragma once

#include "integration/CommandLine.h"
#include "support/TestData.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/AttemptRecorder.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <ctime>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

namespace insonate::test {

using nlohmann::json;

/// A store in a folder of its own, asked by commands alone. All people have the same password, once they have chosen
/// it.
class CurriculumCommands : public testing::Test {
 protected:
  static constexpr const char* kPassword = "chosen by themselves";
  static constexpr const char* kFirst = "set by someone else";

  std::string path(const std::string& name) const { return shellWord(folder / name); }

  /// `password` signs in, `newPassword` is set, where the command does either.
  CommandResult run(const std::string& arguments, const std::string& password = kPassword,
                    const std::string& newPassword = kFirst) const {
    return runCommand("curriculum " + arguments, folder / "errors.txt",
                      "env INSONATE_DATABASE=" + shellWord(database) + " INSONATE_PASSWORD=" + shellWord(password) +
                          " INSONATE_NEW_PASSWORD=" + shellWord(newPassword) + " ");
  }
  /// Output of a command that must succeed.
  json told(const std::string& arguments) const {
    const CommandResult result = run(arguments + " --json");
    EXPECT_EQ(result.status, 0) << arguments << ": " << result.errors;
    return json::parse(result.output, nullptr, false);
  }
  /// The sentence of a command that must refuse.
  std::string refused(const std::string& arguments, const std::string& password = kPassword) const {
    const CommandResult result = run(arguments + " --json", password);
    EXPECT_EQ(result.status, 1) << arguments << ": " << result.output << result.errors;
    const json object = json::parse(result.output, nullptr, false);
    return object.is_object() ? object.value("error", "") : "";
  }

  void setUp() const { EXPECT_EQ(run("setup boss --full-name 'The boss'", "", kPassword).status, 0); }
  void add(const std::string& name, const std::string& more = "") const {
    EXPECT_EQ(run("people add " + name + " --full-name 'Full " + name + "' --as boss " + more).status, 0) << name;
    EXPECT_EQ(run("people password --as " + name, kFirst, kPassword).status, 0) << name;
  }
  /// Two levels: the second opens once the first was passed.
  void publishTwoLevels() const {
    std::ofstream(folder / "two.json")
        << R"({"name": "two", "title": "Two levels", "about": "For a test.", "version": 1, "levels": [
      {"name": "first", "title": "First line", "about": "For a test.", "case": "textbook", "procedure": "internal_jugular",
       "assistance": "guided", "prerequisites": [], "pass": {"mastery_percent": 100, "standards": [
         {"metric": "artery_punctures", "most": 0, "otherwise": "the artery was punctured", "source": "harm"}]},
       "mastery": {"passesInARow": 1, "source": "one is enough for a test"}},
      {"name": "second", "title": "Second line", "about": "For a test.", "case": "small-vein", "procedure": "internal_jugular",
       "assistance": "test", "prerequisites": ["first"], "pass": {"mastery_percent": 100, "standards": []},
       "mastery": {"passesInARow": 2, "source": "two"}}]})";
    told("publish " + path("two.json") + " --as boss");
  }
  /// A class of that curriculum with a teacher, "miller", and trainees "alice" and "bob".
  void makeClass() const {
    setUp();
    publishTwoLevels();
    told("classes add 'Year 1' --as boss");
    told("classes curriculum 'Year 1' two --as boss");
    add("miller", "--role instructor --class 'Year 1'");
    add("alice", "--class 'Year 1'");
    add("bob", "--class 'Year 1'");
  }

  /// Now, or so many seconds later, as a recording's header tells it.
  static std::string utc(int later_s) {
    const std::time_t time = std::time(nullptr) + later_s;
    std::tm parts{};
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", ::gmtime_r(&time, &parts));
    return text;
  }

  enum class Ending { InVein, InArtery, Abandoned };
  /// A new recording, which differs from others by how long it lasts.
  std::string record(const std::string& name, Ending ending, double seconds, const std::string& begun = utc(0),
                     const RecordedFor& whose = {}, const std::optional<RecordKey>& key = std::nullopt) const {
    ScriptedAttempt attempt;
    attempt.aspirating = true;
    if (ending == Ending::InArtery) attempt.walls = {{kArtery, 20, 30}};
    attempt.needleTo(25), attempt.hold(seconds);
    AttemptHeader header;
    header.software = "insonate 0.1.0", header.begun = begun;
    header.procedure = "internal_jugular", header.procedureVersion = 1;
    header.caseName = "Textbook neck", header.caseHash = "c0ffee", header.picture = ScriptedAttempt::picture();
    header.recordedFor = whose;
    const auto recorder = AttemptRecorder::start(folder / name, header, nullptr, key);
    EXPECT_TRUE(recorder) << recorder.error().message;
    for (const auto& entry : attempt.stream) {
      while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::visit([&](const auto& what) { (*recorder)->record(what); }, entry);
    }
    EXPECT_TRUE((*recorder)->finish(ending == Ending::Abandoned ? AttemptStatus::Abandoned : AttemptStatus::Completed));
    return path(name);
  }
  /// An instructor counts an attempt that nothing proves.
  void accept(const json& added) const {
    told("attempts accept " + added["attempt"]["id"].get<std::string>() + " --reason seen --as miller");
  }
  std::string idOf(const std::string& name) const {
    const json people = told("people list --as boss")["people"];
    for (const json& person : people)
      if (person["name"] == name) return person["id"];
    return {};
  }

  const TemporaryFolder folder;
  std::string database = folder / "curriculum.sqlite";
};

}  // namespace insonate::test
