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
  const auto rowOf = [&](const std::string& name) { return rows[rows[1].fields[0] == name ? 1 : 2].fields; };
  EXPECT_EQ(rowOf("anna")[1], "'=HYPERLINK(\"http://x\")") << "no formula";
  EXPECT_EQ(rowOf("ben")[5], "stuck");
  EXPECT_EQ(rowOf("ben")[7], "5");
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
  EXPECT_EQ(rows[6].fields[0], last_.id) << "in their order";
  EXPECT_EQ(rows[6].fields[7], "Passed");
  EXPECT_EQ(rows[1].fields[9], "0") << "points";
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
