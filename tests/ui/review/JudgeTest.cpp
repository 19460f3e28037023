#include "Classroom.h"
#include "ReviewSession.h"
#include "ReviewWindow.h"
#include "judge/RatersPage.h"

#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/ui/Attempts.h>

#include <QAbstractButton>
#include <QAccessible>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolButton>
#include <map>

namespace insonate::review {
namespace {

/// Ina and Uta teach Anna, of whom one attempt is recorded here.
class JudgeTest : public Classroom {
 protected:
  void SetUp() override {
    Classroom::SetUp();
    const Person uta = school_->add("uta", Role::Instructor, school_->spring.id);
    test::succeed(CohortStore(school_->admin).join(school_->spring.id, uta.id, true));
    uta_ = uta;
    ASSERT_TRUE(QDir().mkpath(ui::attemptsFolder()));
    file_ = recorded(QDir(ui::attemptsFolder()).filePath("judged" + ui::kAttemptSuffix));
    attempt_ = keep(file_);
    form_ = test::valueOf(loadForm("jugular_checklist"));
  }
  void TearDown() override {
    Classroom::TearDown();
    QDir(ui::attemptsFolder()).removeRecursively();
  }

  std::string keep(const QString& file) const {
    AttemptFacts facts = test::valueOf(factsOfRecording(file.toStdString(), Hands::PersonOrScript));
    const AttemptStore anna(school_->as(school_->anna));
    facts.id = test::valueOf(anna.begin(facts));
    test::succeed(anna.end(facts));
    return facts.id;
  }
  /// By a command instead of the window.
  void judge(const Person& rater, const std::string& attempt, const std::string& first,
             const std::string& note = {}) const {
    FormAnswers answers;
    for (const FormSection& section : form_.sections)
      for (const FormItem& item : section.items) answers[item.name] = "done";
    answers["indication"] = first;
    if (!note.empty()) answers["indication:note"] = note;
    test::valueOf(FormStore(school_->as(rater))
                      .add({"", form_.name, form_.version, school_->anna.id, attempt, "", 0, answersText(answers)}));
  }

  void open(const QString& file) {
    workspace_->openAttempt(file);
    auto* session = workspace_->findChild<ReviewSession*>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->attempt() && !session->isOpening(); }, kPatience_ms));
    settle();
  }
  void openAndJudge() {
    open(file_);
    if (!child<QToolButton>("judgeTab")->isChecked()) QTest::keyClick(child<QWidget>("timeline"), Qt::Key_4);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isSeen("judgeWords"); }, kPatience_ms));
  }
  /// The form that is chosen at first, by the mouse.
  void fillIn(const QString& first) {
    for (const FormSection& section : form_.sections)
      for (const FormItem& item : section.items) child<QRadioButton>(("form_" + item.name + "_done").c_str())->click();
    child<QRadioButton>(("form_indication_" + first).toLatin1())->click();
  }
  void handIn() {
    child<QPushButton>("handIn")->click();
    EXPECT_TRUE(isSeen("handInConfirm"));
    child<QPushButton>("handInConfirm")->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return child<QToolButton>("readForms")->isChecked() && workspace_->isReady(); },
                                kPatience_ms));
  }
  void change(const std::string& name) {
    account_->signOut();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !account_->isSignedIn(); }, kPatience_ms));
    EXPECT_FALSE(isSeen("handIn")) << "nobody sits here";
    signIn(name);
    settle();
  }
  QString text(const char* name) { return child<QLabel>(name)->text(); }
  QTableWidget& table() { return *child<QTableWidget>("judgements"); }

  Person uta_;
  QString file_;
  std::string attempt_;
  Form form_;
};

TEST_F(JudgeTest, TheFormHasTheHeightOfALowWindow) {
  enter("ina");
  openAndJudge();
  auto* sheet = child<QScrollArea>("judgeSheet");
  for (const QSize size : {QSize(1229, 600), QSize(1366, 680)}) {
    workspace_->resize(size);
    EXPECT_TRUE(QTest::qWaitFor([&] { return sheet->viewport()->height() >= 300; }, kPatience_ms))
        << sheet->viewport()->height();
    EXPECT_GE(sheet->viewport()->width(), 300);
    EXPECT_TRUE(child<QWidget>("timeline")->isVisible()) << "judging refers to the replay";
  }
  child<QToolButton>("judgeTab")->click();
  EXPECT_FALSE(isSeen("judgeSheet"));
  EXPECT_TRUE(isSeen("replayScene"));
}

