#include "Answer.h"
#include "Groups.h"

#include <insonate/teaching/MadeUpClass.h>

#include <filesystem>
#include <memory>

namespace insonate::cli {
namespace {

struct Arguments {
  std::string database;
  MadeUpPlan plan;
  NewPasswordOption password;
};

Result<Answer> demonstrate(const Arguments& a) {
  std::error_code error;
  if (!isServer(a.database) && std::filesystem::exists(a.database, error))
    return fail(a.database + " is there already; people who are made up do not go among others. Name a new file.");
  const auto curriculum = loadCurriculum("central_line");
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto password = a.password.read("A password for all who are made up");
  if (!password) return tl::unexpected(password.error());
  const auto store = CurriculumStore::open(a.database);
  if (!store) return tl::unexpected(store.error());
  if (auto made = makeUpClass(*store, *curriculum, a.plan, *password, terminalProgress()); !made) {
    // "Nothing was written" would not be true.
    if (made.error().message == kCancelled) return fail("Cancelled; " + a.database + " holds a part, delete it.");
    return tl::unexpected(made.error());
  }
  return Answer{{{"database", store->place()},
                 {"trainees", a.plan.trainees},
                 {"attempts", a.plan.trainees * a.plan.attempts},
                 {"seed", a.plan.seed},
                 {"made_up", true},
                 {"administrator", kMadeUpAdministrator},
                 {"teacher", kMadeUpTeacher},
                 {"classes", {kMadeUpClass, kMadeUpHalf}}},
                std::to_string(a.plan.trainees) + " made-up trainees with " + std::to_string(a.plan.attempts) +
                    " attempts each are in " + store->place() + "; next: insonate-cli curriculum classes members '" +
                    kMadeUpClass + "' --as " + kMadeUpTeacher + " --database " + a.database};
}

}  // namespace

void addDemoCommand(CLI::App& curriculum, Outcome& outcome) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = addAnsweringCommand(curriculum, outcome, "demo",
                                          "A new store of made-up people and attempts, to look at and to measure with",
                                          [a] { return demonstrate(*a); });
  command->add_option("DATABASE", a->database, "New file, or a server without people")->required()->check(notEmpty());
  command->add_option("--trainees", a->plan.trainees, "How many")->check(CLI::Range(1, 999))->capture_default_str();
  command->add_option("--attempts", a->plan.attempts, "Of each")->check(CLI::Range(0, 10000))->capture_default_str();
  command->add_option("--seed", a->plan.seed, "The same seed makes up the same attempts")->capture_default_str();
  a->password.addTo(*command);
}

}  // namespace insonate::cli
