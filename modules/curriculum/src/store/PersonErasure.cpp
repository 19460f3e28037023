#include "store/PersonErasure.h"

#include "store/AttemptRows.h"
#include "store/AuditChain.h"
#include "store/AuditErasure.h"
#include "store/LockOut.h"
#include "store/PeopleRows.h"
#include "store/Proofs.h"
#include "store/Texts.h"

#include <insonate/curriculum/Form.h>

#include <optional>
#include <utility>
#include <variant>

namespace insonate::store {
namespace {

constexpr std::size_t kPseudonymDigits = 8;

void eraseAccount(Transaction& transaction, const Person& person) {
  const std::string digits = person.id.substr(0, kPseudonymDigits);
  std::string name = "erased-" + digits;
  if (!checkNameIsFree(transaction, {.id = person.id, .name = name})) name = "erased-" + person.id;
  transaction.run("UPDATE people SET name = ?, name_key = ?, full_name = ?, email = '', disabled = 1 WHERE id = ?",
                  name, nameKey(name), "Erased person " + digits, person.id);
  // Not a hash, so that no password fits; the next version ends all sessions.
  transaction.run("UPDATE credentials SET password = '*', must_change = 0, version = version + 1 WHERE person = ?",
                  person.id);
  transaction.run("DELETE FROM browser_sessions WHERE person = ?", person.id);
  transaction.run("DELETE FROM sign_in_tokens WHERE person = ?", person.id);
  // Classes as a trainee stay, since they are the groups of statistics.
  transaction.run("DELETE FROM memberships WHERE person = ? AND teaches = 1", person.id);
  resetFailures(transaction, person.name);
}

bool isChoice(const std::optional<Form>& form, const std::string& question) {
  const FormItem* item = form ? form->item(question) : nullptr;
  return item && item->kind == FormItem::Kind::Choice;
}

/// Keeps numbers and choices. All texts in a form that this program does not know are erased.
std::string withoutTexts(const std::string& formName, const std::string& answers) {
  const auto parsed = parseAnswers(answers);
  if (!parsed) return "{}";
  const auto loaded = loadForm(formName);
  const std::optional<Form> form = loaded ? std::optional(*loaded) : std::nullopt;
  FormAnswers kept = *parsed;
  for (auto& [question, answer] : kept)
    if (std::holds_alternative<std::string>(answer) && !isChoice(form, question)) answer = std::string(kErased);
  return answersText(kept);
}

void eraseTexts(Transaction& transaction, const std::string& person, const std::string& by, std::int64_t now_us) {
  transaction.run(
      "UPDATE comments SET text = '', removed_us = ?, removed_by = ? WHERE removed_us IS NULL AND attempt IN (SELECT "
      "id "
      "FROM attempts WHERE person = ?)",
      now_us, by, person);
  for (const Row& row : transaction.rows("SELECT id, form, answers FROM forms WHERE person = ?", person))
    transaction.run("UPDATE forms SET answers = ? WHERE id = ?", withoutTexts(row.text(1), row.text(2)), row.text(0));
  transaction.run("UPDATE attempts SET recording = '' WHERE person = ? AND state <> 'open'", person);
  transaction.run("UPDATE attempts SET void_reason = ? WHERE person = ? AND voided_us IS NOT NULL", kErased, person);
}

}  // namespace

Result<void> erasePerson(Transaction& transaction, const Core& core, const std::string& id, const std::string& by) {
  const auto person = findPerson(transaction, id);
  if (!person) return unknownPerson();
  if (isErased(transaction, id)) return {};
  // The triggers allow the other changes from here on.
  transaction.run("INSERT INTO erasures VALUES (?, ?, ?)", id, core.now_us(), by);
  if (auto done = eraseFromLog(transaction, core, *person, by); !done) return done;
  eraseAccount(transaction, *person);
  eraseTexts(transaction, id, by, core.now_us());
  std::vector<std::string> attempts;
  for (const Row& row : transaction.rows("SELECT id FROM attempts WHERE person = ?", id))
    attempts.push_back(row.text(0));
  endWorkOnRecordings(transaction, attempts, core.now_us());
  return {};
}

void endWorkOnRecordings(Transaction& transaction, const std::vector<std::string>& attempts, std::int64_t now_us) {
  for (const std::string& attempt : attempts) {
    transaction.run("DELETE FROM videos WHERE attempt = ?", attempt);
    if (transaction.run("UPDATE verifications SET ended_us = ?, why = ? WHERE attempt = ? AND ended_us IS NULL", now_us,
                        "The recording was deleted before the attempt was verified.", attempt) > 0)
      concludeProof(transaction, attempt, AttemptProof::Unproven);
  }
}

std::vector<std::string> erasedAttempts(Transaction& transaction) {
  std::vector<std::string> attempts;
  for (const Row& row :
       transaction.rows("SELECT id FROM erasures JOIN attempts ON attempts.person = erasures.person ORDER BY arrival"))
    attempts.push_back(row.text(0));
  return attempts;
}

}  // namespace insonate::store
