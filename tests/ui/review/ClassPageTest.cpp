#include "Classroom.h"
#include "class/ClassTable.h"
#include "class/HeatColors.h"

#include <insonate/ui/DayWatch.h>

#include <ui/support/AccessibleNames.h>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>

namespace insonate::review {
namespace {

QString cell(QTableView& table, int row, int column) {
  return table.model()->index(row, column).data().toString();
}

int rowOf(QTableView& table, const QString& person) {
  for (int row = 0; row < table.model()->rowCount(); ++row)
    if (cell(table, row, ClassTable::kName) == person) return row;
  return -1;
}

class ClassPageTest : public Classroom {
 protected:
  QTableView& table() { return *child<QTableView>("classTable"); }
  int column(const QString& title) {
    for (int i = 0; i < table().model()->columnCount(); ++i)
      if (table().model()->headerData(i, Qt::Horizontal).toString().startsWith(title)) return i;
    ADD_FAILURE() << title.toStdString();
    return 0;
  }
};

TEST_F(ClassPageTest, ShowsWhoIsHowFarAndWhoNeedsHelp) {
  practise(school_->as(school_->anna), true, 3);
  practise(school_->as(school_->ben), false, kStuckAfter);
  enter("ina");
  EXPECT_TRUE(isSeen("classTab") && isSeen("classTable"));
  EXPECT_EQ(child<QComboBox>("cohorts")->currentText(), "Spring");
  ASSERT_EQ(table().model()->rowCount(), 2) << "teachers are no rows";
  const int ben = rowOf(table(), "Dr ben"), anna = rowOf(table(), "Dr anna");
  EXPECT_EQ(cell(table(), ben, ClassTable::kNeeds), "stuck");
  EXPECT_EQ(cell(table(), anna, ClassTable::kNeeds), "");
  EXPECT_EQ(cell(table(), anna, ClassTable::kAttempts), "3");
  EXPECT_EQ(cell(table(), ben, column("Artery")), "2");
  EXPECT_EQ(cell(table(), anna, column("Artery")), "0");
  EXPECT_EQ(cell(table(), anna, column("Points")), "84");
  EXPECT_EQ(cell(table(), anna, column("Probe path")), "n/a") << "told by no attempt";
  auto& concerns = *child<QListWidget>("concerns");
  ASSERT_EQ(concerns.count(), 1);
  EXPECT_TRUE(concerns.item(0)->text().contains("Dr ben, stuck:  Unlocked: "))
      << concerns.item(0)->text().toStdString();
  EXPECT_TRUE(concerns.item(0)->text().contains("artery")) << concerns.item(0)->text().toStdString();
}

TEST_F(ClassPageTest, F5ReadsTheClassEvenIfTheWindowUsesTheKey) {
  practise(school_->as(school_->anna), true);
  enter("ina");
  QAction reload;
  reload.setShortcut(QKeySequence(Qt::Key_F5));
  workspace_->addAction(&reload);
  const QSignalSpy reloaded(&reload, &QAction::triggered);
  practise(school_->as(school_->anna), true);
  table().setFocus();
  QTest::keyClick(&table(), Qt::Key_F5);
  EXPECT_FALSE(workspace_->isReady()) << "it reads";
  settle();
  EXPECT_EQ(cell(table(), rowOf(table(), "Dr anna"), ClassTable::kAttempts), "2");
  EXPECT_EQ(reloaded.size(), 0);
  child<QAbstractButton>("recordingsTab")->click();
  QTest::keyClick(workspace_.get(), Qt::Key_F5);
  EXPECT_EQ(reloaded.size(), 1) << "on other pages the key belongs to the window";
}

TEST_F(ClassPageTest, ANewAttemptAppearsByItself) {
  practise(school_->as(school_->anna), true);
  enter("ina");
  table().setCurrentIndex(table().model()->index(rowOf(table(), "Dr ben"), 0));
  practise(school_->as(school_->anna), true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return cell(table(), rowOf(table(), "Dr anna"), ClassTable::kAttempts) == "2"; },
                              kPatience_ms));
  EXPECT_EQ(table().currentIndex().row(), rowOf(table(), "Dr ben")) << "the selection stays";
  // While the pages are hidden, nothing is asked; the change is shown when they are visible again.
  workspace_->hide();
  practise(school_->as(school_->anna), true);
  QTest::qWait(4000);
  EXPECT_EQ(cell(table(), rowOf(table(), "Dr anna"), ClassTable::kAttempts), "2");
  workspace_->show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return cell(table(), rowOf(table(), "Dr anna"), ClassTable::kAttempts) == "3"; },
                              kPatience_ms));
}

