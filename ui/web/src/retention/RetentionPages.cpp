#include "retention/RetentionPages.h"

#include "people/Accounts.h"

#include <insonate/curriculum/Retention.h>

#include <charconv>

namespace insonate::web {
namespace {

constexpr const char *kErase = "erase", *kRecordings = "recordings";
constexpr std::size_t kMostTraineesShown = 200;

/// Months of a field; empty: never. A text that is no number gives 0, which the store refuses.
std::optional<int> monthsIn(const Fields& fields, std::string_view name) {
  const std::string& typed = valueOf(fields, name);
  if (typed.empty()) return std::nullopt;
  int months = 0;
  const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), months);
  return error == std::errc() && end == typed.data() + typed.size() ? months : 0;
}

RetentionRule ruleIn(const Fields& fields) {
  return {.erase_months = monthsIn(fields, kErase), .recording_months = monthsIn(fields, kRecordings)};
}

std::string fieldOf(const std::optional<int>& months) {
  return months ? std::to_string(*months) : "";
}

std::string ruleSentence(const RetentionRule& rule) {
  const auto words = [](int months) { return std::to_string(months) + (months == 1 ? " month" : " months"); };
  return (rule.erase_months ? "Trainees are erased after " + words(*rule.erase_months) + " without activity. "
                            : std::string("Trainees are never erased. ")) +
         (rule.recording_months ? "Recordings and videos are deleted after " + words(*rule.recording_months) + "."
                                : std::string("Recordings and videos are never deleted."));
}

Markup ruleForm(const RetentionRule& rule) {
  const Markup fields = optionalField("Erase trainees after this many months without activity (empty: never)", kErase,
                                      "text", fieldOf(rule.erase_months)) +
                        optionalField("Delete recordings after this many months (empty: never)", kRecordings, "text",
                                      fieldOf(rule.recording_months)) +
                        element("button", {{"type", "submit"}}, "Preview");
  return element("form", {{"method", "get"}, {"action", "/retention"}}, fields);
}

Markup dueSection(const RetentionDue& due) {
  std::vector<std::vector<Markup>> rows;
  for (const auto& [person, last_us] : due.trainees) {
    if (rows.size() == kMostTraineesShown) break;
    rows.push_back({link(accountAddress(person.id), displayName(person)), text(person.name), timeOf(last_us)});
  }
  Markup content = paragraph("Trainees to be erased now: " + std::to_string(due.trainees.size()) +
                             ". Recordings to be deleted now: " + std::to_string(due.attempts.size()) + ".");
  if (!rows.empty())
    content += table("Trainees to be erased, the trainee with the longest inactivity first",
                     {"Name", "Sign-in name", "Last activity"}, rows);
  if (due.trainees.size() > rows.size())
    content += paragraph("The first " + std::to_string(rows.size()) + " of these trainees are shown.");
  return section("Preview", content);
}

Response retentionPage(const Visit& visit, const RetentionRule& shown, const std::string& trouble) {
  const Retention retention(*visit.by);
  const auto stored = retention.rule();
  if (!stored) return refusal(visit, 403, stored.error().message);
  Markup content = trouble.empty() ? Markup() : troubleLine(trouble);
  content += paragraph(ruleSentence(*stored)) +
             note(
                 "The server applies the retention rule one day after you save the rule, and then every day. Points "
                 "and metrics of an erased trainee are kept under a pseudonym. Deleted data cannot be restored.") +
             section("Retention rule", ruleForm(shown));
  if (!trouble.empty()) return page(visit, "Retention", content, 422);
  const auto due = retention.preview(shown);
  if (!due) return retentionPage(visit, shown, due.error().message);
  content += dueSection(*due);
  if (shown != *stored)
    content += section(
        "Save", paragraph(ruleSentence(shown)) + postForm(visit, "/retention",
                                                          hiddenField(kErase, fieldOf(shown.erase_months)) +
                                                              hiddenField(kRecordings, fieldOf(shown.recording_months)),
                                                          "Save rule"));
  return page(visit, "Retention", content);
}

}  // namespace

Response showRetention(const Visit& visit, const Parts& /*parts*/) {
  const Fields& query = visit.request.query;
  if (query.contains(kErase) || query.contains(kRecordings)) return retentionPage(visit, ruleIn(query), {});
  const auto stored = Retention(*visit.by).rule();
  return stored ? retentionPage(visit, *stored, {}) : refusal(visit, 403, stored.error().message);
}

Response setRetention(const Visit& visit, const Parts& /*parts*/) {
  const RetentionRule rule = ruleIn(visit.request.form);
  const auto done = Retention(*visit.by).setRule(rule);
  return done ? redirect("/retention") : retentionPage(visit, rule, done.error().message);
}

}  // namespace insonate::web
