#include "Answer.h"
#include "Groups.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/teaching/DemoClass.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <system_error>

namespace insonate::cli {
namespace {

constexpr int kDemonstrations = 3;
/// Built-in scripts: a success, an attempt in two passes, and a puncture of the artery.
constexpr std::array<const char*, kDemonstrations> kScripts{"clean-success", "two-passes", "carotid-puncture"};
constexpr std::uint32_t kSeed = 1;  // the neck that the window shows

struct DemoArguments {
  std::string database;
  DemoClassPlan plan;
  int recorded = kDemonstrations;
  NewPasswordOption password;
};

/// Records the first `most` of the demonstration attempts at a level's built-in case. The files are named "NAME
/// SCRIPT.attempt"; the folder is created if it is missing. Takes about ten seconds for each. If cancelled, the
/// finished recordings stay.
Result<std::vector<std::filesystem::path>> recordDemonstrations(const Level& level, const std::filesystem::path& folder,
                                                                const std::string& name, int most,
                                                                const Progress& progress) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(folder.string() + " cannot be made: " + error.message() + ". Name a database elsewhere.");
  const auto patient = makePhantom(level.caseName, kSeed, progress);
  if (!patient) return tl::unexpected(patient.error());
  std::vector<std::filesystem::path> recordings;
  for (const char* script : kScripts) {
    if (static_cast<int>(recordings.size()) == most) break;
    const auto actions = loadSessionScript(script, *patient);
    if (!actions) return tl::unexpected(actions.error());
    recordings.push_back(folder / (name + ' ' + script + ".attempt"));
    const auto recorded = runSession(*actions, *patient, "insonate " INSONATE_VERSION, recordings.back(), progress);
    if (!recorded) return tl::unexpected(recorded.error());
  }
  return recordings;
}

/// Folder in which the window looks for recordings of this store's attempts.
std::filesystem::path recordingsOf(const std::string& database) {
  return (isServer(database) ? usualStoreFile() : std::filesystem::path(database)).parent_path() / "attempts";
}

Result<std::vector<std::filesystem::path>> makeUp(const CurriculumStore& store, const Curriculum& curriculum,
                                                  const DemoArguments& a, const std::string& password) {
  const Progress progress = terminalProgress();
  DemoClassPlan plan = a.plan;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  plan.until_us = std::chrono::duration_cast<std::chrono::microseconds>(now).count();
  if (auto made = makeDemoClass(store, curriculum, plan, password, progress); !made)
    return tl::unexpected(made.error());
  const std::string name = isServer(a.database) ? "made-up" : std::filesystem::path(a.database).stem().string();
  auto recordings = recordDemonstrations(curriculum.levels.front(), recordingsOf(a.database), name,
                                         std::min(a.recorded, plan.trainees), progress);
  if (!recordings) return recordings;
  if (auto added = addRecordedAttempts(store, curriculum, *recordings, password); !added)
    return tl::unexpected(added.error());
  return recordings;
}

Result<Answer> demonstrate(const DemoArguments& a) {
  std::error_code error;
  if (!isServer(a.database) && std::filesystem::exists(a.database, error))
    return fail(a.database + " already exists, and made-up people must not be mixed with real ones. Name a new file.");
  const auto curriculum = loadCurriculum("central_line");
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto password = a.password.read("Password for all made-up people");
  if (!password) return tl::unexpected(password.error());
  const auto store = CurriculumStore::open(a.database);
  if (!store) return tl::unexpected(store.error());
  const auto recordings = makeUp(*store, *curriculum, a, *password);
  if (!recordings) {
    // "Nothing was written" would not be true.
    if (recordings.error().message == kCancelled)
      return fail("Canceled; " + a.database + " contains a part of the data. Delete it.");
    return tl::unexpected(recordings.error());
  }
  Json files = Json::array();
  for (const std::filesystem::path& file : *recordings) files.push_back(file.string());
  return Answer{{{"database", store->place()},
                 {"trainees", a.plan.trainees},
                 {"attempts", a.plan.trainees * a.plan.attempts + static_cast<int>(recordings->size())},
                 {"recordings", files},
                 {"seed", a.plan.seed},
                 {"made_up", true},
                 {"administrator", kDemoAdministrator},
                 {"teacher", kDemoInstructor},
                 {"classes", {kDemoClass, kDemoHalfClass}}},
                std::to_string(a.plan.trainees) + " made-up trainees with " + std::to_string(a.plan.attempts) +
                    " attempts each are in " + store->place() + ", and " + std::to_string(recordings->size()) +
                    " that were recorded, to be replayed in Review; next: insonate --database " + a.database +
                    ", and sign in as " + kDemoInstructor + " (Ctrl+L); or insonate-cli curriculum classes members '" +
                    kDemoClass + "' --as " + kDemoInstructor + " --database " + a.database};
}

}  // namespace

void addDemoCommand(CLI::App& curriculum, Outcome& outcome) {
  auto a = std::make_shared<DemoArguments>();
  CLI::App* command =
      addAnsweringCommand(curriculum, outcome, "demo", "Make a new database of made-up people and attempts",
                          [a] { return demonstrate(*a); });
  command->add_option("DATABASE", a->database, "New database file, or address of a server database without people")
      ->required()
      ->check(notEmpty());
  command->add_option("--trainees", a->plan.trainees, "Number of trainees")
      ->check(CLI::Range(1, 999))
      ->capture_default_str();
  command->add_option("--attempts", a->plan.attempts, "Number of attempts of each trainee")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  command->add_option("--seed", a->plan.seed, "Seed of the random numbers; the same seed gives the same attempts")
      ->capture_default_str();
  command
      ->add_option("--recorded", a->recorded,
                   "Number of trainees whose newest attempt gets a recording that can be replayed; making each "
                   "recording takes ten seconds")
      ->check(CLI::Range(0, kDemonstrations))
      ->capture_default_str();
  a->password.addTo(*command);
}

}  // namespace insonate::cli