/// As for a trainee who signs in in Train, makes an attempt there, and then opens Review.
TEST_F(ClassPageTest, AnAttemptSinceTheSignInIsThereWhenThePageIsFirstShown) {
  enter("");
  workspace_->hide();
  signIn("ina");
  QTest::qWait(1000);
  practise(school_->as(school_->anna), true);
  workspace_->show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return cell(table(), rowOf(table(), "Dr anna"), ClassTable::kAttempts) == "1"; },
                              kPatience_ms));
}

TEST_F(ClassPageTest, AnImplausibleAttemptNeedsAttention) {
  practise(school_->as(school_->anna), true);
  practiseTooFast();
  enter("ina");
  auto& concerns = *child<QListWidget>("concerns");
  ASSERT_EQ(concerns.count(), 2);
  EXPECT_EQ(concerns.item(0)->text(), "▲ Dr ben, not begun");
  const QString words = concerns.item(1)->text();
  EXPECT_TRUE(words.contains("Dr anna, attempt of ")) << words.toStdString();
  EXPECT_TRUE(words.contains("implausibly fast: time to vein 1.5\u00a0s")) << words.toStdString();
  EXPECT_EQ(concerns.item(1)->data(Qt::UserRole).toString().toStdString(), school_->anna.id) << "Enter shows her";
}

TEST_F(ClassPageTest, WhoHasAnImplausibleAttemptIsMarkedInTheTable) {
  practise(school_->as(school_->anna), true);
  practiseTooFast();
  enter("ina");
  EXPECT_EQ(cell(table(), rowOf(table(), "Dr anna"), ClassTable::kNeeds), "implausible attempt");
  table().sortByColumn(ClassTable::kNeeds, Qt::AscendingOrder);
  EXPECT_EQ(cell(table(), 1, ClassTable::kName), "Dr anna") << "after who has not begun";
  EXPECT_EQ(cell(table(), 0, ClassTable::kLevel), "not begun");
}

TEST_F(ClassPageTest, NamesAreSortedByTheLanguageAndStayVisible) {
  for (const char* name : {"Zoë", "Änne", "Ömer"}) {
    Person person =
        school_->add(QString("u%1").arg(qHash(QString(name))).toStdString(), Role::Trainee, school_->spring.id);
    person.fullName = name;
    test::succeed(PeopleStore(school_->admin).change(person));
  }
  enter("ina", {900, 700});
  QStringList names;
  for (int row = 0; row < table().model()->rowCount(); ++row) names << cell(table(), row, ClassTable::kName);
  EXPECT_EQ(names, (QStringList{"Änne", "Dr anna", "Dr ben", "Ömer", "Zoë"})) << names.join(", ").toStdString();
  auto& frozen = *child<QTableView>("classTableNames");
  table().horizontalScrollBar()->setValue(table().horizontalScrollBar()->maximum());
  ASSERT_GT(table().horizontalScrollBar()->value(), 0);
  EXPECT_TRUE(frozen.isVisible());
  EXPECT_GE(frozen.visualRect(frozen.model()->index(0, 0)).left(), 0);
  EXPECT_EQ(frozen.width(), table().columnWidth(0));
  for (int column = 1; column < frozen.model()->columnCount(); ++column) EXPECT_TRUE(frozen.isColumnHidden(column));
}

