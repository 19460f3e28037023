#include "Classroom.h"
#include "class/ClassTable.h"
#include "reports/ChartObject.h"
#include "reports/PaperSlices.h"
#include "reports/Portfolio.h"
#include "reports/ReportParts.h"
#include "reports/SaveMenu.h"

#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Csv.h>

#include <nlohmann/json.hpp>

#include <QAbstractButton>
#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <optional>

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

TEST_F(ReportsTest, AClassIsSavedAsGradesForMoodle) {
  practise(school_->as(school_->anna), true, 3);
  enter("ina");
  const QSignalSpy written(workspace_.get(), &ui::Workspace::written);
  menu("saveClass").saveGrades(home_.filePath("grades.csv"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 1; }, kPatience_ms));
  EXPECT_EQ(written.first().first().toString(), "Saved as grades.csv. Left out: Dr ben (no grade yet).");
  const auto rows = test::valueOf(parseCsv(read(home_.filePath("grades.csv")).toStdString()));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(fieldOf(rows, 1, "Email address"), school_->anna.email);
  EXPECT_FALSE(menu("savePerson").findChild<QAction*>("saveGrades"));
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

TEST_F(ReportsTest, APortfolioHasAttemptsJudgementsAndCurves) {
  practise(school_->as(school_->anna), false, 2);
  const std::string voided = last_.id;
  practise(school_->as(school_->anna), true, 40);
  test::succeed(AttemptStore(school_->as(school_->ina)).voidAttempt(voided, "the <needle> came off"));
  const Form checklist = test::valueOf(loadForm("jugular_checklist"));
  const FormItem& item = checklist.sections.front().items.front();
  FormAnswers answers;
  for (const FormSection& section : checklist.sections)
    for (const FormItem& one : section.items)
      if (one.kind == FormItem::Kind::Choice) answers[one.name] = one.options.front().name;
  answers[noteKey(item)] = "asked twice for help";
  test::valueOf(FormStore(school_->as(school_->ina))
                    .add({.form = checklist.name,
                          .formVersion = checklist.version,
                          .person = school_->anna.id,
                          .attempt = last_.id,
                          .answers = answersText(answers)}));
  const SignedIn ina = school_->as(school_->ina);
  const auto portfolio = test::valueOf(readPortfolio(ina, school_->anna.id, curriculum_, services().now_us()));
  EXPECT_EQ(portfolio.attempts.size(), 42U) << "also more than a page of the list";
  EXPECT_EQ(portfolio.attempts[1].facts.id, voided) << "in their order";
  ASSERT_EQ(portfolio.judgements.size(), 1U);
  const QString words = portfolioText(portfolio);
  for (const char* expected : {"Portfolio of Dr anna", "Voided, does not count. Reason: the <needle> came off",
                               "Dr ina", "asked twice for help", "42 attempts", "1 voided", "Learning curves",
                               "mastered", "Jugular line without a guide"})
    EXPECT_TRUE(words.contains(expected)) << expected << " in:\n" << words.toStdString();
  const auto curves = curvesOf(portfolio);
  EXPECT_EQ(curves.size(), 1U) << "one level has attempts";
  for (const auto paper : {QPageSize::A4, QPageSize::Letter}) {
    const QString file = home_.filePath(QStringLiteral("portfolio%1.pdf").arg(int(paper)));
    test::succeed(writePortfolio(file, portfolio, curves, paper, {}));
    const QByteArray pdf = read(file);
    EXPECT_TRUE(pdf.startsWith("%PDF"));
    EXPECT_GT(pdf.count("/Type /Page\n"), 1) << "several pages";
    EXPECT_FALSE(pdf.contains("/Subtype /Image")) << "curves are vectors";
  }
  const QString none = home_.filePath("cancelled.pdf");
  EXPECT_FALSE(writePortfolio(none, portfolio, curves, QPageSize::A4, [](auto, double) { return false; }));
  EXPECT_FALSE(QFile::exists(none));
  EXPECT_TRUE(QString::fromStdString(
                  writePortfolio(home_.filePath("nowhere/a.pdf"), portfolio, curves, QPageSize::A4, {}).error().message)
                  .contains("could not be written"));
}

