#include "../attempt/Words.h"
#include "../class/ClassWords.h"
#include "../judge/JudgeWords.h"
#include "ChartObject.h"
#include "PaperSlices.h"
#include "Portfolio.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QDate>
#include <QLocale>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextCursor>
#include <QTextDocument>
#include <algorithm>
#include <cmath>
#include <map>

namespace insonate::review {
namespace {

/// The text is as high as a page of Letter allows and as wide as a page of A4 allows.
constexpr double kTextWidth_mm = 176, kTextHeight_mm = 244, kFoot_mm = 8, kMm_perInch = 25.4;
constexpr double kBody_pt = 8.5, kFoot_pt = 7.5;

const QString kStyle = QStringLiteral(
    "h1 { font-size: 17pt; margin-bottom: 2px } h2 { font-size: 11.5pt; margin-top: 14px; margin-bottom: 4px } "
    "h3 { font-size: 9pt; margin-top: 8px; margin-bottom: 2px } p { margin-top: 2px; margin-bottom: 4px } "
    "th { text-align: left; color: #505860; white-space: nowrap } .quiet { color: #505860 } .danger { color: #a01818 "
    "}");

QString escaped(const QString& text) {
  return text.toHtmlEscaped();
}
QString escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped();
}

/// A table with a head row, which slicesOf() repeats. Cells are HTML; the last column has the longest texts.
class HtmlTable {
 public:
  HtmlTable(const QStringList& titles, int lastColumn_percent) {
    text_ = QStringLiteral("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"2\"><thead><tr>");
    for (const QString& title : titles)
      text_ += (title == titles.last() ? QStringLiteral("<th width=\"%1%\">").arg(lastColumn_percent)
                                       : QStringLiteral("<th>")) +
               escaped(title) + QStringLiteral("</th>");
    text_ += QStringLiteral("</tr></thead>");
  }
  void add(const QStringList& cells) {
    text_ += QStringLiteral("<tr>");
    for (const QString& cell : cells) text_ += QStringLiteral("<td>") + cell + QStringLiteral("</td>");
    text_ += QStringLiteral("</tr>");
  }
  QString text() const { return text_ + QStringLiteral("</table>"); }