TEST_F(ClassPageTest, AClassThatIsDeletedLeavesNoNumbers) {
  enter("otto");
  EXPECT_TRUE(child<QLabel>("classFacts")->text().contains("person"));
  test::succeed(CohortStore(school_->admin).remove(school_->autumn.id, "Autumn"));
  Q_EMIT account_->peopleChanged();
  settle();
  EXPECT_EQ(child<QLabel>("classFacts")->text(), "");
  EXPECT_TRUE(child<QLabel>("classWords")->text().contains("You have no class yet"));
}

TEST_F(ClassPageTest, SortsByAMetricAndByNeed) {
  practise(school_->as(school_->anna), true, 2);
  practise(school_->as(school_->ben), false, kStuckAfter);
  enter("ina");
  table().sortByColumn(column("Artery"), Qt::AscendingOrder);
  EXPECT_EQ(cell(table(), 0, ClassTable::kName), "Dr ben") << "worst first";
  table().sortByColumn(column("Artery"), Qt::DescendingOrder);
  EXPECT_EQ(cell(table(), 0, ClassTable::kName), "Dr anna");
  table().sortByColumn(ClassTable::kNeeds, Qt::AscendingOrder);
  EXPECT_EQ(cell(table(), 0, ClassTable::kName), "Dr ben") << "who needs help first";
}

TEST_F(ClassPageTest, ColorsAreToldByNumbersToo) {
  EXPECT_EQ(heatColor(0), QColor(0, 34, 78));
  EXPECT_EQ(heatColor(100), QColor(254, 232, 56));
  double before = -1;
  for (int share = 0; share <= 100; share += 5) {
    const QColor color = heatColor(share);
    const double lightness = 0.2126 * color.red() + 0.7152 * color.green() + 0.0722 * color.blue();
    EXPECT_GT(lightness, before) << share << ": lighter is better, without any colour";
    before = lightness;
  }
  EXPECT_EQ(inkOn(heatColor(0)), QColor(Qt::white));
  EXPECT_EQ(inkOn(heatColor(100)), QColor(Qt::black));
  EXPECT_EQ(heatWords(std::nullopt), "no published values");
  EXPECT_EQ(heatWords(70.0), "near expert");
}

TEST_F(ClassPageTest, TheTabGoesToWhoseRowIsChosen) {
  practise(school_->as(school_->anna), true, 2);
  enter("ina");
  table().setFocus();
  table().setCurrentIndex(table().model()->index(rowOf(table(), "Dr anna"), 0));
  QTest::keyClick(workspace_.get(), Qt::Key_2, Qt::AltModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return isSeen("personName"); }, kPatience_ms));
  settle();
  EXPECT_EQ(child<QLabel>("personName")->text(), "Dr anna");
}

TEST_F(ClassPageTest, EnterShowsThePersonAndEachSeesOnlyOwnClasses) {
  practise(school_->as(school_->anna), true, 2);
  enter("ina");
  table().setFocus();
  table().setCurrentIndex(table().model()->index(rowOf(table(), "Dr anna"), 0));
  QTest::keyClick(&table(), Qt::Key_Return);
  settle();
  EXPECT_TRUE(isSeen("personName"));
  EXPECT_EQ(child<QLabel>("personName")->text(), "Dr anna");
  workspace_.reset();
  enter("otto");
  EXPECT_EQ(child<QComboBox>("cohorts")->count(), 1);
  EXPECT_EQ(rowOf(table(), "Dr anna"), -1);
  workspace_.reset();
  enter("admin");
  EXPECT_EQ(child<QComboBox>("cohorts")->count(), 2) << "an administrator sees all";
}

TEST_F(ClassPageTest, NothingOfOneIsSeenByTheNext) {
  practise(school_->as(school_->anna), true, 2);
  enter("ina");
  EXPECT_EQ(table().model()->rowCount(), 2);
  account_->signOut();
  ASSERT_TRUE(QTest::qWaitFor([&] { return account_->state() == ui::Account::State::Guest; }, kPatience_ms));
  settle();
  EXPECT_EQ(table().model()->rowCount(), 0);
  EXPECT_FALSE(isSeen("classTable"));
  EXPECT_TRUE(isSeen("accountNotice")) << "says how to sign in";
  EXPECT_TRUE(isSeen("attemptsWords"));
  signIn("carl");
  settle();
  EXPECT_FALSE(isSeen("classTab"));
  EXPECT_EQ(child<QLabel>("personName")->text(), "Dr carl");
}

