#include "store/AttemptRows.h"
#include "store/Outbox.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/CommentStore.h>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Transaction;

constexpr std::size_t kMaxBytes = 4000;

Result<void> checkComment(const std::string& text) {
  if (auto ok = store::checkText("The comment", text, kMaxBytes); !ok) return ok;
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return fail("The comment is empty; type its text.");
  return {};
}

Result<void> checkTime(const AttemptFacts& facts, std::int64_t at_us) {
  if (facts.state == AttemptState::Open) return fail("The attempt is still open; comment on it once it has ended.");
  // The length of a recording that broke off is unknown.
  if (at_us >= 0 && (facts.length_us == 0 || at_us <= facts.length_us)) return {};
  return fail("The comment's time is outside the attempt, which takes " + std::to_string(facts.length_us / 1'000'000) +
              " s. State a time within it.");
}

Result<std::string> addComment(Transaction& transaction, const Core& core, const AttemptComment& comment) {
  const auto attempt = store::findAttempt(transaction, comment.attempt);
  if (!attempt) return fail("There is no attempt " + comment.attempt + "; reload the list.");
  if (auto ok = checkTime(attempt->facts, comment.at_us); !ok) return tl::unexpected(ok.error());
  if (auto ok = store::checkTakesTexts(transaction, attempt->facts.person); !ok) return tl::unexpected(ok.error());
  transaction.run("INSERT INTO comments VALUES (?, ?, ?, ?, ?, ?, NULL, NULL, NULL)", comment.id, comment.attempt,
                  comment.at_us, comment.by, comment.written_us, comment.text);
  store::putIntoOutbox(transaction, core, "attempt", comment.attempt);
  return comment.id;
}

Result<void> removeComment(Transaction& transaction, const Core& core, const Actor& actor, const std::string& attempt,
                           const std::string& comment) {
  const auto row =
      transaction.row("SELECT author, removed_us FROM comments WHERE id = ? AND attempt = ?", comment, attempt);
  if (!row) return fail("There is no such comment on the attempt; reload the list.");
  if (!row->isNull(1)) return {};
  if (row->text(0) != actor.id && actor.role != Role::Administrator)
    return fail("Only its author or an administrator can remove a comment.");
  transaction.run("UPDATE comments SET text = '', removed_us = ?, removed_by = ? WHERE id = ?", core.now_us(), actor.id,
                  comment);
  store::putIntoOutbox(transaction, core, "attempt", attempt);
  return {};
}

}  // namespace

Result<std::string> CommentStore::add(const std::string& attempt, std::int64_t at_us, const std::string& text) const {
  if (auto ok = checkComment(text); !ok) return tl::unexpected(ok.error());
  const Core& core = by_.session()->core();
  const AttemptComment comment{.id = store::freshUuid(),
                               .attempt = attempt,
                               .at_us = at_us,
                               .by = by_.person().id,
                               .written_us = core.now_us(),
                               .text = text};
  return by_.session()->write({.act = Act::WriteComment, .attempt = attempt, .detail = comment.id},
                              [&](Transaction& transaction, const Actor&) -> Result<std::string> {
                                return addComment(transaction, core, comment);
                              });
}

Result<void> CommentStore::remove(const std::string& attempt, const std::string& comment) const {
  return by_.session()->write({.act = Act::RemoveComment, .attempt = attempt, .detail = comment},
                              [&](Transaction& transaction, const Actor& actor) {
                                return removeComment(transaction, by_.session()->core(), actor, attempt, comment);
                              });
}

Result<std::vector<AttemptComment>> CommentStore::listByAttempt(const std::string& attempt) const {
  return by_.session()->read(
      {.act = Act::SeeComments, .attempt = attempt},
      [&](Transaction& transaction, const Actor&) -> Result<std::vector<AttemptComment>> {
        std::vector<AttemptComment> comments;
        for (const store::Row& row : transaction.rows(
                 "SELECT comments.id, at_us, author, COALESCE(NULLIF(full_name, ''), name, author), written_us, text, "
                 "read_us FROM comments LEFT JOIN people ON people.id = author WHERE attempt = ? AND removed_us IS "
                 "NULL "
                 "ORDER BY at_us, written_us, comments.id",
                 attempt))
          comments.push_back({row.text(0), attempt, row.number(1), row.text(2), row.text(3), row.number(4), row.text(5),
                              !row.isNull(6)});
        return comments;
      });
}

Result<void> CommentStore::markRead(const std::string& attempt) const {
  const Core& core = by_.session()->core();
  return by_.session()->write(
      {.act = Act::ReadComments, .attempt = attempt}, [&](Transaction& transaction, const Actor&) -> Result<void> {
        if (transaction.run(
                "UPDATE comments SET read_us = ? WHERE attempt = ? AND read_us IS NULL AND removed_us IS NULL",
                core.now_us(), attempt) > 0)
          store::putIntoOutbox(transaction, core, "attempt", attempt);
        return {};
      });
}

Result<std::map<std::string, CommentStore::Count>> CommentStore::countsOf(const std::string& person) const {
  return by_.session()->read(
      {.act = Act::SeeComments, .person = person},
      [&](Transaction& transaction, const Actor&) -> Result<std::map<std::string, Count>> {
        std::map<std::string, Count> counts;
        for (const store::Row& row : transaction.rows(
                 "SELECT attempt, COUNT(*), SUM(CASE WHEN read_us IS NULL THEN 1 ELSE 0 END) FROM comments JOIN "
                 "attempts "
                 "ON attempts.id = attempt WHERE attempts.person = ? AND removed_us IS NULL GROUP BY attempt",
                 person))
          counts[row.text(0)] = {row.count(1), row.count(2)};
        return counts;
      });
}

std::string commentCountText(const CommentStore::Count& count) {
  if (count.all == 0) return {};
  const std::string all = std::to_string(count.all);
  return count.unread == 0 ? all : all + ", " + std::to_string(count.unread) + " unread";
}

}  // namespace insonate