TEST_F(ReportsTest, APortfolioHasCommentsAndImplausibleAttempts) {
  practise(school_->as(school_->anna), true);
  practiseTooFast();
  test::valueOf(CommentStore(school_->as(school_->ina)).add(last_.id, 2'000'000, "Hold the <probe> still"));
  const auto portfolio =
      test::valueOf(readPortfolio(school_->as(school_->ina), school_->anna.id, curriculum_, services().now_us()));
  const QString words = portfolioText(portfolio);
  for (const char* expected : {"Hold the <probe> still", "0:02.00", "implausibly fast: time to vein 1.5"})
    EXPECT_TRUE(words.contains(expected)) << expected << " in:\n" << words.toStdString();
  const auto own =
      test::valueOf(readPortfolio(school_->as(school_->anna), school_->anna.id, curriculum_, services().now_us()));
  EXPECT_FALSE(portfolioText(own).contains("implausibly")) << "the trainee sees no flags on any page";
}

TEST_F(ReportsTest, AChartBeyondThePageIsNotDrawn) {
  QPicture black;
  {
    QPainter painter(&black);
    painter.setClipRect(QRectF(0, 0, 50, 50));  // like Qwt, which replaces the clipping of the page
    painter.fillRect(QRectF(0, 0, 50, 50), Qt::black);
  }
  ChartObject charts({50, 50});
  const QTextCharFormat format = charts.add(black);
  const auto isDrawn = [&](double top) {
    QImage page(60, 260, QImage::Format_RGB32);
    page.fill(Qt::white);
    QPainter painter(&page);
    charts.drawObject(&painter, QRectF(0, top, 50, 50), nullptr, 0, format);
    return page.pixel(25, int(top) + 25) == qRgb(0, 0, 0);
  };
  charts.setPart({0, 100});
  EXPECT_TRUE(isDrawn(40));
  EXPECT_FALSE(isDrawn(100)) << "it begins the next page";
  charts.setPart({100, 200});
  EXPECT_FALSE(isDrawn(40));
  EXPECT_TRUE(isDrawn(100));
}

TEST_F(ReportsTest, APortfolioIsSavedInTheBackground) {
  practise(school_->as(school_->anna), true, 3);
  enter("anna");
  const QSignalSpy written(workspace_.get(), &ui::Workspace::written);
  QAction* action = workspace_->commands().action(QStringLiteral("review.home.portfolio"));
  ASSERT_TRUE(action);
  EXPECT_TRUE(action->isEnabled());
  EXPECT_EQ(action->shortcut(), QKeySequence("Ctrl+Shift+P"));
  const QString file = home_.filePath("anna portfolio.pdf");
  std::atomic<bool> isDone = false;
  std::optional<Result<bool>> other;
  tasks_.run<bool>(
      "Opening a case",
      [&](const Progress&) -> Result<bool> {
        while (!isDone) QThread::msleep(5);
        return true;
      },
      [&](const Result<bool>& result) { other = result; });
  menu("savePerson").savePortfolio(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 1; }, kPatience_ms));
  EXPECT_EQ(written.first().first().toString(),
            "The portfolio of Dr anna will be written when this task is done: Opening a case.");
  EXPECT_FALSE(QFile::exists(file)) << "the window does not wait for it";
  EXPECT_EQ(workspace_->windowCloseWarning(),
            "The portfolio of Dr anna is not written yet. If you close the window, the portfolio is lost.");
  isDone = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return other.has_value(); }, kPatience_ms));
  EXPECT_TRUE(*other) << "the other task is not cancelled";
  ASSERT_TRUE(QTest::qWaitFor([&] { return tasks_.asksWhenClosed() || written.count() == 2; }, kPatience_ms));
  EXPECT_EQ(workspace_->windowCloseWarning(), "");
  ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 2; }, kPatience_ms));
  EXPECT_TRUE(read(file).startsWith("%PDF"));
}

TEST_F(ReportsTest, APortfolioIsOfferedUnderANameOfItsOwn) {
  practise(school_->as(school_->anna), true);
  enter("anna");
  const auto offered = [&](const char* action) {
    QString name;
    QTimer::singleShot(0, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      name = QFileInfo(dialog->selectedFiles().value(0)).fileName();
      dialog->reject();
    });
    menu("savePerson").findChild<QAction*>(action)->trigger();
    return name;
  };
  EXPECT_EQ(offered("savePortfolio"), "Dr-anna-portfolio.pdf");
  EXPECT_EQ(offered("savePage"), "Dr-anna.pdf");
}

class PaperSlicesTest : public testing::Test {
 protected:
  static constexpr double kWidth = 400, kHeight = 300;