TEST_F(JudgeTest, TwoInstructorsJudgeAReplayBlindlyAndSeeWhereTheyDiffer) {
  enter("ina");
  openAndJudge();
  EXPECT_TRUE(child<QToolButton>("replayTab")->isChecked()) << "it is the replay that is judged";
  EXPECT_TRUE(text("judgeWords").contains("Dr anna")) << text("judgeWords").toStdString();
  EXPECT_TRUE(text("attemptFacts").startsWith("Dr anna")) << text("attemptFacts").toStdString();
  EXPECT_FALSE(isSeen("attemptNotice"));
  fillIn("done");
  child<QToolButton>("noteButton_indication")->click();
  const QString hostile = "<b>bold</b> & %1 \u202e=1+1";
  child<QLineEdit>("note_indication")->setText(hostile);
  QTest::keyClick(child<QWidget>("timeline"), Qt::Key_Right);
  EXPECT_GT(workspace_->findChild<ReviewSession*>()->time_us(), 0);
  EXPECT_TRUE(child<QRadioButton>("form_consent_done")->isChecked()) << "scrubbing takes nothing away";
  handIn();
  EXPECT_TRUE(workspace_->statusText().startsWith("The form is handed in")) << workspace_->statusText().toStdString();
  child<QToolButton>("fillForm")->click();
  EXPECT_FALSE(child<QPushButton>("handIn")->isEnabled()) << "a form can be handed in only once";
  EXPECT_TRUE(child<QPushButton>("handIn")->toolTip().contains("once"));
  auto& choice = *child<QComboBox>("judgeForm");
  choice.setCurrentIndex(1 - choice.currentIndex());
  EXPECT_TRUE(child<QPushButton>("handIn")->isEnabled()) << "another form is another word";
  choice.setCurrentIndex(1 - choice.currentIndex());
  child<QToolButton>("readForms")->click();
  EXPECT_EQ(table().columnCount(), 2);
  EXPECT_EQ(table().rowCount(), 22);
  EXPECT_EQ(table().item(0, 1)->text(), "Done: " + hostile);
  EXPECT_TRUE(text("judgementWords").contains("100 % (22 of 22 points)")) << text("judgementWords").toStdString();
  EXPECT_TRUE(text("judgementAgreement").contains("n/a"));

  change("uta");
  openAndJudge();
  EXPECT_EQ(child<QToolButton>("readForms")->text(), "Handed in (1)");
  EXPECT_FALSE(child<QRadioButton>("form_consent_done")->isChecked());
  child<QToolButton>("readForms")->click();
  EXPECT_TRUE(text("judgementWords").contains("Dr ina")) << text("judgementWords").toStdString();
  EXPECT_TRUE(text("judgementWords").contains("visible once you have handed in your own form"));
  EXPECT_FALSE(table().isVisible()) << "nobody is led by another's answers";
  child<QToolButton>("fillForm")->click();
  fillIn("not_done");
  handIn();
  ASSERT_EQ(table().columnCount(), 3);
  EXPECT_TRUE(table().item(0, 0)->text().startsWith(QChar(0x2260)));
  EXPECT_EQ(table().item(0, 2)->text(), "Not done, or done incorrectly");
  EXPECT_TRUE(text("judgementAgreement").contains("95 % of 22 answers equal"))
      << text("judgementAgreement").toStdString();
  EXPECT_TRUE(text("judgementAgreement").contains("ICC of the scores n/a")) << "of one attempt there is none";
  child<QAbstractButton>("onlyDiffering")->click();
  EXPECT_EQ(table().rowCount(), 1);

  const auto forms = test::valueOf(FormStore(school_->as(school_->anna)).listByAttempt(attempt_));
  ASSERT_EQ(forms.size(), 2U);
  EXPECT_EQ(forms[0].filled.by, school_->ina.id);
  EXPECT_EQ(forms[1].filled.by, uta_.id);
}

