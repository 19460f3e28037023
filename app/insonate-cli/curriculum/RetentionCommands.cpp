#include "Answer.h"
#include "Groups.h"

#include <insonate/curriculum/Retention.h>

#include <memory>
#include <string>

namespace insonate::cli {
namespace {

/// Months of the options; 0: never.
struct RuleArguments {
  int erase_months = 0, recording_months = 0;

  RetentionRule rule() const {
    const auto months = [](int number) { return number > 0 ? std::optional(number) : std::nullopt; };
    return {.erase_months = months(erase_months), .recording_months = months(recording_months)};
  }
};

std::string monthsWords(const std::optional<int>& months) {
  return months ? "after " + std::to_string(*months) + " months" : "never";
}

Answer told(const RetentionRule& rule) {
  return {{{"erase_months", orNull(rule.erase_months)}, {"recording_months", orNull(rule.recording_months)}},
          "Trainees are erased: " + monthsWords(rule.erase_months) +
              " without activity.\nRecordings are deleted: " + monthsWords(rule.recording_months) + "."};
}

Answer told(const RetentionDue& due, const std::string& erased, const std::string& deleted) {
  Json rows = Json::array();
  for (const auto& [person, last_us] : due.trainees)
    rows.push_back({{"id", person.id}, {"name", person.name}, {"last_activity", timeText(last_us)}});
  const std::string counts = "Trainees " + erased + ": " + std::to_string(due.trainees.size()) + ", recordings " +
                             deleted + ": " + std::to_string(due.attempts.size()) + ".";
  return {
      {{"trainees", rows}, {"recordings", due.attempts}},
      rows.empty() ? counts : counts + "\n" + tableOf(rows, {{"name", "name"}, {"last_activity", "last activity"}})};
}

Result<Answer> show(const SignedIn& by) {
  const auto rule = Retention(by).rule();
  return rule ? Result<Answer>(told(*rule)) : tl::unexpected(rule.error());
}

Result<Answer> set(const SignedIn& by, const RuleArguments& a) {
  if (auto done = Retention(by).setRule(a.rule()); !done) return tl::unexpected(done.error());
  Answer answer = told(a.rule());
  answer.text += "\nA server applies this a day from now, and then every day.";
  return answer;
}

Result<Answer> apply(const SignedIn& by, bool isDryRun) {
  const Retention retention(by);
  if (!isDryRun) {
    const auto applied = retention.deleteExpired();
    return applied ? Result<Answer>(told(*applied, "erased", "deleted")) : tl::unexpected(applied.error());
  }
  const auto rule = retention.rule();
  if (!rule) return tl::unexpected(rule.error());
  const auto due = retention.preview(*rule);
  return due ? Result<Answer>(told(*due, "to be erased", "to be deleted")) : tl::unexpected(due.error());
}

}  // namespace

void addRetentionCommands(CLI::App& curriculum, Outcome& outcome) {
  CLI::App& retention =
      *curriculum.add_subcommand("retention", "Delete old personal data by a rule (for administrators)");
  retention.require_subcommand(1);
  addSignedInCommand(retention, outcome, "show", "Print the rule", show);
  auto a = std::make_shared<RuleArguments>();
  CLI::App* command =
      addSignedInCommand(retention, outcome, "set", "Set the rule", [a](const SignedIn& by) { return set(by, *a); });
  command
      ->add_option("--erase-trainees", a->erase_months,
                   "Months without activity after which a trainee is erased; 0 (default): never")
      ->check(CLI::Range(0, 1200));
  command
      ->add_option("--delete-recordings", a->recording_months,
                   "Months after which the recording of an attempt is deleted; 0 (default): never")
      ->check(CLI::Range(0, 1200));
  auto isDryRun = std::make_shared<bool>(false);
  addSignedInCommand(retention, outcome, "apply", "Apply the rule now", [isDryRun](const SignedIn& by) {
    return apply(by, *isDryRun);
  })->add_flag("--dry-run", *isDryRun, "Only print who and what would be erased or deleted");
}

}  // namespace insonate::cli
