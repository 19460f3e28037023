#include "Classroom.h"
#include "ReviewSession.h"
#include "ReviewWindow.h"
#include "class/ClassTable.h"

#include <insonate/curriculum/FormStore.h>
#include <insonate/teaching/DemoClass.h>

#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>

namespace insonate::review {
namespace {

/// A class as `curriculum demo` makes it up, with its recordings beside the store.
class DemoClass : public Classroom {
 protected:
  void SetUp() override {
    curriculum_ = test::valueOf(loadCurriculum("central_line"));
    store_ = std::make_unique<CurriculumStore>(test::valueOf(CurriculumStore::open(file().toStdString(), services())));
    test::succeed(makeDemoClass(*store_, curriculum_, {.trainees = 3, .attempts = 6}, test::kPassword));
    ASSERT_TRUE(QDir(home_.path()).mkdir("attempts"));
    const QString recording = recorded(home_.filePath("attempts/people clean-success.attempt"));
    test::succeed(addRecordedAttempts(*store_, curriculum_, {recording.toStdString()}, test::kPassword));
  }
};

TEST_F(DemoClass, IsReplayedFromTheListAndJudged) {
  enter(kDemoInstructor);
  auto& people = *child<QTableView>("classTable");
  people.setCurrentIndex(people.model()->index(0, ClassTable::kName));
  people.setFocus();
  QTest::keyClick(&people, Qt::Key_Return);
  auto& history = *child<QTableWidget>("history");
  ASSERT_TRUE(QTest::qWaitFor([&] { return history.rowCount() == 7; }, kPatience_ms));
  EXPECT_EQ(history.item(0, 1)->text(), "First jugular line");
  EXPECT_EQ(history.item(0, 5)->text(), "on this computer");
  EXPECT_EQ(history.item(1, 5)->text(), "none");

  ASSERT_TRUE(child<QPushButton>("replayAttempt")->isEnabled());
  child<QPushButton>("replayAttempt")->click();
  auto* session = workspace_->findChild<ReviewSession*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return session->attempt() && !session->isOpening(); }, kPatience_ms));
  settle();
  if (!child<QToolButton>("judgeTab")->isChecked()) QTest::keyClick(child<QWidget>("timeline"), Qt::Key_4);
  ASSERT_TRUE(QTest::qWaitFor([&] { return isSeen("handIn"); }, kPatience_ms));
  EXPECT_TRUE(child<QLabel>("judgeWords")->text().contains("Made-up trainee 001"));
  const Form form = test::valueOf(loadForm("jugular_checklist"));
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) child<QRadioButton>(("form_" + item.name + "_done").c_str())->click();
  child<QPushButton>("handIn")->click();
  child<QPushButton>("handInConfirm")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return child<QToolButton>("readForms")->isChecked(); }, kPatience_ms));

  const SignedIn trainee = test::valueOf(store_->signIn("made-up-001", test::kPassword));
  const auto newest = test::valueOf(AttemptStore(trainee).page(trainee.person().id, 1));
  EXPECT_EQ(test::valueOf(FormStore(trainee).listByAttempt(newest.front().facts.id)).size(), 1u);
}

}  // namespace
}  // namespace insonate::review
