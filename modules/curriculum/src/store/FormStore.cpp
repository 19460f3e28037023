#include "store/AttemptRows.h"
#include "store/FormRows.h"
#include "store/Outbox.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/FormStore.h>

#include <set>
#include <string>
#include <vector>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Transaction;

Result<void> checkFilled(const FilledForm& filled) {
  if (!store::isUuid(filled.id))
    return fail("'" + filled.id.substr(0, 100) + "' is not a UUID in lower case, but the id of a form must be one.");
  if (auto ok = store::checkTitle("The form's name", filled.form); !ok) return ok;
  if (filled.form.empty() || filled.formVersion < 1)
    return fail("The form has no name or no version. State which form was filled in.");
  return store::checkJsonObject("The answers", filled.answers);
}

/// A rater submits a form about an attempt once, since a second form would be filled in with knowledge of the others'
/// answers. The same form sent again has the same id.
Result<void> checkOnce(Transaction& transaction, const FilledForm& filled) {
  if (filled.attempt.empty()) return {};
  if (transaction.number("SELECT COUNT(*) FROM forms WHERE attempt = ? AND form = ? AND filled_by = ? AND id <> ?",
                         filled.attempt, filled.form, filled.by, filled.id) == 0)
    return {};
  return fail("You have handed in '" + filled.form +
              "' about this attempt already, and a form can be handed in only once. You can read it among the forms of "
              "the attempt.");
}

Result<std::string> keep(Transaction& transaction, const Core& core, const FilledForm& filled) {
  if (!store::findPerson(transaction, filled.person)) return fail("There is no such person; reload the list.");
  if (!filled.attempt.empty()) {
    const auto attempt = store::findAttempt(transaction, filled.attempt);
    if (!attempt || attempt->facts.person != filled.person)
      return fail("The attempt is not one of the person whom the form is about. Choose an attempt of this person.");
  }
  if (auto ok = store::checkTakesTexts(transaction, filled.person); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkOnce(transaction, filled); !ok) return tl::unexpected(ok.error());
  auto id = store::storeForm(transaction, filled);
  if (id) store::putIntoOutbox(transaction, core, "form", *id);
  return id;
}

constexpr std::string_view kKept =
    "SELECT " INSONATE_KEPT_FORM_COLUMNS " FROM forms JOIN people AS raters ON raters.id = forms.filled_by ";

std::vector<store::Row> rowsOfCohort(Transaction& transaction, const std::string& cohort, const std::string& form) {
  return transaction.rows(std::string(kKept) +
                              "JOIN memberships ON memberships.person = forms.person "
                              "WHERE cohort = ? AND teaches = 0 AND form = ? ORDER BY arrival",
                          cohort, form);
}

}  // namespace

Result<std::string> FormStore::add(const FilledForm& filled) const {
  const Core& core = by_.session()->core();
  FilledForm kept = filled;
  kept.by = by_.person().id;
  kept.filled_us = core.now_us();
  if (kept.id.empty()) kept.id = store::freshUuid();
  if (auto ok = checkFilled(kept); !ok) return tl::unexpected(ok.error());
  return by_.session()->write({.act = Act::FillForm, .person = kept.person, .detail = kept.form},
                              [&](Transaction& transaction, const Actor&) { return keep(transaction, core, kept); });
}

Result<std::vector<StoredForm>> FormStore::listByPerson(const std::string& person) const {
  return by_.session()->read(
      {.act = Act::SeeForms, .person = person},
      [&](Transaction& transaction, const Actor& actor) -> Result<std::vector<StoredForm>> {
        return store::allStored(
            transaction.rows(std::string(kKept) + "WHERE forms.person = ? ORDER BY arrival", person), actor.id);
      });
}

Result<std::vector<StoredForm>> FormStore::listByAttempt(const std::string& attempt) const {
  return by_.session()->read({.act = Act::SeeForms, .attempt = attempt},
                             [&](Transaction& transaction, const Actor& actor) -> Result<std::vector<StoredForm>> {
                               return store::allStored(
                                   transaction.rows(std::string(kKept) + "WHERE attempt = ? ORDER BY arrival", attempt),
                                   actor.id);
                             });
}

Result<std::vector<StoredForm>> FormStore::listByCohort(const std::string& cohort, const std::string& form) const {
  return by_.session()->read({.act = Act::SeeCohortForms, .cohort = cohort},
                             [&](Transaction& transaction, const Actor& actor) -> Result<std::vector<StoredForm>> {
                               return store::allStored(rowsOfCohort(transaction, cohort, form), actor.id);
                             });
}

Result<FormAgreement> FormStore::agreement(const std::string& cohort, const Form& form) const {
  return by_.session()->read(
      {.act = Act::SeeCohortForms, .cohort = cohort, .detail = "agreement"},
      [&](Transaction& transaction, const Actor& actor) -> Result<FormAgreement> {
        std::vector<StoredForm> all;
        std::set<std::string> judgedByReader;
        for (const store::Row& row : rowsOfCohort(transaction, cohort, form.name)) {
          all.push_back(store::storedFormOf(row));
          if (all.back().filled.by == actor.id) judgedByReader.insert(all.back().filled.attempt);
        }
        if (!judgedByReader.empty())
          std::erase_if(all, [&](const StoredForm& one) { return !judgedByReader.contains(one.filled.attempt); });
        return agreementOf(form, all);
      });
}

}  // namespace insonate
