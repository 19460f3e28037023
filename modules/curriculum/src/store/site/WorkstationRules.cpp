#include "store/site/WorkstationRules.h"

#include "store/Access.h"
#include "store/AttemptRows.h"
#include "store/OpeningRows.h"
#include "store/Texts.h"

#include <algorithm>

namespace insonate::store {
namespace {

/// The permissions are those that the person has on the server now, as in a session of this person.
bool mayDo(Transaction& server, const Sender& sender, const std::string& actor, const Request& request) {
  if (!isKnownAt(server, sender.workstation, actor)) return false;
  const auto version = server.row("SELECT version FROM credentials WHERE person = ?", actor);
  Actor by{.id = actor, .passwordVersion = version ? version->number(0) : 0};
  return !decide(server, by, request).refusal;
}

/// `isForeign`: set if the attempt was made at another workstation, from which the server has it already.
Result<void> checkAttempt(Transaction& server, const Core& core, const Sender& sender, const SentAttempt& sent,
                          bool& isForeign) {
  const AttemptFacts& facts = sent.ended;
  const auto stays = [&](const std::string& why) {
    return fail("The attempt " + facts.id.substr(0, 36) + " was not sent. " + why);
  };
  const auto there = server.row("SELECT workstation, person FROM attempts WHERE id = ?", facts.id);
  isForeign = there && there->text(0) != sender.workstation && there->text(0) == facts.workstation &&
              there->text(1) == facts.person;
  if (isForeign) return {};
  if (facts.workstation != sender.workstation || (there && there->text(0) != sender.workstation))
    return stays("The attempt was made at the workstation '" + facts.workstation.substr(0, 64) +
                 "'; send the attempt from that workstation.");
  if (!isKnownAt(server, sender.workstation, facts.person))
    return stays(
        "The person of the attempt has not signed in to the server at this workstation. Let this person sign in here "
        "once.");
  if (auto ok = checkBegun(facts); !ok) return ok;
  if (facts.state != AttemptState::Open)
    if (auto ok = checkEnded(facts); !ok) return ok;
  return refuseImpossibleDates(server, facts, core.now_us());
}

/// The server's openings decide, not the workstation. A code is checked at the workstation, where it was entered; what
/// the workstation told the trainee to be practice stays practice.
TestConditions sittingOf(Transaction& server, const AttemptFacts& facts) {
  const TestConditions decided = sittingAt(server, facts, facts.begun_us);
  using enum TestConditions;
  if ((decided == Opened || decided == SelfAdministered) && facts.testConditions == Practice) return Practice;
  const bool isCodeEntered =
      decided == Practice && facts.testConditions == Opened &&
      !codedOpenings(server, facts.person, facts.curriculum, facts.level, facts.begun_us).empty();
  return isCodeEntered ? Opened : decided;
}

/// A workstation states who voided or accepted an attempt, which proves nothing: these acts are made on the server.
void removeActs(Transaction& server, SentAttempt& sent, std::vector<std::string>& troubles) {
  const std::string& id = sent.ended.id;
  const auto there = server.row(
      "SELECT voided_us, COALESCE((SELECT proofs.state FROM proofs WHERE attempt = attempts.id), '') FROM attempts "
      "WHERE id = ?",
      id);
  const auto refuse = [&](const char* act) {
    troubles.push_back("The attempt " + id + " was " + act +
                       " on this computer, which the server does not take over. Repeat this on the server.");
  };
  if (sent.voided_us && (!there || there->isNull(0))) refuse("voided");
  if (!sent.acceptedBy.empty() && (!there || there->text(1) != "accepted")) refuse("accepted");
  sent.voided_us.reset();
  sent.acceptedBy.clear();
}

bool mayTake(Transaction& server, const Sender& sender, const SentAttempt& sent, const Row& comment) {
  const std::string id = comment.text(0), author = comment.text(3);
  if (comment.text(1) != sent.ended.id || !isUuid(id) || !checkText("", comment.text(5), 4000)) return false;
  const auto known = server.row("SELECT attempt, author FROM comments WHERE id = ?", id);
  if (known && (known->text(0) != sent.ended.id || known->text(1) != author)) return false;
  const auto may = [&](Act act) { return mayDo(server, sender, author, {.act = act, .person = sent.ended.person}); };
  if (!known && !may(Act::WriteComment)) return false;
  return comment.isNull(7) || (comment.text(8) == author && may(Act::RemoveComment));
}

void removeComments(Transaction& server, const Sender& sender, SentAttempt& sent, std::vector<std::string>& troubles) {
  if (std::erase_if(sent.comments, [&](const Row& comment) { return !mayTake(server, sender, sent, comment); }) > 0)
    troubles.push_back("A comment on the attempt " + sent.ended.id +
                       " was not sent: its author may not write or remove the comment on the server, or has not signed "
                       "in to the server at this workstation.");
}

Result<void> checkForm(Transaction& server, const Sender& sender, const FilledForm& form) {
  const auto stays = [&](const std::string& why) {
    return fail("The form " + form.id.substr(0, 36) + " was not sent. " + why);
  };
  if (!isUuid(form.id) || form.formVersion < 0)
    return stays("The id or the version of the form is not one of Insonate.");
  if (!mayDo(server, sender, form.by, {.act = Act::FillForm, .person = form.person}))
    return stays(
        "The author may not fill in the form on the server, or has not signed in to the server at this workstation.");
  const auto attempt = server.row("SELECT person FROM attempts WHERE id = ?", form.attempt);
  if (!form.attempt.empty() && attempt && attempt->text(0) != form.person)
    return stays("The attempt is not one of the person whom the form is about.");
  if (!form.attempt.empty() &&
      server.number("SELECT COUNT(*) FROM forms WHERE attempt = ? AND form = ? AND filled_by = ? AND id <> ?",
                    form.attempt, form.form, form.by, form.id) > 0)
    return stays("The author has handed in this form about this attempt already.");
  if (auto ok = checkText("The form's name", form.form); !ok) return ok;
  return checkJsonObject("The form's answers", form.answers);
}

}  // namespace

bool isKnownAt(Transaction& server, const std::string& workstation, const std::string& person) {
  return server.number("SELECT COUNT(*) FROM workstation_people WHERE workstation = ? AND person = ?", workstation,
                       person) > 0;
}

void knowAt(Transaction& server, const std::string& workstation, const std::string& person, std::int64_t now_us) {
  if (!isKnownAt(server, workstation, person))
    server.run("INSERT INTO workstation_people VALUES (?, ?, ?)", workstation, person, now_us);
}

Result<void> applyRules(Transaction& server, const Core& core, const Sender& sender, SentItem& item,
                        std::vector<std::string>& troubles) {
  if (item.attempt) {
    if (auto ok = checkAttempt(server, core, sender, *item.attempt, item.isForeign); !ok) return ok;
    item.attempt->ended.testConditions = sittingOf(server, item.attempt->ended);
    removeActs(server, *item.attempt, troubles);
    removeComments(server, sender, *item.attempt, troubles);
  }
  if (item.form && item.attempt && item.attempt->ended.person != item.form->person)
    return fail("The form " + item.form->id.substr(0, 36) + " was not sent. Its attempt is of another person.");
  if (item.form)
    if (auto ok = checkForm(server, sender, *item.form); !ok) return ok;
  if (item.kind == "password")
    troubles.emplace_back(
        "A password was changed on this computer before the computer joined the server. The password on the server is "
        "unchanged: sign in with the password of the server.");
  return {};
}

void awaitVerification(Transaction& server, const AttemptFacts& facts, std::int64_t now_us) {
  if (facts.recordingHash.empty())
    concludeProof(server, facts.id, AttemptProof::Unproven);
  else if (server.number("SELECT COUNT(*) FROM verifications WHERE attempt = ?", facts.id) == 0)
    server.run("INSERT INTO verifications VALUES (?, ?, NULL, NULL, NULL, '')", facts.id, now_us);
}

}  // namespace insonate::store