TEST_F(JudgeTest, WhatTheRecordingShowsIsFilledInUntilTheRaterAnswers) {
  const AttemptFacts facts = test::valueOf(AttemptStore(school_->admin).attempt(attempt_)).facts;
  const FormAnswers proposed = answersFrom(form_, facts.metrics);
  ASSERT_EQ(proposed.count("vein_told"), 1U);
  ASSERT_EQ(proposed.count("artery"), 0U) << "it never came to a puncture";
  ASSERT_EQ(proposed.count("consent"), 0U) << "no recording shows it";
  enter("ina");
  openAndJudge();
  EXPECT_EQ(child<QComboBox>("judgeForm")->currentText().toStdString(), form_.title) << "not that of the whole line";
  for (const auto& [item, answer] : proposed)
    EXPECT_TRUE(child<QRadioButton>(("form_" + item + "_" + std::get<std::string>(answer)).c_str())->isChecked())
        << item;
  EXPECT_FALSE(child<QRadioButton>("form_consent_done")->isChecked());
  EXPECT_TRUE(text("judgeProgress").contains("Check each one")) << text("judgeProgress").toStdString();
  const QString marked = text("evidence_vein_told");
  EXPECT_TRUE(marked.startsWith("◆ From the metrics: ")) << marked.toStdString();
  EXPECT_TRUE(isSeen("evidence_vein_told"));
  EXPECT_FALSE(isSeen("evidence_consent"));
  EXPECT_TRUE(text("judgeProgress").contains(QString("%1 of 22").arg(proposed.size())))
      << text("judgeProgress").toStdString();
  child<QRadioButton>("form_vein_told_not_seen")->click();
  EXPECT_TRUE(text("judgeProgress").contains("have no answer yet")) << text("judgeProgress").toStdString();
  QTest::keyClick(child<QWidget>("timeline"), Qt::Key_Right);
  EXPECT_TRUE(child<QRadioButton>("form_vein_told_not_seen")->isChecked()) << "the rater decides";
}

TEST_F(JudgeTest, HandingInIsFinalAndAskedOnce) {
  enter("ina");
  openAndJudge();
  fillIn("done");
  EXPECT_TRUE(text("judgeProgress").startsWith("All required items are answered")) << "nothing is missing";
  child<QPushButton>("handIn")->setFocus();
  QTest::keyClick(child<QPushButton>("handIn"), Qt::Key_Space);
  EXPECT_TRUE(test::valueOf(FormStore(school_->admin).listByAttempt(attempt_)).empty()) << "it only asks";
  EXPECT_TRUE(text("judgeProgress").contains("cannot be changed")) << text("judgeProgress").toStdString();
  EXPECT_EQ(QApplication::focusWidget(), child<QPushButton>("handInCancel")) << "a second Space does no harm";
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_FALSE(isSeen("handInConfirm"));
  EXPECT_TRUE(isSeen("handIn"));
  handIn();
  EXPECT_EQ(test::valueOf(FormStore(school_->admin).listByAttempt(attempt_)).size(), 1U);
}

TEST_F(JudgeTest, TheResultStatesWhyAnAttemptIsImplausible) {
  const QString fast = recorded(QDir(ui::attemptsFolder()).filePath("fast" + ui::kAttemptSuffix),
                                R"({"acts": [{"probe": "auto"}, {"wait_s": 3}]})");
  AttemptFacts facts = test::valueOf(factsOfRecording(fast.toStdString(), Hands::PersonOrScript));
  for (MetricFact& one : facts.metrics)
    if (one.id == "time_to_vein_s") one.value = 1.3;
  facts.succeeded = true;
  const AttemptStore anna(school_->as(school_->anna));
  facts.id = test::valueOf(anna.begin(facts));
  test::succeed(anna.end(facts));
  enter("ina");
  open(fast);
  EXPECT_TRUE(text("resultFlags").contains("implausibly fast: time to vein 1.3")) << text("resultFlags").toStdString();
  signIn("anna");
  open(fast);
  EXPECT_EQ(text("resultFlags"), "") << "the trainee sees no flags on any page";
}

