#include "Classroom.h"
#include "ReviewSession.h"
#include "ReviewWindow.h"
#include "comments/CommentList.h"

#include <insonate/curriculum/CommentStore.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/Workspace.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>

namespace insonate::review {
namespace {

/// Ina teaches Anna, of whom one attempt is recorded here.
class CommentTest : public Classroom {
 protected:
  void SetUp() override {
    Classroom::SetUp();
    ASSERT_TRUE(QDir().mkpath(ui::attemptsFolder()));
    file_ = recorded(QDir(ui::attemptsFolder()).filePath("commented" + ui::kAttemptSuffix));
    AttemptFacts facts = test::valueOf(factsOfRecording(file_.toStdString(), Hands::PersonOrScript));
    const AttemptStore anna(school_->as(school_->anna));
    facts.id = attempt_ = test::valueOf(anna.begin(facts));
    test::succeed(anna.end(facts));
  }
  void TearDown() override {
    Classroom::TearDown();
    QDir(ui::attemptsFolder()).removeRecursively();
  }

  void open() {
    workspace_->openAttempt(file_);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session().attempt() && !session().isOpening(); }, kPatience_ms));
    settle();
  }
  void close() {
    child<QPushButton>("backToList")->click();
    settle();
  }
  ReviewSession& session() { return *workspace_->findChild<ReviewSession*>(); }
  Timeline& timeline() { return *static_cast<Timeline*>(child<QWidget>("timeline")); }
  CommentList& list() { return *static_cast<CommentList*>(child<QListWidget>("comments")); }
  QPlainTextEdit& field() { return *child<QPlainTextEdit>("commentText"); }
  QString words() { return child<QLabel>("commentWords")->text(); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&timeline(), key, modifiers);
  }
  void write(double at_s, const QString& text) {
    session().setTime(std::int64_t(at_s * 1e6));
    const int before = list().count();
    key(Qt::Key_C);
    QTest::keyClicks(&field(), text);
    QTest::keyClick(&field(), Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return list().count() == before + 1 && workspace_->isReady(); }, kPatience_ms));
  }
  std::vector<AttemptComment> stored() { return test::valueOf(CommentStore(school_->admin).listByAttempt(attempt_)); }
  /// Text of the cell of comments in the list of the person's attempts.
  QString historyCell() {
    auto& table = *child<QTableWidget>("history");
    return table.rowCount() ? table.item(0, table.columnCount() - 1)->text() : QString("no row");
  }
  QByteArray fileHash() {
    QFile file(file_);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return QCryptographicHash::hash(file.readAll(), QCryptographicHash::Sha256);
  }

  QString file_;
  std::string attempt_;
};

TEST_F(CommentTest, TheInstructorPinsCommentsThatMarksAndListFind) {
  const QByteArray before = fileHash();
  enter("ina");
  open();
  EXPECT_EQ(words(), "No comments");
  EXPECT_FALSE(isSeen("comments"));
  const int height = timeline().height();
  write(3.5, "Withdraw, then <b>redirect</b>.");
  write(1.0, "Good start");
  EXPECT_EQ(fileHash(), before) << "the recording does not change";
  ASSERT_EQ(stored().size(), 2U);
  EXPECT_EQ(stored()[1].at_us, 3'500'000);
  EXPECT_EQ(stored()[1].text, "Withdraw, then <b>redirect</b>.");
  EXPECT_EQ(words(), "Comments: 2, 2 unread by the trainee");
  EXPECT_TRUE(list().item(0)->text().startsWith("0:01.00   Good start\nDr ina, "))
      << list().item(0)->text().toStdString();
  EXPECT_TRUE(list().item(0)->text().endsWith(", unread"));
  EXPECT_GT(timeline().height(), height) << "the marks have a lane of their own";

  const QPoint mark(timeline().xOf(3'500'000), 24 + 6 + 9);
  EXPECT_EQ(timeline().commentAt(mark), 1);
  EXPECT_EQ(timeline().commentAt({timeline().xOf(2'200'000), mark.y()}), -1);
  QTest::mouseClick(&timeline(), Qt::LeftButton, {}, mark + QPoint(3, 0));
  EXPECT_EQ(session().time_us(), 3'500'000);
  EXPECT_EQ(list().currentRow(), 1);
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(0)).center());
  EXPECT_EQ(session().time_us(), 1'000'000);
  key(Qt::Key_PageDown, Qt::ControlModifier);
  EXPECT_EQ(session().time_us(), 3'500'000);
  key(Qt::Key_PageUp, Qt::ControlModifier);
  EXPECT_EQ(session().time_us(), 1'000'000);
  close();
  EXPECT_FALSE(timeline().commentAt(mark) >= 0 && session().attempt());
}

