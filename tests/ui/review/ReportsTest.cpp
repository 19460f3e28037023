#include "Classroom.h"
#include "class/ClassTable.h"
#include "reports/ReportParts.h"
#include "reports/SaveMenu.h"

#include <insonate/curriculum/Csv.h>

#include <nlohmann/json.hpp>

#include <QFile>
#include <QImage>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <algorithm>

namespace insonate::review {
namespace {

class ReportsTest : public Classroom {
 protected:
  SaveMenu& menu(const char* button) {
    auto* found = qobject_cast<SaveMenu*>(child<QPushButton>(button)->menu());
    if (!found) throw std::runtime_error("no menu");
    return *found;
  }
  QByteArray read(const QString& file) {
    QFile in(file);
    EXPECT_TRUE(in.open(QIODevice::ReadOnly)) << file.toStdString();
    return in.readAll();
  }
  static std::string fieldOf(const std::vector<CsvRow>& rows, std::size_t row, const std::string& column) {
    const auto& columns = rows[0].fields;
    return rows[row].fields.at(std::size_t(std::ranges::find(columns, column) - columns.begin()));
  }
  void openFirst() {
    auto& table = *child<QTableView>("classTable");
    table.setCurrentIndex(table.model()->index(0, 0));
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_Return);
    settle();
  }
};

TEST_F(ReportsTest, AClassIsSavedAsPageAndTable) {
  Person anna = school_->anna;
  anna.fullName = "=HYPERLINK(\"http://x\")";
  test::succeed(PeopleStore(school_->admin).change(anna));
  practise(school_->as(school_->anna), true, 3);
  practise(school_->as(school_->ben), false, kStuckAfter);
  enter("ina");
  const QSignalSpy written(workspace_.get(), &ui::Workspace::written);
  menu("saveClass").savePage(home_.filePath("class.pdf"));
  menu("saveClass").savePage(home_.filePath("class.png"));
  menu("saveClass").saveTable(home_.filePath("class.csv"));
  EXPECT_EQ(written.count(), 3);
  EXPECT_TRUE(read(home_.filePath("class.pdf")).startsWith("%PDF"));
  EXPECT_EQ(read(home_.filePath("class.pdf")).count("/Type /Page\n"), 1) << "one page";
  EXPECT_EQ(QImage(home_.filePath("class.png")).size(), QSize(1240, 1754));
  const auto rows = test::valueOf(parseCsv(read(home_.filePath("class.csv")).toStdString()));
  ASSERT_EQ(rows.size(), 3U);
  for (const CsvRow& row : rows) EXPECT_EQ(row.fields.size(), rows[0].fields.size());
  const auto field = [&](const std::string& name, const std::string& column) {
    return fieldOf(rows, rows[1].fields[1] == name ? 1 : 2, column);
  };
  EXPECT_EQ(field("anna", "id"), school_->anna.id);
  EXPECT_EQ(field("anna", "full name"), "'=HYPERLINK(\"http://x\")") << "no formula";
  EXPECT_EQ(field("ben", "needs"), "stuck");
  EXPECT_EQ(field("ben", "attempts"), "5");
}

TEST_F(ReportsTest, APersonIsSavedAsPageAndTable) {
  practise(school_->as(school_->anna), false, 4);
  practise(school_->as(school_->anna), true, 2);
  enter("anna");
  menu("savePerson").savePage(home_.filePath("anna.pdf"));
  menu("savePerson").saveTable(home_.filePath("anna.csv"));
  EXPECT_EQ(read(home_.filePath("anna.pdf")).count("/Type /Page\n"), 1) << "one page";
  const auto rows = test::valueOf(parseCsv(read(home_.filePath("anna.csv")).toStdString()));
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(fieldOf(rows, 6, "id"), last_.id) << "in their order";
  EXPECT_EQ(fieldOf(rows, 6, "outcome"), "Passed");
  EXPECT_EQ(fieldOf(rows, 6, "passed"), "yes");
  EXPECT_EQ(fieldOf(rows, 6, "assistance"), "guided");
  EXPECT_EQ(fieldOf(rows, 1, "points"), "0");
  EXPECT_EQ(fieldOf(rows, 1, "passed"), "no");
  EXPECT_EQ(fieldOf(rows, 1, "voided"), "no");
}

TEST_F(ReportsTest, StatementsAreWrittenForAllWhoLearn) {
  practise(school_->as(school_->anna), true, 3);
  practise(school_->as(school_->ben), false, 2);
  enter("ina");
  const QSignalSpy written(workspace_.get(), &ui::Workspace::written);
  const QSignalSpy failed(workspace_.get(), &ui::Workspace::failed);
  menu("saveClass").saveXapi(home_.filePath("class.json"), "https://training.example.org");
  ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 1; }, kPatience_ms));
  const auto all = nlohmann::json::parse(read(home_.filePath("class.json")).toStdString());
  EXPECT_EQ(all.size(), 5U);
  EXPECT_EQ(written.first().first().toString(), "Saved as class.json.") << "nothing is left out";
  Curriculum next = curriculum_;
  next.version += 1;
  test::valueOf(PublishedCurricula(school_->admin).publish(next.name, next.version, curriculumText(next)));
  test::succeed(CohortStore(school_->admin).setCurriculum(school_->spring.id, next.name, next.version));
  Q_EMIT account_->peopleChanged();
  settle();
  menu("saveClass").saveXapi(home_.filePath("next.json"), "https://training.example.org");
  ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 2; }, kPatience_ms));
  const QString said = written.last().first().toString();
  EXPECT_TRUE(said.startsWith("Saved as next.json. Left out: 5 attempts (5 of version ")) << said.toStdString();
  menu("saveClass").saveXapi(home_.filePath("none.json"), "somewhere");
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }, kPatience_ms));
  EXPECT_FALSE(QFile::exists(home_.filePath("none.json")));
}

TEST(PaperColumn, ReasonsGoOnInFurtherLinesInsteadOfBeingCut) {
  QImage paper(int(paper::kWidth), int(paper::kHeight), QImage::Format_RGB32);
  paper.fill(Qt::white);
  QPainter painter(&paper);
  PaperColumn page(painter);
  painter.setFont(paperFont(paper::kSmall));
  constexpr double kColumn = 400;
  const QString reason = QStringLiteral("Voided: the device lost its calibration. ").repeated(6);
  const double height = page.heightOf(kColumn, reason);
  EXPECT_GT(height, 5 * paper::kRow);
  EXPECT_EQ(page.heightOf(kColumn, "Passed"), paper::kRow);
  page.lines(paper::kMargin, kColumn, reason, Qt::black);
  bool isInked = false;
  for (int y = int(page.y() + height - paper::kRow); y < int(page.y() + height); ++y)
    for (int x = int(paper::kMargin); x < int(paper::kMargin + kColumn); ++x)
      isInked = isInked || qGray(paper.pixel(x, y)) < 128;
  EXPECT_TRUE(isInked) << "up to the last line";
}

TEST_F(ReportsTest, WhatCannotBeWrittenIsSaid) {
  practise(school_->as(school_->anna), true);
  enter("ina");
  const QSignalSpy failed(workspace_.get(), &ui::Workspace::failed);
  menu("saveClass").savePage(home_.filePath("nowhere/class.pdf"));
  menu("saveClass").saveTable(home_.filePath("nowhere/class.csv"));
  EXPECT_EQ(failed.count(), 2);
  openFirst();
  EXPECT_EQ(menu("savePerson").actions().size(), 3);
}

}  // namespace
}  // namespace insonate::review
