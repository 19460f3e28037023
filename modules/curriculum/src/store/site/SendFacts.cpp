#include "store/AttemptRows.h"
#include "store/AuditChain.h"
#include "store/CommentRows.h"
#include "store/FormRows.h"
#include "store/Hands.h"
#include "store/OpeningRows.h"
#include "store/PeopleRows.h"
#include "store/StandingRows.h"
#include "store/site/Site.h"
#include "store/site/WorkstationRules.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace insonate::store {
namespace {

SentItem readItem(Transaction& here, const Row& row) {
  SentItem item{.number = row.number(0), .kind = row.text(1), .id = row.text(2)};
  if (item.kind == "attempt") item.attempt = readAttempt(here, item.id);
  if (item.kind == "form")
    if (const auto form = here.row("SELECT " INSONATE_FORM_COLUMNS " FROM forms WHERE id = ?", item.id)) {
      item.form = filledOf(*form);
      if (!item.form->attempt.empty()) item.attempt = readAttempt(here, item.form->attempt);
    }
  if (item.kind == "password")
    if (const auto own = here.row("SELECT password, must_change, version FROM credentials WHERE person = ?", item.id)) {
      item.password = own->text(0);
      item.mustChange = own->truth(1);
      item.version = own->number(2);
    }
  return item;
}

/// If both were changed, the server's password is the newer one.
void mergePassword(Transaction& server, const SentItem& item) {
  server.run("UPDATE credentials SET password = ?, must_change = ?, version = ? WHERE person = ? AND version < ?",
             item.password, item.mustChange, item.version, item.id, item.version);
}

/// The person whom an entry of the outbox is about.
std::string personOfItem(const SentItem& item) {
  if (item.kind == "password") return item.id;
  return item.form ? item.form->person : item.attempt ? item.attempt->ended.person : std::string();
}

Result<void> mergeItem(Transaction& transaction, const Core& server, const Sender& sender, SentItem item,
                       Taken& taken) {
  if (isErased(transaction, personOfItem(item))) {
    const std::string sentence =
        "The server has erased a person. It does not take what this person has stored on this computer since then.";
    if (std::ranges::find(taken.troubles, sentence) == taken.troubles.end()) taken.troubles.push_back(sentence);
    return {};
  }
  if (!sender.isTrusted)
    if (auto ok = applyRules(transaction, server, sender, item, taken.troubles); !ok) return ok;
  const auto note = [&](std::string_view act, const std::string& person, const std::string& id) {
    server.audit(transaction, "", act, person, id + " of " + forLog(sender.workstation));
  };
  if (item.attempt && item.isForeign) {
    for (const Row& comment : item.attempt->comments)
      if (mergeComment(transaction, comment))
        note("receive comment", item.attempt->ended.person, item.attempt->ended.id);
  } else if (item.attempt) {
    if (auto merged = mergeAttempt(transaction, sender, *item.attempt, server.now_us()); !merged) return merged;
  }
  if (item.kind == "attempt" && item.attempt && !item.isForeign)
    server.audit(transaction, "", "receive attempt", item.attempt->ended.person,
                 item.attempt->ended.id + " of " + forLog(item.attempt->ended.workstation));
  if (item.form) {
    if (auto kept = storeForm(transaction, *item.form); !kept) return tl::unexpected(kept.error());
    note("receive form", item.form->person, item.form->id);
  }
  if (item.kind == "password" && sender.isTrusted) mergePassword(transaction, item);
  taken.attempts += item.kind == "attempt";
  taken.forms += item.kind == "form";
  return {};
}

}  // namespace

std::optional<SentAttempt> readAttempt(Transaction& here, const std::string& id) {
  const auto row = here.row("SELECT " INSONATE_ATTEMPT_COLUMNS
                            ", voided_by, COALESCE((SELECT accepted_by FROM proofs WHERE attempt = attempts.id), '') "
                            "FROM attempts WHERE id = ?",
                            id);
  if (!row) return std::nullopt;
  SentAttempt sent{.kept = storedAttemptOf(*row),
                   .voided_us = row->time(17),
                   .voidedBy = row->text(26),
                   .acceptedBy = row->text(27),
                   .comments = commentRows(here, id)};
  sent.ended = sent.kept.facts;
  sent.ended.state = stateOfEnd(*row);
  return sent;
}