TEST_F(CommentTest, TheTraineeReadsThemAndTheCountOfUnreadOnesFalls) {
  test::valueOf(CommentStore(school_->as(school_->ina)).add(attempt_, 2'000'000, "Hold the probe still"));
  enter("anna");
  ASSERT_TRUE(QTest::qWaitFor([&] { return historyCell() == "1, 1 unread"; }, kPatience_ms))
      << historyCell().toStdString();
  open();
  EXPECT_EQ(words(), "Comments: 1, 1 unread") << "it stays marked while it is read";
  EXPECT_TRUE(isSeen("comments"));
  EXPECT_FALSE(isSeen("writeComment"));
  key(Qt::Key_C);
  EXPECT_FALSE(field().isVisible()) << "only instructors comment";
  EXPECT_TRUE(stored()[0].isRead);
  close();
  ASSERT_TRUE(QTest::qWaitFor([&] { return historyCell() == "1"; }, kPatience_ms)) << historyCell().toStdString();
  open();
  EXPECT_EQ(words(), "Comments: 1");
}

TEST_F(CommentTest, RemovingAsksAndIsForAuthorAndAdministratorAlone) {
  const Person uta = school_->add("uta", Role::Instructor, school_->spring.id);
  test::succeed(CohortStore(school_->admin).join(school_->spring.id, uta.id, true));
  test::valueOf(CommentStore(school_->as(uta)).add(attempt_, 1'000'000, "Uta's"));
  test::valueOf(CommentStore(school_->as(school_->ina)).add(attempt_, 3'000'000, "Ina's"));
  enter("ina");
  open();
  session().setTime(1'000'000);
  EXPECT_FALSE(child<QPushButton>("removeComment")->isEnabled()) << "it is another's";
  session().setTime(3'000'000);
  EXPECT_TRUE(child<QPushButton>("removeComment")->isEnabled());
  key(Qt::Key_Delete, Qt::ControlModifier);
  EXPECT_TRUE(isSeen("commentQuestion"));
  child<QPushButton>("keepComment")->click();
  EXPECT_FALSE(isSeen("commentQuestion"));
  EXPECT_EQ(stored().size(), 2U) << "a slip removes nothing";
  key(Qt::Key_Delete, Qt::ControlModifier);
  child<QPushButton>("removeCommentNow")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return list().count() == 1 && workspace_->isReady(); }, kPatience_ms));
  ASSERT_EQ(stored().size(), 1U);
  EXPECT_EQ(stored()[0].text, "Uta's");
}

TEST_F(CommentTest, AnUnsavedTextIsKeptWithItsTime) {
  enter("ina");
  open();
  session().setTime(2'000'000);
  key(Qt::Key_C);
  QTest::keyClicks(&field(), "Half a sen");
  QTest::keyClick(&field(), Qt::Key_Backspace);
  EXPECT_TRUE(session().attempt()) << "Backspace edits the text";
  EXPECT_FALSE(isSeen("writeComment")) << "the field has buttons of its own";
  QTest::keyClick(&field(), Qt::Key_Escape);
  EXPECT_FALSE(field().isVisible());
  EXPECT_TRUE(isSeen("writeComment"));
  EXPECT_TRUE(stored().empty());
  close();
  open();
  session().setTime(4'000'000);
  key(Qt::Key_C);
  EXPECT_EQ(field().toPlainText(), "Half a se");
  EXPECT_TRUE(child<QLabel>("commentTime")->text().contains("0:02.00"));
  QTest::keyClicks(&field(), "ntence");
  QTest::keyClick(&field(), Qt::Key_Return, Qt::ShiftModifier);
  QTest::keyClicks(&field(), "and a line");
  child<QPushButton>("saveComment")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return list().count() == 1 && workspace_->isReady(); }, kPatience_ms));
  EXPECT_EQ(stored()[0].text, "Half a sentence\nand a line");
  EXPECT_EQ(stored()[0].at_us, 2'000'000);
  key(Qt::Key_C);
  EXPECT_EQ(field().toPlainText(), "") << "it is saved";
}

TEST_F(CommentTest, OthersSeeNone) {
  test::valueOf(CommentStore(school_->as(school_->ina)).add(attempt_, 2'000'000, "between us"));
  for (const std::string name : {"", "ben", "otto"}) {
    enter(name);
    open();
    EXPECT_FALSE(isSeen("commentWords")) << name;
    EXPECT_EQ(list().count(), 0) << name;
    workspace_.reset();
    account_.reset();
  }
}

}  // namespace
}  // namespace insonate::review