TEST_F(JudgeTest, SigningOutClosesTheReplay) {
  enter("ina");
  openAndJudge();
  account_->signOut();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !account_->isSignedIn(); }, kPatience_ms));
  EXPECT_FALSE(workspace_->findChild<ReviewSession*>()->attempt());
  for (const char* shown : {"timeline", "resultPage", "judgeWords", "attemptTitle"})
    EXPECT_FALSE(isSeen(shown)) << shown;
  settle();
  signIn("ben");
  settle();
  EXPECT_FALSE(workspace_->findChild<ReviewSession*>()->attempt());
}

TEST_F(JudgeTest, AnAttemptThatIsBeingOpenedIsNotShownToTheNextUser) {
  enter("ina");
  workspace_->openAttempt(file_);
  signIn("ben");  // without signing out
  settle();
  QTest::qWait(500);
  EXPECT_FALSE(workspace_->findChild<ReviewSession*>()->attempt());
  open(file_);
  signIn("ina");
  EXPECT_FALSE(workspace_->findChild<ReviewSession*>()->attempt()) << "that of the former user";
}

TEST_F(JudgeTest, AGuestMaySignInToJudgeWhatIsReplayed) {
  enter("");
  openAndJudge();
  signIn("ina");
  settle();
  EXPECT_TRUE(workspace_->findChild<ReviewSession*>()->attempt());
  EXPECT_TRUE(isSeen("handIn"));
}

TEST_F(JudgeTest, WhoSignsOutWhileHandingInFindsNoDraft) {
  enter("ina");
  openAndJudge();
  fillIn("done");
  child<QPushButton>("handIn")->click();
  child<QPushButton>("handInConfirm")->click();
  account_->signOut();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !account_->isSignedIn(); }, kPatience_ms));
  signIn("ina");
  openAndJudge();
  EXPECT_EQ(test::valueOf(FormStore(school_->admin).listByAttempt(attempt_)).size(), 1U) << "it was handed in";
  EXPECT_FALSE(child<QRadioButton>("form_consent_done")->isChecked()) << "and would be handed in twice";
}

TEST_F(JudgeTest, WhatIsHalfFilledInIsNotLost) {
  enter("ina");
  openAndJudge();
  child<QRadioButton>("form_consent_done")->click();
  child<QPushButton>("handIn")->click();
  EXPECT_TRUE(child<QLabel>("trouble_indication")->text().contains("needs an answer"));
  EXPECT_TRUE(test::valueOf(FormStore(school_->admin).listByAttempt(attempt_)).empty());

  auto& choice = *child<QComboBox>("judgeForm");
  const int checklist = choice.currentIndex();
  choice.setCurrentIndex(1 - checklist);
  choice.setCurrentIndex(checklist);
  EXPECT_TRUE(child<QRadioButton>("form_consent_done")->isChecked()) << "another form was looked at";
  child<QPushButton>("backToList")->click();
  openAndJudge();
  EXPECT_TRUE(child<QRadioButton>("form_consent_done")->isChecked()) << "the attempt was left";
  change("uta");
  openAndJudge();
  EXPECT_FALSE(child<QRadioButton>("form_consent_done")->isChecked()) << "it is Ina's";
  workspace_.reset();
  account_.reset();
  enter("ina");
  openAndJudge();
  EXPECT_TRUE(child<QRadioButton>("form_consent_done")->isChecked()) << "the program was closed";
}

TEST_F(JudgeTest, TheTraineeReadsAndFillsInNothing) {
  judge(school_->ina, attempt_, "not_done", "<img src='x'> %1");
  enter("anna");
  openAndJudge();
  EXPECT_FALSE(isSeen("fillForm"));
  EXPECT_FALSE(isSeen("handIn"));
  EXPECT_EQ(table().item(0, 1)->text(), "Not done, or done incorrectly: <img src='x'> %1");
  EXPECT_TRUE(text("judgeWords").contains("Your attempt"));
  change("ben");
  openAndJudge();
  EXPECT_TRUE(text("judgeWords").startsWith("You do not have the permission for this"))
      << text("judgeWords").toStdString();
  EXPECT_FALSE(table().isVisible());
}

