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

Result<void> checkAttempt(Transaction& server, const Core& core, const Sender& sender, const SentAttempt& sent) {
  const AttemptFacts& facts = sent.ended;
  const auto stays = [&](const std::string& why) {
    return fail("The attempt " + facts.id.substr(0, 36) + " was not sent. " + why);
  };
  if (facts.workstation != sender.workstation)
    return stays("It was made at the workstation '" + facts.workstation.substr(0, 64) + "'; send it from there.");
  if (!isKnownAt(server, sender.workstation, facts.person))
    return stays("Its person has not signed in to the server at this workstation. Let this person sign in here once.");
  if (auto ok = checkBegun(facts); !ok) return ok;
  if (facts.state != AttemptState::Open)
    if (auto ok = checkEnded(facts); !ok) return ok;
  return refuseImpossibleDates(server, facts, core.now_us());
}

/// The server's openings decide, not the workstation. A code is checked at the workstation, where it was entered; what
/// the workstation told the trainee to be practice stays practice.
AttemptSitting sittingOf(Transaction& server, const AttemptFacts& facts) {
  const AttemptSitting decided = sittingAt(server, facts, facts.begun_us);
  using enum AttemptSitting;
  if (decided == Opened && facts.sitting == Practice) return Practice;
  const bool isCodeEntered =
      decided == Practice && facts.sitting == Opened &&
      !codedOpenings(server, facts.person, facts.curriculum, facts.level, facts.begun_us).empty();
  return isCodeEntered ? Opened : decided;
}

/// Removes acts of instructors that the instructor may not do on the server.
void removeActs(Transaction& server, const Sender& sender, SentAttempt& sent, std::vector<std::string>& troubles) {
  const std::string &id = sent.ended.id, &person = sent.ended.person;
  const auto refuse = [&](const char* act) {
    troubles.push_back("The attempt " + id + " was " + act +
                       " here by somebody who may not do that on the server, so the server did not take this over.");
  };
  if (sent.voided_us && !mayDo(server, sender, sent.voidedBy, {.act = Act::VoidAttempt, .person = person})) {
    sent.voided_us.reset();
    refuse("voided");
  }
  if (!sent.acceptedBy.empty() &&
      !mayDo(server, sender, sent.acceptedBy, {.act = Act::AcceptAttempt, .person = person})) {
    sent.acceptedBy.clear();
    refuse("accepted");
  }
  const auto isAllowed = [&](const Row& comment) {
    const auto may = [&](std::size_t column, Act act) {
      return mayDo(server, sender, comment.text(column), {.act = act, .person = person});
    };
    const bool isOwn = comment.text(1) == id && isUuid(comment.text(0)) && checkText("", comment.text(5), 4000);
    const bool isKnown = server.row("SELECT id FROM comments WHERE id = ?", comment.text(0)).has_value();
    return isOwn && (isKnown || may(3, Act::WriteComment)) && (comment.isNull(7) || may(8, Act::RemoveComment));
  };
  if (std::erase_if(sent.comments, [&](const Row& comment) { return !isAllowed(comment); }) > 0) refuse("commented on");
}

Result<void> checkForm(Transaction& server, const Sender& sender, const FilledForm& form) {
  const auto stays = [&](const std::string& why) {
    return fail("The form " + form.id.substr(0, 36) + " was not sent. " + why);
  };
  if (!isUuid(form.id) || form.formVersion < 0) return stays("Its id or its version is not one of Insonate.");
  if (!mayDo(server, sender, form.by, {.act = Act::FillForm, .person = form.person}))
    return stays("Its author may not fill it in on the server, or has not signed in there at this workstation.");
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
    if (auto ok = checkAttempt(server, core, sender, *item.attempt); !ok) return ok;
    item.attempt->ended.sitting = sittingOf(server, item.attempt->ended);
    removeActs(server, sender, *item.attempt, troubles);
  }
  if (item.form)
    if (auto ok = checkForm(server, sender, *item.form); !ok) return ok;
  if (item.kind == "password")
    troubles.emplace_back(
        "A password was changed on this computer before it joined the server, which keeps its own: sign in with that "
        "one.");
  return {};
}

void awaitVerification(Transaction& server, const AttemptFacts& facts, const std::string& acceptedBy,
                       std::int64_t now_us) {
  if (facts.recordingHash.empty())
    concludeProof(server, facts.id, AttemptProof::Unproven);
  else if (server.number("SELECT COUNT(*) FROM verifications WHERE attempt = ?", facts.id) == 0)
    server.run("INSERT INTO verifications VALUES (?, ?, NULL, NULL, NULL, '')", facts.id, now_us);
  if (!acceptedBy.empty()) acceptAttempt(server, facts.id, acceptedBy);
}

}  // namespace insonate::store