  static QString rowOf(int lines) {
    return QStringLiteral("<tr><td>n</td><td>%1</td></tr>")
        .arg(QStringList(QVector<QString>(lines, "line").toList()).join("<br>"));
  }
  std::vector<PaperSlice> divided(const QString& html) {
    document_.setHtml(html);
    document_.setTextWidth(kWidth);
    return slicesOf(document_, kHeight);
  }
  QRectF placeOf(const QTextBlock& block) const { return document_.documentLayout()->blockBoundingRect(block); }

  QTextDocument document_;
};

TEST_F(PaperSlicesTest, RowsStayWholeAndTheHeadIsRepeated) {
  QString html = "<h2>Attempts</h2><table cellspacing=\"0\" cellpadding=\"2\"><tr><th>No.</th><th>Outcome</th></tr>";
  for (int i = 0; i < 30; ++i) html += rowOf(1 + i * 7 % 5);
  const auto pages = divided(html + "</table>");
  ASSERT_GT(pages.size(), 3U);
  for (QTextBlock block = document_.begin(); block.isValid(); block = block.next()) {
    const QRectF place = placeOf(block);
    const auto holds = [&](const PaperSlice& page) {
      return place.top() >= page.part.top && place.bottom() <= page.part.bottom;
    };
    EXPECT_EQ(std::ranges::count_if(pages, holds), 1) << block.text().toStdString() << " at " << place.top();
  }
  EXPECT_FALSE(pages[0].head);
  for (std::size_t i = 1; i < pages.size(); ++i) {
    ASSERT_TRUE(pages[i].head) << i;
    EXPECT_DOUBLE_EQ(pages[i].part.top, pages[i - 1].part.bottom) << "nothing is left out";
    const double height = pages[i].part.bottom - pages[i].part.top + pages[i].head->bottom - pages[i].head->top;
    EXPECT_LE(height, kHeight);
  }
}

TEST_F(PaperSlicesTest, AHeadingStaysWithItsTable) {
  for (int lines = 8; lines < 22; ++lines) {
    SCOPED_TRACE(lines);
    const QString before = QStringList(QVector<QString>(lines, "text").toList()).join("<br>");
    const auto pages =
        divided("<p>" + before + "</p><h2>Tests</h2><table><tr><th>No.</th></tr>" + rowOf(1) + "</table>");
    QTextBlock heading = document_.begin().next(), row = heading;
    while (row.isValid() && row.text() != "n") row = row.next();
    ASSERT_TRUE(row.isValid() && heading.text() == "Tests");
    for (const PaperSlice& page : pages)
      EXPECT_EQ(placeOf(heading).center().y() < page.part.bottom && placeOf(heading).center().y() > page.part.top,
                placeOf(row).center().y() < page.part.bottom && placeOf(row).center().y() > page.part.top);
  }
}

TEST_F(PaperSlicesTest, ARowHigherThanAPageIsDividedBetweenLines) {
  const auto pages = divided("<table><tr><th>No.</th><th>Remarks</th></tr>" + rowOf(60) + rowOf(1) + "</table>");
  ASSERT_GT(pages.size(), 2U);
  for (std::size_t i = 1; i < pages.size(); ++i) {
    EXPECT_DOUBLE_EQ(pages[i].part.top, pages[i - 1].part.bottom);
    for (QTextBlock block = document_.begin(); block.isValid(); block = block.next())
      for (int n = 0; n < block.layout()->lineCount(); ++n) {
        const double top = placeOf(block).top() + block.layout()->lineAt(n).y();
        const double bottom = top + block.layout()->lineAt(n).height();
        EXPECT_FALSE(top < pages[i].part.top - 1 && bottom > pages[i].part.top + 1) << "a line is cut";
      }
  }
}

TEST_F(ReportsTest, ThePortfoliosKeyWorksOnThePageOfAPersonOnly) {
  practise(school_->as(school_->anna), true);
  enter("ina");
  QAction* action = workspace_->commands().action(QStringLiteral("review.home.portfolio"));
  ASSERT_TRUE(action);
  EXPECT_TRUE(workspace_->findChild<ReviewHome*>()->actions().contains(action)) << "wherever the focus is";
  EXPECT_FALSE(action->isEnabled()) << "on the page of the class";
  openFirst();
  EXPECT_TRUE(action->isEnabled());
  child<QAbstractButton>("recordingsTab")->click();
  EXPECT_FALSE(action->isEnabled());
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
  EXPECT_EQ(menu("saveClass").actions().size(), 4);
  EXPECT_EQ(menu("savePerson").actions().size(), 4);
}

}  // namespace
}  // namespace insonate::review
