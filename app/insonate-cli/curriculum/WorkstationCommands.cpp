#include "Answer.h"
#include "Groups.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/Workstations.h>

#include <sys/stat.h>

#include <filesystem>
#include <memory>

namespace insonate::cli {
namespace {

struct WorkstationArguments {
  std::string name, tokenFile;
};

/// Readable by its owner alone from the beginning.
Result<void> writeSecret(const std::string& file, const std::string& token) {
  const mode_t before = ::umask(0077);
  auto written = writeAtomically(file, token + "\n");
  ::umask(before);
  return written;
}

Result<Answer> add(const SignedIn& by, const WorkstationArguments& a) {
  if (!a.tokenFile.empty() && std::filesystem::exists(a.tokenFile))
    return fail(a.tokenFile + " exists already. Name another file.");
  const auto token = Workstations(by).add(a.name);
  if (!token) return tl::unexpected(token.error());
  if (a.tokenFile.empty())
    return Answer{{{"name", a.name}, {"token", *token}},
                  "Token of '" + a.name + "', which is shown only now:\n" + *token};
  if (auto written = writeSecret(a.tokenFile, *token); !written) {
    (void)Workstations(by).revoke(a.name);
    return tl::unexpected(written.error());
  }
  return Answer{
      {{"name", a.name}, {"file", a.tokenFile}},
      "Wrote the token of '" + a.name + "' to " + a.tokenFile + ". Copy it to that computer, then delete it here."};
}

Result<Answer> revoke(const SignedIn& by, const WorkstationArguments& a) {
  if (auto done = Workstations(by).revoke(a.name); !done) return tl::unexpected(done.error());
  return Answer{{{"name", a.name}, {"state", "revoked"}}, "'" + a.name + "' can no longer reach the server."};
}

Result<Answer> list(const SignedIn& by) {
  const auto workstations = Workstations(by).list();
  if (!workstations) return tl::unexpected(workstations.error());
  Json rows = Json::array();
  const auto timeOrNull = [](const std::optional<std::int64_t>& time_us) {
    return time_us ? Json(timeText(*time_us)) : Json(nullptr);
  };
  for (const Workstation& one : *workstations)
    rows.push_back({{"name", one.name},
                    {"state", one.revoked_us ? "revoked" : "in use"},
                    {"added", timeText(one.added_us)},
                    {"by", one.addedBy},
                    {"seen", timeOrNull(one.seen_us)},
                    {"revoked", timeOrNull(one.revoked_us)}});
  return Answer{{{"workstations", rows}},
                rows.empty() ? "No workstations yet."
                             : tableOf(rows, {{"name", "workstation"},
                                              {"state", "state"},
                                              {"seen", "last request"},
                                              {"added", "added"},
                                              {"by", "by"}})};
}

}  // namespace

void addWorkstationCommands(CLI::App& curriculum, Outcome& outcome) {
  CLI::App& workstations = *curriculum.add_subcommand(
      "workstations",
      "Manage the tokens with which workstations send attempts to the server (insonate-server); for administrators");
  workstations.require_subcommand(1);
  const auto a = std::make_shared<WorkstationArguments>();
  const auto addName = [a](CLI::App* command) {
    command
        ->add_option("NAME", a->name, "Name of the workstation, as the command 'hostname' prints it on that computer")
        ->required();
    return command;
  };
  addName(addSignedInCommand(workstations, outcome, "add", "Add a workstation and make its token",
                             [a](const SignedIn& by) { return add(by, *a); }))
      ->add_option("--token-file", a->tokenFile, "Write the token to this new file instead of the terminal");
  addName(addSignedInCommand(workstations, outcome, "revoke", "End the access of a workstation at once",
                             [a](const SignedIn& by) { return revoke(by, *a); }));
  addSignedInCommand(workstations, outcome, "list", "List the workstations, with the time of their last request",
                     [](const SignedIn& by) { return list(by); });
}

}  // namespace insonate::cli