 private:
  QString text_;
};

QString headingHtml(const QString& words) {
  return QStringLiteral("<h2>%1</h2>").arg(escaped(words));
}
QString quietHtml(const QString& words) {
  return QStringLiteral("<p class=\"quiet\">%1</p>").arg(escaped(words));
}

const Curriculum* curriculumIn(const Portfolio& portfolio) {
  return portfolio.person.curriculum ? &*portfolio.person.curriculum : nullptr;
}

const Level* levelIn(const Portfolio& portfolio, const AttemptFacts& attempt) {
  const Curriculum* curriculum = curriculumIn(portfolio);
  return curriculum ? levelOf(*curriculum, attempt) : nullptr;
}

QString levelWords(const Portfolio& portfolio, const AttemptFacts& attempt) {
  if (attempt.level.empty()) return escaped(tr("free practice"));
  const Level* level = levelIn(portfolio, attempt);
  const QString title = escaped(levelTitle(curriculumIn(portfolio), attempt.level));
  return level && level->assistance == Assistance::Test ? tr("%1 (test)").arg(title) : title;
}

QString pointsCell(const AttemptFacts& attempt) {
  const auto points = pointsOf(attempt);
  return points ? QString::number(std::lround(*points)) : tr("n/a");
}

/// Outcome of an attempt, and all that limits its weight.
QString outcomeCell(const Portfolio& portfolio, const StoredAttempt& attempt) {
  if (attempt.facts.state == AttemptState::Voided)
    return QStringLiteral("<span class=\"danger\"><b>%1</b> %2</span>")
        .arg(escaped(tr("Voided, does not count. Reason:")), escaped(attempt.voidReason));
  QString words = escaped(outcomeOf(attempt.facts, curriculumIn(portfolio)));
  if (attempt.facts.proof == AttemptProof::Accepted) words += escaped(tr("; accepted by an instructor without proof"));
  if (attempt.facts.proof == AttemptProof::Demonstration) words += escaped(tr("; demonstration data"));
  if (const auto flagged = portfolio.person.notes.implausible.find(attempt.facts.id);
      flagged != portfolio.person.notes.implausible.end())
    words += QStringLiteral("; <b>%1</b>").arg(escaped(displayText(attempt.facts, flagged->second)));
  return words;
}

QString headOf(const Portfolio& portfolio) {
  const Person& person = portfolio.person.person;
  const auto voided = std::ranges::count_if(
      portfolio.attempts, [](const StoredAttempt& one) { return one.facts.state == AttemptState::Voided; });
  QStringList facts{countOf(int(portfolio.attempts.size()), tr("attempt"), tr("attempts")), tr("%1 voided").arg(voided),
                    countOf(int(portfolio.judgements.size()), tr("checklist or rating"), tr("checklists and ratings"))};
  const Curriculum* curriculum = curriculumIn(portfolio);
  facts.prepend(
      curriculum
          ? tr("%1, version %2").arg(QString::fromStdString(curriculum->title), QString::number(curriculum->version))
          : tr("no curriculum"));
  QString text = QStringLiteral("<h1>%1</h1><p>%2</p><p class=\"quiet\">%3</p>")
                     .arg(escaped(tr("Portfolio of %1").arg(QString::fromStdString(person.fullName))),
                          escaped(person.email.empty() ? person.name : person.name + ", " + person.email),
                          escaped(facts.join(QStringLiteral("  ·  "))));
  if (const auto& standing = portfolio.person.standing) {
    const QString level = standing->level.empty() ? tr("all levels") : levelTitle(curriculum, standing->level);
    text += QStringLiteral("<p><b>%1</b>  ·  %2</p>").arg(escaped(level), escaped(standing->sentence));
  }
  return text;
}

QString levelsOf(const Portfolio& portfolio) {
  QString text = headingHtml(tr("Levels"));
  const Curriculum* curriculum = curriculumIn(portfolio);
  if (!curriculum) return text + quietHtml(tr("The class has no curriculum yet."));
  HtmlTable table({tr("Level"), tr("State"), tr("Since"), tr("Passed"), tr("Attempts"), tr("Reason")}, 46);
  for (const LevelProgress& one : portfolio.person.progress)
    table.add({escaped(levelTitle(curriculum, one.level)), escaped(nameOf(one.state)),
               one.since_us ? escaped(dayOf(*one.since_us)) : QString(), QString::number(one.passes),
               QString::number(one.attempts), escaped(one.why)});
  return text + table.text();
}

QString testsOf(const Portfolio& portfolio) {
  QString text = headingHtml(tr("Tests"));
  HtmlTable table({tr("Begun"), tr("Level"), tr("Points"), tr("Outcome")}, 58);
  int count = 0;
  for (const StoredAttempt& one : portfolio.attempts) {
    const Level* level = levelIn(portfolio, one.facts);
    if (!level || level->assistance != Assistance::Test) continue;
    ++count;
    table.add({escaped(ui::dayAndTimeOf(one.facts.begun_us)), levelWords(portfolio, one.facts), pointsCell(one.facts),
               outcomeCell(portfolio, one)});
  }
  return text + (count == 0 ? quietHtml(tr("None yet.")) : table.text());
}

/// Items that were not answered with the most points, and all notes, of one checklist or rating.
QString remarksOf(const Form& form, const FormAnswers& answers) {
  QStringList remarks;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) {
      const auto given = std::ranges::find_if(item.options, [&](const FormOption& one) {
        const auto found = answers.find(item.name);
        return found != answers.end() && found->second == decltype(found->second)(one.name);
      });
      const auto best = std::ranges::max_element(item.options, {}, &FormOption::points);
      const bool isScored = best != item.options.end() && best->points;
      const bool isBest = given != item.options.end() && given->points && given->points == best->points;
      const QString note = QString::fromStdString(noteText(item, answers));
      const QString answer = QString::fromStdString(answerText(item, answers));
      if ((isScored && isBest) || (!isScored && answer.isEmpty())) {
        if (!note.isEmpty()) remarks << QStringLiteral("%1: %2").arg(QString::fromStdString(item.title), note);
        continue;
      }
      const QString words = answer.isEmpty() ? tr("not answered") : answer;
      remarks << QStringLiteral("%1: %2").arg(QString::fromStdString(item.title),
                                              note.isEmpty() ? words : tr("%1 (%2)").arg(words, note));
    }
  return escaped(remarks.join(QStringLiteral("; ")));
}

