#pragma once

#include "NeedleWindow.h"
#include "attempt/AttemptControl.h"
#include "levels/Course.h"
#include "levels/LevelControl.h"
#include "levels/UnsentFacts.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/RecentCases.h>

#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QTemporaryDir>
#include <memory>
#include <optional>

namespace insonate::train {

/// The workspace over a store with a class of one trainee, who learns by a curriculum of two levels on the wide case.
class LevelWindow : public NeedleWindow {
 protected:
  static constexpr const char *kPassword = "a long sentence", *kTrainee = "tess";

  void SetUp() override {
    QSettings().clear();
    QDir(ui::attemptsFolder()).removeRecursively();
    QDir(home_.path()).mkdir("wide");
    ui::rememberCase({home_.filePath("wide"), kWideTitle});
    fillStore();
    account_ = std::make_unique<ui::Account>(storeFile(), cheap());
    NeedleWindow::SetUp();
    QObject::connect(workspace_.get(), &ui::Workspace::caseRequested,
                     [this](const QString& place) { wanted_ << place; });
    workspace_->setAccount(*account_);
    QApplication::setActiveWindow(workspace_.get());
    attempt_ = workspace_->findChild<AttemptControl*>();
    course_ = workspace_->findChild<Course*>();
    levels_ = workspace_->findChild<LevelControl*>();
    ASSERT_TRUE(attempt_ && course_ && levels_);
    workspace_->setOrigin({home_.filePath("wide"), {}, false, {}, home_.filePath("wide")});
    ASSERT_TRUE(waitFor([&] { return account_->state() == ui::Account::State::Guest; }));
  }
  void TearDown() override {
    workspace_ = nullptr;
    account_ = nullptr;
  }

  /// Or a server's address.
  virtual QString storeFile() const { return home_.filePath("people.sqlite"); }
  static StoreServices cheap() { return {.passwordCost = PasswordCost::Minimum}; }

  /// "first" is passed once without a puncture of the artery; "second" builds on it.
  virtual Curriculum curriculum() const {
    Level first;
    first.name = "first", first.title = "The first one", first.about = "Reach the vein.";
    first.caseName = kWideTitle, first.procedure = "internal_jugular", first.position = "Trendelenburg 15";
    first.pass.standards = {{"artery_punctures", 1, {}, 0, "the artery was punctured", "a test"},
                            {"passes", 1, {}, 1, "there were too many passes", "a test"}};
    first.mastery.source = "a test";
    Level second = first;
    second.name = "second", second.title = "The second one", second.prerequisites = {"first"};
    second.assistance = Assistance::Hints;
    return {"course", "A course", "", 1, {first, second}};
  }

  void fillStore() {
    auto store = CurriculumStore::open(storeFile().toStdString(), cheap());
    ASSERT_TRUE(store) << store.error().message;
    const auto admin =
        store->createFirstAdministrator({"admin", "An Administrator", "", Role::Administrator}, kPassword);
    ASSERT_TRUE(admin) << admin.error().message;
    const Curriculum course = curriculum();
    ASSERT_TRUE(PublishedCurricula(*admin).publish(course.name, course.version, curriculumText(course)));
    const auto cohort = CohortStore(*admin).add("Class of 2026");
    ASSERT_TRUE(cohort && CohortStore(*admin).setCurriculum(cohort->id, course.name, course.version));
    const auto person =
        PeopleStore(*admin).add({kTrainee, traineeName(), "", Role::Trainee}, "first password", cohort->id);
    ASSERT_TRUE(person) << person.error().message;
    const auto trainee = store->signIn(kTrainee, "first password");
    ASSERT_TRUE(trainee && PeopleStore(*trainee).changeOwnPassword("first password", kPassword));
  }
  virtual std::string traineeName() const { return "Tess Trainee"; }

  /// As someone, beside the window.
  SignedIn at(const char* name) {
    if (!beside_) beside_ = *CurriculumStore::open(storeFile().toStdString(), cheap());
    return *beside_->signIn(name, kPassword);
  }

  void signIn() {
    std::optional<Result<void>> done;
    account_->signIn(kTrainee, kPassword, [&](const Result<void>& result) { done = result; });
    ASSERT_TRUE(waitFor([&] { return done.has_value(); }));
    ASSERT_TRUE(*done) << done->error().message;
    ASSERT_TRUE(waitFor([&] { return course_->curriculum() && course_->curriculum()->name == "course"; }))
        << course_->error().toStdString();
  }
  std::vector<StoredAttempt> stored() {
    const SignedIn by = at(kTrainee);
    return AttemptStore(by).page(by.person().id, 100).value_or(std::vector<StoredAttempt>{});
  }
  QStringList unsent() const { return QDir(unsentFolder()).entryList(QDir::Files); }

  /// Into the vein, which is what an attempt succeeds by.
  void makeAttempt() {
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); })) << workspace_->statusText().toStdString();
    overTheVein();
    type("needle_depth", "12");
    ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
    finish();
  }
  void finish() {
    ASSERT_TRUE(waitFor([&] { return attempt_->view().time_s > 1.2; })) << "the key finishes nothing at once";
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt_->state() == AttemptControl::State::Over; }));
  }
  QString text(const char* label) { return child<QLabel>(label)->text(); }
  bool shown(const char* widget) { return child<QWidget>(widget)->isVisible(); }

  QTemporaryDir home_;
  std::optional<CurriculumStore> beside_;
  std::unique_ptr<ui::Account> account_;
  AttemptControl* attempt_ = nullptr;
  Course* course_ = nullptr;
  LevelControl* levels_ = nullptr;
  QStringList wanted_;  ///< cases
};

}  // namespace insonate::train
