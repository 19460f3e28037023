#include "store/AttemptRows.h"
#include "store/FormRows.h"
#include "store/Outbox.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/FormStore.h>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Transaction;

Result<void> checkFilled(const FilledForm& filled) {
  if (!store::isUuid(filled.id))
    return fail("'" + filled.id.substr(0, 100) + "' is no UUID in lower case; a form's id is one.");
  if (auto ok = store::checkTitle("The form's name", filled.form); !ok) return ok;
  if (filled.form.empty() || filled.formVersion < 1)
    return fail("The form has no name or no version; say which form was filled in.");
  return store::checkJsonObject("The answers", filled.answers);
}

Result<std::string> keep(Transaction& transaction, const Core& core, const FilledForm& filled) {
  if (!store::findPerson(transaction, filled.person)) return fail("There is no such person; look at the list again.");
  if (!filled.attempt.empty()) {
    const auto attempt = store::findAttempt(transaction, filled.attempt);
    if (!attempt || attempt->facts.person != filled.person)
      return fail("The attempt is not one of the person whom the form is about; choose one of theirs.");
  }
  auto id = store::keepForm(transaction, filled);
  if (id) store::putIntoOutbox(transaction, core, "form", *id);
  return id;
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

Result<std::vector<FilledForm>> FormStore::ofPerson(const std::string& person) const {
  return by_.session()->read(
      {.act = Act::SeeForms, .person = person},
      [&](Transaction& transaction, const Actor&) -> Result<std::vector<FilledForm>> {
        return store::allFilled(
            transaction.rows("SELECT " INSONATE_FORM_COLUMNS " FROM forms WHERE person = ? ORDER BY arrival", person));
      });
}

Result<std::vector<FilledForm>> FormStore::ofAttempt(const std::string& attempt) const {
  return by_.session()->read(
      {.act = Act::SeeForms, .attempt = attempt},
      [&](Transaction& transaction, const Actor&) -> Result<std::vector<FilledForm>> {
        return store::allFilled(transaction.rows(
            "SELECT " INSONATE_FORM_COLUMNS " FROM forms WHERE attempt = ? ORDER BY arrival", attempt));
      });
}

Result<std::vector<FilledForm>> FormStore::ofCohort(const std::string& cohort, const std::string& form) const {
  return by_.session()->read(
      {.act = Act::SeeCohortForms, .cohort = cohort},
      [&](Transaction& transaction, const Actor&) -> Result<std::vector<FilledForm>> {
        return store::allFilled(transaction.rows("SELECT " INSONATE_FORM_COLUMNS
                                                 " FROM memberships JOIN forms ON forms.person = memberships.person "
                                                 "WHERE cohort = ? AND teaches = 0 AND form = ? ORDER BY arrival",
                                                 cohort, form));
      });
}

}  // namespace insonate