QString judgementsOf(const Portfolio& portfolio) {
  QString text = headingHtml(tr("Checklists and ratings"));
  if (portfolio.judgements.empty()) return text + quietHtml(tr("None yet."));
  text += quietHtml(tr("The last column lists each item below full points, and all notes of the rater."));
  std::map<std::string, const StoredAttempt*> byId;
  for (const StoredAttempt& one : portfolio.attempts) byId[one.facts.id] = &one;
  HtmlTable table({tr("Submitted"), tr("Form"), tr("Rater"), tr("Attempt"), tr("Score"), tr("Remarks")}, 36);
  for (const StoredForm& one : portfolio.judgements) {
    const auto form = loadForm(one.filled.form);
    const auto answers = parseAnswers(one.filled.answers);
    const auto found = byId.find(one.filled.attempt);
    QString attempt = tr("no attempt");
    if (found != byId.end()) {
      const AttemptFacts& facts = found->second->facts;
      attempt = escaped(ui::dayAndTimeOf(facts.begun_us)) + QStringLiteral("<br>") + levelWords(portfolio, facts);
      if (facts.state == AttemptState::Voided)
        attempt += QStringLiteral("<br><span class=\"danger\"><b>%1</b></span>").arg(escaped(tr("Voided")));
    }
    const bool isKnown = form && answers && form->version == one.filled.formVersion;
    const bool isShown = isKnown && !one.withheld;
    table.add({escaped(dayOf(one.filled.filled_us)), escaped(form ? form->title : one.filled.form), escaped(one.rater),
               attempt, isShown ? escaped(scoreWords(formScore(*form, *answers))) : tr("n/a"),
               one.withheld ? escaped(tr("Hidden until the reader of this portfolio has handed in the same form."))
               : isShown    ? remarksOf(*form, *answers)
                            : escaped(tr("Filled in with version %1 of the form, which this program does not have.")
                                          .arg(one.filled.formVersion))});
  }
  return text + table.text();
}

QString commentsOf(const Portfolio& portfolio) {
  QString text = headingHtml(tr("Comments"));
  if (portfolio.comments.empty()) return text + quietHtml(tr("None yet."));
  HtmlTable table({tr("Attempt"), tr("At"), tr("Author"), tr("Comment")}, 56);
  for (const StoredAttempt& attempt : portfolio.attempts)
    for (const AttemptComment& one : portfolio.comments)
      if (one.attempt == attempt.facts.id)
        table.add({escaped(ui::dayAndTimeOf(attempt.facts.begun_us)) + QStringLiteral("<br>") +
                       levelWords(portfolio, attempt.facts),
                   escaped(clockOf(one.at_us)), escaped(one.author), escaped(one.text)});
  return text + table.text();
}

QString attemptsOf(const Portfolio& portfolio) {
  QString text = headingHtml(tr("All attempts"));
  if (portfolio.attempts.empty()) return text + quietHtml(tr("None yet."));
  HtmlTable table({tr("No."), tr("Begun"), tr("Level"), tr("Points"), tr("Outcome")}, 56);
  int number = 0;
  for (const StoredAttempt& one : portfolio.attempts)
    table.add({QString::number(++number), escaped(ui::dayAndTimeOf(one.facts.begun_us)),
               levelWords(portfolio, one.facts), pointsCell(one.facts), outcomeCell(portfolio, one)});
  return text + table.text();
}

void addCurves(QTextCursor& cursor, ChartObject& charts, const std::vector<QPicture>& curves) {
  cursor.insertHtml(headingHtml(tr("Learning curves")));
  if (curves.empty()) {
    cursor.insertBlock();
    cursor.insertHtml(quietHtml(tr("None yet.")));
  }
  for (const QPicture& one : curves) {
    cursor.insertBlock(QTextBlockFormat(), QTextCharFormat());
    cursor.insertText(QString(QChar::ObjectReplacementCharacter), charts.add(one));
  }
}

void fillDocument(QTextDocument& document, ChartObject& charts, const Portfolio& portfolio,
                  const std::vector<QPicture>& curves) {
  document.setDefaultStyleSheet(kStyle);
  QFont font(QStringLiteral("sans-serif"));
  font.setPointSizeF(kBody_pt);
  document.setDefaultFont(font);
  document.setDocumentMargin(0);
  document.setUseDesignMetrics(true);
  document.documentLayout()->registerHandler(ChartObject::kType, &charts);
  QTextCursor cursor(&document);
  const auto add = [&](const QString& html) {
    if (!document.isEmpty()) cursor.insertBlock(QTextBlockFormat(), QTextCharFormat());
    cursor.insertHtml(html);
    cursor.movePosition(QTextCursor::End);
  };
  add(headOf(portfolio) + levelsOf(portfolio));
  add(testsOf(portfolio));
  cursor.insertBlock(QTextBlockFormat(), QTextCharFormat());
  addCurves(cursor, charts, curves);
  add(judgementsOf(portfolio));
  add(commentsOf(portfolio));
  add(attemptsOf(portfolio));
}

