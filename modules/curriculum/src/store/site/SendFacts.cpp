#include "store/AttemptRows.h"
#include "store/AuditChain.h"
#include "store/CommentRows.h"
#include "store/FormRows.h"
#include "store/Hands.h"
#include "store/OpeningRows.h"
#include "store/StandingRows.h"
#include "store/site/Up.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace insonate::store {
namespace {

struct SentAttempt {
  KeptAttempt kept{};
  AttemptFacts ended{};  ///< the state before the attempt was voided
  std::optional<std::int64_t> voided_us{};
  std::string voidedBy{}, acceptedBy{};
  std::vector<Row> comments{};
};

/// A fact that waits for the server, in its present state.
struct Item {
  std::int64_t number = 0;
  std::string kind{}, id{};
  std::optional<SentAttempt> attempt{};  ///< for a form: its attempt, which must be on the server first
  std::optional<FilledForm> form{};
  std::string password{};
  bool mustChange = false;
  std::int64_t version = 0;
};

struct Batch {
  std::vector<Item> items{};
  std::int64_t waiting = 0;
  AuditAnchor auditEnd{};
};

std::optional<SentAttempt> readAttempt(Transaction& here, const std::string& id) {
  const auto row = here.row("SELECT " INSONATE_ATTEMPT_COLUMNS
                            ", voided_by, COALESCE((SELECT accepted_by FROM proofs WHERE attempt = attempts.id), '') "
                            "FROM attempts WHERE id = ?",
                            id);
  if (!row) return std::nullopt;
  SentAttempt sent{.kept = keptOf(*row),
                   .voided_us = row->time(17),
                   .voidedBy = row->text(26),
                   .acceptedBy = row->text(27),
                   .comments = commentRows(here, id)};
  sent.ended = sent.kept.facts;
  sent.ended.state = stateOfEnd(*row);
  return sent;
}

Item readItem(Transaction& here, const Row& row) {
  Item item{.number = row.number(0), .kind = row.text(1), .id = row.text(2)};
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

Result<Batch> readBatch(Core& here, std::int64_t after) {
  constexpr std::int64_t kAtOnce = 200;
  return inTransaction(here, Way::Read, [&](Transaction& transaction) -> Result<Batch> {
    Batch batch{.waiting = transaction.number("SELECT COUNT(*) FROM outbox WHERE number > ?", after),
                .auditEnd = auditEnd(transaction)};
    for (const Row& row : transaction.rows(
             "SELECT number, kind, id FROM outbox WHERE number > ? ORDER BY number LIMIT ?", after, kAtOnce))
      batch.items.push_back(readItem(transaction, row));
    return batch;
  });
}

/// The server's attempt receives what it lacks: its beginning, its end, its voiding. The result does not depend on the
/// order or the number of repetitions. Fails if the server has another attempt of this id, or if the recording already
/// counts for another attempt there.
Result<void> mergeAttempt(Transaction& server, const SentAttempt& sent, std::int64_t now_us) {
  const AttemptFacts& facts = sent.ended;
  const auto another = [&] {
    return fail("The attempt " + facts.id + " differs from the one on the server and was not sent. Compare the two.");
  };
  // Checks before anything is written, so that the others of the batch are stored all the same.
  if (auto ok = refuseKnownHands(server, facts); !ok)
    return fail("The attempt " + facts.id + " stays here. " + ok.error().message);
  auto there = readAttempt(server, facts.id);
  if (!there) {
    insertAttempt(server, facts, "");
    there = SentAttempt{.kept = {.facts = facts}, .ended = facts};
    there->ended.state = AttemptState::Open;
  }
  if (!sameBeginning(there->ended, facts)) return another();
  if (there->ended.sitting == AttemptSitting::Undecided && facts.sitting != AttemptSitting::Undecided)
    server.run("UPDATE attempts SET sitting = ? WHERE id = ?", nameOf(facts.sitting), facts.id);
  const bool awaitsEnd = there->ended.state == AttemptState::Open || (there->kept.crashed && !sent.kept.crashed);
  if (facts.state != AttemptState::Open && awaitsEnd) {
    endAttempt(server, facts, sent.kept.crashed);
    keepHands(server, facts, now_us);
  } else if (facts.state != AttemptState::Open && !sent.kept.crashed && !sameEnd(there->ended, facts)) {
    return another();
  }
  if (facts.state != AttemptState::Open && !sent.kept.crashed)
    mergeProof(server, facts.id, facts.proof, sent.acceptedBy);
  if (sent.voided_us && !there->voided_us)
    server.run("UPDATE attempts SET voided_us = ?, voided_by = ?, void_reason = ? WHERE id = ?", *sent.voided_us,
               sent.voidedBy, sent.kept.voidReason, facts.id);
  for (const Row& comment : sent.comments) mergeComment(server, comment);
  return {};
}

/// If both were changed, the server's password is the newer one.
void mergePassword(Transaction& server, const Item& item) {
  server.run("UPDATE credentials SET password = ?, must_change = ?, version = ? WHERE person = ? AND version < ?",
             item.password, item.mustChange, item.version, item.id, item.version);
}

Result<void> mergeItem(Transaction& transaction, const Core& server, const Item& item, UploadReport& report) {
  if (item.attempt)
    if (auto merged = mergeAttempt(transaction, *item.attempt, server.now_us()); !merged) return merged;
  if (item.kind == "attempt" && item.attempt)
    server.audit(transaction, "", "receive attempt", item.attempt->ended.person,
                 item.attempt->ended.id + " of " + forLog(item.attempt->ended.workstation));
  if (item.form)
    if (auto kept = keepForm(transaction, *item.form); !kept) return tl::unexpected(kept.error());
  if (item.kind == "password") mergePassword(transaction, item);
  report.attempts += item.kind == "attempt";
  report.forms += item.kind == "form";
  return {};
}

/// Numbers of the entries that the server has stored.
Result<std::vector<std::int64_t>> giveBatch(Core& here, Core& server, const Batch& batch, UploadReport& report) {
  UploadReport counted = report;
  auto taken = inTransaction(server, Way::Write, [&](Transaction& transaction) -> Result<std::vector<std::int64_t>> {
    std::vector<std::int64_t> numbers;
    std::set<std::string> people;
    for (const Item& item : batch.items) {
      if (item.kind == "attempt" && item.attempt) people.insert(item.attempt->ended.person);
      if (auto merged = mergeItem(transaction, server, item, counted); merged)
        numbers.push_back(item.number);
      else
        counted.troubles.push_back(merged.error().message);
    }
    for (const std::string& person : people) renewStandings(transaction, person, server.now_us());
    // Stores the end of the workstation's log in the server's log, so that a later change of the workstation's log is
    // detected.
    server.audit(transaction, "", "upload", "",
                 std::to_string(numbers.size()) + " facts of " + here.workstation() + ", whose log ends at " +
                     std::to_string(batch.auditEnd.number) + " " + batch.auditEnd.hash);
    return numbers;
  });
  if (taken) report = counted;
  return taken;
}

Result<void> waitNoMore(Core& here, const std::vector<std::int64_t>& numbers) {
  return inTransaction(here, Way::Write, [&](Transaction& transaction) -> Result<void> {
    for (const std::int64_t number : numbers) transaction.run("DELETE FROM outbox WHERE number = ?", number);
    return {};
  });
}

}  // namespace

Result<void> sendFacts(Core& here, Core& server, UploadReport& report, const Progress& progress) {
  std::int64_t after = 0, total = 0, sent = 0;
  for (;;) {
    const auto batch = readBatch(here, after);
    if (!batch) return tl::unexpected(batch.error());
    if (batch->items.empty()) return {};
    total = std::max(total, batch->waiting);
    if (!insonate::report(progress, "sending", static_cast<double>(sent) / static_cast<double>(total)))
      return fail(std::string(kCancelled));
    const auto taken = giveBatch(here, server, *batch, report);
    if (!taken) return tl::unexpected(taken.error());
    if (auto done = waitNoMore(here, *taken); !done) return done;
    sent += static_cast<std::int64_t>(batch->items.size());
    after = batch->items.back().number;
  }
}

}  // namespace insonate::store