TEST_F(ClassPageTest, EmptyPlacesSayWhatToDo) {
  school_->add("nina", Role::Instructor, "");
  enter("nina");
  EXPECT_TRUE(child<QLabel>("classWords")->text().contains("You have no class yet"));
  EXPECT_FALSE(isSeen("cohorts")) << "nothing to choose from";
  workspace_.reset();
  enter("otto");
  EXPECT_TRUE(child<QLabel>("classFacts")->text().contains("has no curriculum yet"))
      << child<QLabel>("classFacts")->text().toStdString();
}

TEST_F(ClassPageTest, FollowsWhatIsChangedInTheWindowOfPeople) {
  enter("otto");
  EXPECT_EQ(table().model()->rowCount(), 1);
  school_->add("dora", Role::Trainee, school_->autumn.id);
  test::succeed(CohortStore(school_->admin).setCurriculum(school_->autumn.id, curriculum_.name, curriculum_.version));
  Q_EMIT account_->peopleChanged();
  settle();
  EXPECT_EQ(table().model()->rowCount(), 2);
  EXPECT_TRUE(child<QLabel>("classFacts")->text().contains("version " + QString::number(curriculum_.version)));
}

TEST_F(ClassPageTest, HostileNamesAreNames) {
  Person anna = school_->anna;
  anna.fullName = kHostileName;
  test::succeed(PeopleStore(school_->admin).change(anna));
  practise(school_->as(school_->anna), false, kStuckAfter);
  enter("ina");
  EXPECT_GE(rowOf(table(), QString::fromStdString(kHostileName)), 0);
  EXPECT_TRUE(child<QListWidget>("concerns")->item(0)->text().contains(QString::fromStdString(kHostileName)));
}

TEST_F(ClassPageTest, WhatLapsesByDaysIsSeenWhileTheWindowStaysOpen) {
  Curriculum shortLived = curriculum_;
  shortLived.version += 1;
  shortLived.levels.front().mastery.lapsesAfter_days = 30;
  test::valueOf(
      PublishedCurricula(school_->admin).publish(shortLived.name, shortLived.version, curriculumText(shortLived)));
  test::succeed(CohortStore(school_->admin).setCurriculum(school_->spring.id, shortLived.name, shortLived.version));
  practise(school_->as(school_->anna), true, 3);
  enter("ina");
  EXPECT_EQ(cell(table(), rowOf(table(), "Dr anna"), ClassTable::kNeeds), "");
  later_us_ = 365 * test::kDay_us;
  QDate today(2026, 11, 22);
  auto* controller = workspace_->findChild<ClassController*>();
  ui::DayWatch midnight([&] { controller->refresh(); }, nullptr, [&] { return today; });
  midnight.checkDate();
  settle();
  EXPECT_EQ(cell(table(), rowOf(table(), "Dr anna"), ClassTable::kNeeds), "") << "the same day";
  today = today.addDays(365);
  midnight.checkDate();
  settle();
  EXPECT_EQ(cell(table(), rowOf(table(), "Dr anna"), ClassTable::kNeeds), "level lapsed");
  EXPECT_TRUE(child<QListWidget>("concerns")->item(0)->text().contains("without practice"));
}

TEST_F(ClassPageTest, EverythingOfWhoIsSignedInHasANameAndATooltip) {
  practise(school_->as(school_->anna), true, 2);
  enter("ina");
  table().setCurrentIndex(table().model()->index(0, 0));
  QTest::keyClick(workspace_.get(), Qt::Key_2, Qt::AltModifier);
  settle();
  EXPECT_GT(test::expectNames(workspace_.get(), true), 30);
}

}  // namespace
}  // namespace insonate::review