/// Paints a part of the document with its top at the painter's origin.
void paintSpan(QPainter& painter, const QTextDocument& document, ChartObject& charts, const PaperSpan& span) {
  charts.setPart(span);
  QAbstractTextDocumentLayout::PaintContext context;
  context.clip = QRectF(0, span.top, document.textWidth(), span.bottom - span.top);
  context.palette.setColor(QPalette::Text, Qt::black);
  painter.save();
  painter.translate(0, -span.top);
  painter.setClipRect(context.clip);
  document.documentLayout()->draw(&painter, context);
  painter.restore();
}

/// Paints one page of the document, and its foot: left the words, right the number of the page.
void paintPortfolioPage(QPainter& painter, const QTextDocument& document, ChartObject& charts, const PaperSlice& page,
                        const QString& words, const QString& number, double perMm) {
  const QSizeF text(document.textWidth(), kTextHeight_mm * perMm);
  const QPointF corner((painter.device()->width() - text.width()) / 2,
                       (painter.device()->height() - text.height() - kFoot_mm * perMm) / 2);
  painter.save();
  painter.translate(corner);
  if (page.head) {
    paintSpan(painter, document, charts, *page.head);
    painter.translate(0, page.head->bottom - page.head->top);
  }
  paintSpan(painter, document, charts, page.part);
  painter.restore();
  QFont font(QStringLiteral("sans-serif"));
  font.setPointSizeF(kFoot_pt);
  painter.setFont(font);
  const QRectF below(corner.x(), corner.y() + text.height(), text.width(), kFoot_mm * perMm);
  painter.drawText(below, Qt::AlignLeft | Qt::AlignBottom, words);
  painter.drawText(below, Qt::AlignRight | Qt::AlignBottom, number);
}

}  // namespace

QString portfolioText(const Portfolio& portfolio) {
  ChartObject charts(kCurves_px);
  QTextDocument document;
  fillDocument(document, charts, portfolio, {});
  return document.toPlainText();
}

Result<void> writePortfolio(const QString& file, const Portfolio& portfolio, const std::vector<QPicture>& curves,
                            QPageSize::PageSizeId paper, const Progress& progress) {
  if (!report(progress, "Layout", 0)) return fail(std::string(kCancelled));
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter pdf(&buffer);
  pdf.setPageSize(QPageSize(paper));
  pdf.setPageMargins({0, 0, 0, 0});
  // The drawings have text in points, which is right only at their own resolution.
  const int resolution_dpi = QPicture().logicalDpiX();
  pdf.setResolution(resolution_dpi);
  pdf.setTitle(tr("Portfolio of %1").arg(QString::fromStdString(portfolio.person.person.fullName)));
  const double perMm = resolution_dpi / kMm_perInch;
  ChartObject charts(kCurves_px);
  QTextDocument document;
  document.documentLayout()->setPaintDevice(&pdf);
  fillDocument(document, charts, portfolio, curves);
  document.setTextWidth(kTextWidth_mm * perMm);
  const std::vector<PaperSlice> pages = slicesOf(document, kTextHeight_mm * perMm);
  const QString day = QLocale(QLocale::English).toString(QDate::currentDate(), QStringLiteral("d MMM yyyy"));
  const QString foot =
      tr("%1. Insonate, %2, for %3. For training; points are no measure of competence.")
          .arg(QString::fromStdString(portfolio.person.person.fullName), day, QString::fromStdString(portfolio.reader));
  {
    QPainter painter(&pdf);
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (!report(progress, "Pages", double(i) / double(pages.size()))) return fail(std::string(kCancelled));
      if (i > 0) pdf.newPage();
      paintPortfolioPage(painter, document, charts, pages[i], foot, tr("%1 of %2").arg(i + 1).arg(pages.size()), perMm);
    }
  }
  QSaveFile out(file);
  if (out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size() && out.commit()) return {};
  return fail(tr("The portfolio could not be written to '%1': %2. Choose another location.")
                  .arg(file, out.errorString())
                  .toStdString());
}

}  // namespace insonate::review