TEST_F(JudgeTest, WhoTeachesAnotherClassReadsAndJudgesNothing) {
  judge(school_->ina, attempt_, "not_done", "between us");
  enter("otto");
  openAndJudge();
  EXPECT_TRUE(text("judgeWords").startsWith("You do not have the permission for this"))
      << text("judgeWords").toStdString();
  EXPECT_FALSE(isSeen("handIn"));
  EXPECT_FALSE(table().isVisible());
  child<QPushButton>("backToList")->click();
  child<QToolButton>("ratersTab")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("raterWords").contains("in 'Autumn'"); }, kPatience_ms))
      << text("raterWords").toStdString();
  EXPECT_TRUE(text("raterWords").contains("0 attempts, of which 0")) << text("raterWords").toStdString();
  EXPECT_FALSE(isSeen("raterPairs"));
}

TEST_F(JudgeTest, AnAdministratorJudgesInAnyClass) {
  judge(school_->ina, attempt_, "not_done");
  enter("admin");
  openAndJudge();
  EXPECT_TRUE(text("judgeWords").contains("Dr anna")) << text("judgeWords").toStdString();
  child<QToolButton>("readForms")->click();
  EXPECT_TRUE(text("judgementWords").contains("visible once you have handed in your own form")) << "whoever it is";
  child<QToolButton>("fillForm")->click();
  fillIn("done");
  handIn();
  EXPECT_EQ(table().columnCount(), 3);
}

TEST_F(JudgeTest, AGuestIsAskedToSignIn) {
  enter("");
  openAndJudge();
  EXPECT_TRUE(text("judgeWords").contains("Ctrl+L"));
  EXPECT_FALSE(isSeen("handIn"));
}

TEST_F(JudgeTest, AChangedRecordingIsNotReplayedAsTheTrainees) {
  ASSERT_TRUE(QFile::remove(file_));
  recorded(file_, R"({"acts": [{"probe": "auto"}, {"wait_s": 2}]})");
  enter("ina");
  openAndJudge();
  EXPECT_TRUE(isSeen("attemptNotice"));
  EXPECT_TRUE(text("attemptNotice").contains("not the recording of the attempt of Dr anna"))
      << text("attemptNotice").toStdString();
  EXPECT_FALSE(isSeen("handIn"));
  const QString practice = recorded(QDir(ui::attemptsFolder()).filePath("practice" + ui::kAttemptSuffix));
  open(practice);
  EXPECT_FALSE(text("attemptNotice").contains("Dr anna"));
  EXPECT_TRUE(text("judgeWords").contains("no stored attempt"));
}

TEST_F(JudgeTest, ARecordingFromElsewhereIsCheckedAgainstTheAttemptItIsChosenAs) {
  const QString copy = recorded(QDir(ui::attemptsFolder()).filePath("copied" + ui::kAttemptSuffix));
  StoreServices elsewhere = services();
  elsewhere.workstation = "ward 8";
  const auto store = test::valueOf(CurriculumStore::open(file().toStdString(), elsewhere));
  const AttemptStore anna(test::valueOf(store.signIn("anna", test::kPassword)));
  AttemptFacts facts = test::valueOf(factsOfRecording(copy.toStdString(), Hands::PersonOrScript));
  facts.recordingHash = std::string(64, 'a'), facts.handsHash.clear();
  facts.id = test::valueOf(anna.begin(facts));
  test::succeed(anna.end(facts));
  enter("ina");
  Q_EMIT workspace_->findChild<ReviewHome*>()->replayRequested(copy, QString::fromStdString(facts.id));
  ASSERT_TRUE(QTest::qWaitFor([&] { return isSeen("attemptNotice"); }, kPatience_ms));
  EXPECT_TRUE(text("attemptNotice").contains("made on ward 8")) << text("attemptNotice").toStdString();
}