Result<void> mergeAttempt(Transaction& server, const Sender& sender, const SentAttempt& sent, std::int64_t now_us) {
  const AttemptFacts& facts = sent.ended;
  const auto another = [&] {
    return fail("The attempt " + facts.id +
                " differs from the attempt on the server and was not sent. Compare the two attempts.");
  };
  // Checks before anything is written, so that the others of the batch are stored all the same.
  if (auto ok = refuseKnownHands(server, facts); !ok)
    return fail("The attempt " + facts.id + " stays on this computer. " + ok.error().message);
  auto there = readAttempt(server, facts.id);
  if (!there) {
    insertAttempt(server, facts, "");
    there = SentAttempt{.kept = {.facts = facts}, .ended = facts};
    there->ended.state = AttemptState::Open;
  }
  if (!sameBeginning(there->ended, facts)) return another();
  if (there->ended.testConditions == TestConditions::Undecided && facts.testConditions != TestConditions::Undecided)
    server.run("UPDATE attempts SET sitting = ? WHERE id = ?", nameOf(facts.testConditions), facts.id);
  const bool awaitsEnd = there->ended.state == AttemptState::Open || (there->kept.crashed && !sent.kept.crashed);
  if (facts.state != AttemptState::Open && awaitsEnd) {
    endAttempt(server, facts, sent.kept.crashed);
    storeHandsHash(server, facts, now_us);
  } else if (facts.state != AttemptState::Open && !sent.kept.crashed && !sameEnd(there->ended, facts)) {
    return another();
  }
  if (facts.state != AttemptState::Open && !sent.kept.crashed) {
    if (sender.isTrusted && facts.proof != AttemptProof::Verifying)
      mergeProof(server, facts.id, facts.proof, sent.acceptedBy);
    else if (!sender.isTrusted)
      awaitVerification(server, facts, now_us);
  }
  if (sent.voided_us && !there->voided_us)
    server.run("UPDATE attempts SET voided_us = ?, voided_by = ?, void_reason = ? WHERE id = ?", *sent.voided_us,
               sent.voidedBy, sent.kept.voidReason, facts.id);
  for (const Row& comment : sent.comments) mergeComment(server, comment);
  return {};
}

Result<SentBatch> readBatch(Core& here, std::int64_t after) {
  constexpr std::int64_t kAtOnce = 200;
  return inTransaction(here, Way::Read, [&](Transaction& transaction) -> Result<SentBatch> {
    SentBatch batch{.waiting = transaction.number("SELECT COUNT(*) FROM outbox WHERE number > ?", after),
                    .auditEnd = auditEnd(transaction)};
    for (const Row& row : transaction.rows(
             "SELECT number, kind, id FROM outbox WHERE number > ? ORDER BY number LIMIT ?", after, kAtOnce))
      batch.items.push_back(readItem(transaction, row));
    return batch;
  });
}

Result<Taken> takeBatch(Transaction& transaction, Core& server, const Sender& sender, const SentBatch& batch) {
  Taken taken;
  std::set<std::string> people;
  for (const SentItem& item : batch.items) {
    if (item.kind == "attempt" && item.attempt) people.insert(item.attempt->ended.person);
    if (auto merged = mergeItem(transaction, server, sender, item, taken); merged)
      taken.numbers.push_back(item.number);
    else
      taken.troubles.push_back(merged.error().message);
  }
  for (const std::string& person : people) renewStandings(transaction, person, server.now_us());
  // Stores the end of the workstation's log in the server's log, so that a later change of the workstation's log is
  // detected.
  server.audit(transaction, "", "upload", "",
               std::to_string(taken.numbers.size()) + " facts of " + sender.workstation + ", whose log ends at " +
                   std::to_string(batch.auditEnd.number) + " " + forLog(batch.auditEnd.hash));
  return taken;
}

}  // namespace insonate::store
