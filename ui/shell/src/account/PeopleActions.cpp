// Actions of the buttons in the window of people.
#include "ClassListDialog.h"
#include "CurriculumWindow.h"
#include "EntryDialog.h"
#include "PeopleWindow.h"
#include "RoleWords.h"

#include <insonate/curriculum/FirstPassword.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/Text.h>

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>

namespace insonate::ui {
namespace {

EntryDialog::Entry roleEntry(Role role) {
  return {.name = "personRole",
          .label = PeopleWindow::tr("Role"),
          .tip = PeopleWindow::tr("Instructors see the people of classes that they teach; administrators see everyone"),
          .text = nameOf(role),
          .choices = roleWords()};
}

}  // namespace

/// Action of an EntryDialog: queries the store and reads the shown data again.
EntryDialog::Action PeopleWindow::asking(std::function<Result<void>(const SignedIn&, const QStringList&)> what) {
  return [this, what = std::move(what)](const QStringList& texts, const std::function<void(Result<void>)>& done) {
    account_.query<void>(
        this, [what, texts](const SignedIn& by) { return what(by, texts); },
        [this, done](const Result<void>& result) {
          done(result);
          if (result) read();
        });
  };
}

void PeopleWindow::setCurriculum() {
  const int index = curriculum_->currentIndex() - 1;
  if (!cohort() || index < 0 || index >= int(curricula_.size())) return showCurricula();
  const OfferedCurriculum& one = curricula_[std::size_t(index)];
  const auto set = [one, cohort = cohort()->id](const SignedIn& by) { return teachBy(by, one, cohort); };
  if (cohort()->curriculum.empty()) return change(set);
  if (one.name == cohort()->curriculum && one.version == cohort()->curriculumVersion) return;
  auto* question = new EntryDialog(
      tr("Change the curriculum of the class?"),
      tr("The class %1 changes from %2, version %3, to %4, version %5. The progress of each trainee is computed again "
         "from the new levels.")
          .arg(qt(cohort()->name), qt(cohort()->curriculum), QString::number(cohort()->curriculumVersion), qt(one.name),
               QString::number(one.version)),
      {}, tr("Change curriculum"), asking([set](const SignedIn& by, const QStringList&) { return set(by); }), this);
  connect(question, &QDialog::rejected, this, &PeopleWindow::showCurricula);
  question->open();
}

void PeopleWindow::editLevels() {
  auto* levels = new CurriculumWindow(account_, this);
  connect(levels, &QDialog::finished, this, &PeopleWindow::read);
  levels->show();
}

void PeopleWindow::addClass() {
  const auto add = [](const SignedIn& by, const QStringList& texts) -> Result<void> {
    const auto added = CohortStore(by).add(texts[0].toStdString());
    return added ? Result<void>() : tl::unexpected(added.error());
  };
  (new EntryDialog(
       tr("New class"), tr("A class is a group of people who are taught together, by one curriculum."),
       {{"className", tr("Name"), tr("Name that instructors and trainees see")}}, tr("Add"),
       [this, act = asking(add)](const QStringList& texts, const std::function<void(Result<void>)>& done) {
         act(texts, [this, name = texts[0], done](const Result<void>& added) {
           if (added) newClass_ = name;
           done(added);
         });
       },
       this))
      ->open();
}

void PeopleWindow::renameClass() {
  if (!cohort()) return;
  const auto rename = [id = cohort()->id](const SignedIn& by, const QStringList& texts) {
    return CohortStore(by).rename(id, texts[0].toStdString());
  };
  (new EntryDialog(tr("Rename the class"), tr("A new name changes neither the people of the class nor their attempts."),
                   {{"className", tr("Name"), tr("Name that instructors and trainees see"), qt(cohort()->name)}},
                   tr("Rename"), asking(rename), this))
      ->open();
}

void PeopleWindow::archiveClass() {
  if (!cohort()) return;
  const auto set = [id = cohort()->id, archived = !cohort()->archived](const SignedIn& by, const QStringList&) {
    return CohortStore(by).archive(id, archived);
  };
  if (cohort()->archived) return change([set](const SignedIn& by) { return set(by, {}); });
  (new EntryDialog(tr("Archive the class %1?").arg(qt(cohort()->name)),
                   tr("Members, attempts and results stay visible, but you can neither add members nor open tests, and "
                      "open tests are closed. You can restore an archived class."),
                   {}, tr("Archive"), asking(set), this))
      ->open();
}

/// The name is typed, so that no other class is deleted by mistake.
void PeopleWindow::deleteClass() {
  if (!cohort()) return;
  const auto remove = [id = cohort()->id](const SignedIn& by, const QStringList& texts) {
    return CohortStore(by).remove(id, texts[0].toStdString());
  };
  (new EntryDialog(tr("Delete the class %1?").arg(qt(cohort()->name)),
                   tr("The class, its list of members and its openings of tests are deleted, and its instructors no "
                      "longer see the attempts of its trainees. Accounts, attempts with their results, and the audit "
                      "log stay. A deleted class cannot be restored; to keep a class that has ended, archive it."),
                   {{"className", tr("Name of the class"), tr("Type the name of the class to confirm")}}, tr("Delete"),
                   asking(remove), this))
      ->open();
}

void PeopleWindow::addPerson() {
  const std::string into = cohort() ? cohort()->id : "";
  const auto add = [into](const SignedIn& by, const QStringList& texts) -> Result<void> {
    const auto added = PeopleStore(by).add({.name = texts[0].toStdString(),
                                            .fullName = texts[1].toStdString(),
                                            .email = texts[2].toStdString(),
                                            .role = roleOf(texts.value(4))},
                                           texts[3].toStdString(), into);
    return added ? Result<void>() : tl::unexpected(added.error());
  };
  std::vector<EntryDialog::Entry> entries{
      {"personName", tr("Sign-in name"), tr("Name that consists of letters, digits and . _ - + @")},
      {"personFullName", tr("Full name"), tr("Name that other users see")},
      {"personEmail", tr("E-mail"), tr("Optional")},
      {"personPassword", tr("Password"),
       tr("First password of the person, who chooses another password at the first sign-in"),
       qt(generateFirstPassword())}};
  if (isAdministrator()) entries.push_back(roleEntry(Role::Trainee));
  const QString where = cohort() ? tr("The new person will join the class %1.").arg(qt(cohort()->name))
                                 : tr("The new person will not be in a class yet.");
  (new EntryDialog(
       tr("Add a person"), where, entries, tr("Add"),
       [this, act = asking(add)](const QStringList& texts, const EntryDialog::Done& done) {
         act(texts, [this, texts, done](const Result<void>& added) {
           done(added);
           if (added) showFirstPassword(texts[1].isEmpty() ? texts[0] : texts[1], texts[3]);
         });
       },
       this))
      ->open();
}

void PeopleWindow::showFirstPassword(const QString& name, const QString& password) {
  (new EntryDialog(
       tr("%1 was added").arg(name),
       tr("Give this first password to the person, who chooses another one at the first sign-in. The password is not "
          "shown again."),
       {{"firstPassword", tr("First password"), tr("Password for the first sign-in"), password}}, tr("Copy and close"),
       [](const QStringList& texts, const EntryDialog::Done& done) {
         QGuiApplication::clipboard()->setText(texts[0]);
         done({});
       },
       this))
      ->open();
}

void PeopleWindow::importList() {
  if (!cohort()) return;
  auto* dialog = new ClassListDialog(account_, *cohort(), this);
  connect(dialog, &ClassListDialog::imported, this, &PeopleWindow::read);
  dialog->open();
}

void PeopleWindow::editPerson() {
  if (!chosen() || !isAdministrator()) return;
  const auto edit = [person = chosen()->person](const SignedIn& by, const QStringList& texts) -> Result<void> {
    Person changed = person;
    changed.name = texts[0].toStdString(), changed.fullName = texts[1].toStdString();
    changed.email = texts[2].toStdString(), changed.role = roleOf(texts[3]);
    return PeopleStore(by).change(changed);
  };
  const Person& person = chosen()->person;
  (new EntryDialog(
       tr("Edit a person"), tr("Your changes do not affect the attempts and classes of the person."),
       {{"personName", tr("Sign-in name"), tr("Name that consists of letters, digits and . _ - + @"), qt(person.name)},
        {"personFullName", tr("Full name"), tr("Name that other users see"), qt(person.fullName)},
        {"personEmail", tr("E-mail"), tr("Optional"), qt(person.email)},
        roleEntry(person.role)},
       tr("Save"), asking(edit), this))
      ->open();
}

void PeopleWindow::setPassword() {
  if (!chosen()) return;
  const auto set = [id = chosen()->person.id](const SignedIn& by, const QStringList& texts) {
    return PeopleStore(by).resetPassword(id, texts[0].toStdString());
  };
  (new EntryDialog(tr("New password for %1").arg(qt(chosen()->person.fullName)),
                   tr("Give this password to the person; the password is not shown again. The person chooses another "
                      "password at the next sign-in."),
                   {{"personPassword", tr("Password"), tr("At least 8 characters"), qt(generateFirstPassword())}},
                   tr("Set"), asking(set), this))
      ->open();
}

void PeopleWindow::toggleDisabled() {
  if (!chosen()) return;
  Person person = chosen()->person;
  person.disabled = !person.disabled;
  change([person](const SignedIn& by) { return PeopleStore(by).change(person); });
}

void PeopleWindow::join() {
  if (!chosen()) return;
  change([cohort = target_->currentData().toString().toStdString(), person = chosen()->person.id,
          teaches = as_->currentData().toBool()](const SignedIn& by) {
    return CohortStore(by).join(cohort, person, teaches);
  });
}

void PeopleWindow::leave() {
  if (!chosen() || !cohort()) return;
  change([cohort = cohort()->id, person = chosen()->person.id](const SignedIn& by) {
    return CohortStore(by).leave(cohort, person);
  });
}

}  // namespace insonate::ui