TEST_F(JudgeTest, TheRatersOfAClassAreComparedAndSaved) {
  enter("ina");
  child<QToolButton>("ratersTab")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("raterWords").contains("nothing to compare"); }, kPatience_ms));
  EXPECT_FALSE(isSeen("raterPairs"));
  EXPECT_FALSE(child<QPushButton>("saveRaters")->isEnabled());

  const std::string second = keep(recorded(QDir(ui::attemptsFolder()).filePath("second" + ui::kAttemptSuffix),
                                           R"({"acts": [{"probe": "auto"}, {"wait_s": 3}]})"));
  for (const std::string& attempt : {attempt_, second}) judge(school_->ina, attempt, "done");
  judge(uta_, attempt_, "done"), judge(uta_, second, "not_done");
  child<QToolButton>("classTab")->click();
  child<QToolButton>("ratersTab")->click();
  auto& pairs = *child<QTableWidget>("raterPairs");
  ASSERT_TRUE(QTest::qWaitFor([&] { return pairs.rowCount() == 1 && pairs.isVisible(); }, kPatience_ms));
  EXPECT_EQ(pairs.item(0, 0)->text(), "Dr ina and Dr uta");
  EXPECT_EQ(pairs.item(0, 1)->text(), "2");
  EXPECT_EQ(pairs.item(0, 3)->text(), "98 %");
  auto& items = *child<QTableWidget>("raterItems");
  ASSERT_EQ(items.rowCount(), 22);
  EXPECT_EQ(items.item(0, 2)->text(), "50 %");
  EXPECT_EQ(items.item(1, 3)->text(), "n/a") << "always done: chance alone would agree";
  const QString file = home_.filePath("raters.csv");
  workspace_->findChild<RatersPage*>()->saveTable(file);
  QFile saved(file);
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_EQ(test::valueOf(parseCsv(saved.readAll().toStdString())).size(), 24U);

  change("anna");
  EXPECT_FALSE(isSeen("ratersTab"));
}

TEST_F(JudgeTest, EveryControlHasANameAndATooltipAndIsReachedByKeyboard) {
  enter("ina");
  openAndJudge();
  std::map<QWidget*, int> focused;
  child<QComboBox>("judgeForm")->setFocus();
  for (int i = 0; i < 120; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    ++focused[QApplication::focusWidget()];
  }
  for (const char* name : {"handIn", "fillForm", "judgeForm", "noteButton_consent"})
    EXPECT_TRUE(focused.count(child<QWidget>(name))) << name;
  child<QWidget>("fillForm")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
  EXPECT_EQ(QApplication::focusWidget(), child<QWidget>("readForms"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_TRUE(child<QToolButton>("readForms")->isChecked()) << "arrows go from tab to tab";
  child<QToolButton>("fillForm")->click();
  int seen = 0;
  for (QWidget* one : workspace_->findChildren<QWidget*>()) {
    const bool control = qobject_cast<QAbstractButton*>(one) || qobject_cast<QLineEdit*>(one) ||
                         qobject_cast<QPlainTextEdit*>(one) || qobject_cast<QComboBox*>(one);
    if (!control || !one->isVisible() || one->objectName().startsWith("qt_")) continue;
    ++seen;
    QAccessibleInterface* said = QAccessible::queryAccessibleInterface(one);
    EXPECT_FALSE(said->text(QAccessible::Name).isEmpty()) << one->objectName().toStdString();
    EXPECT_FALSE(one->toolTip().isEmpty()) << one->objectName().toStdString();
  }
  EXPECT_GT(seen, 60);
}

TEST_F(JudgeTest, BackspaceInTheSheetDoesNotLeaveTheAttempt) {
  enter("ina");
  openAndJudge();
  auto& button = *child<QRadioButton>("form_consent_done");
  button.setFocus();
  QTest::keyClick(&button, Qt::Key_Backspace);
  EXPECT_TRUE(workspace_->findChild<ReviewSession*>()->attempt());
}

}  // namespace
}  // namespace insonate::review
