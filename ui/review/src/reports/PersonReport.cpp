#include "../class/ClassWords.h"
#include "../person/PersonCharts.h"
#include "ReportPages.h"
#include "ReportParts.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <cmath>

namespace insonate::review {
namespace {

using namespace paper;

constexpr double kChartHeight = 560;
/// Three charts beside each other are smaller than on the screen.
constexpr double kChartUnit = kScreen * 0.7;
constexpr int kMaxAttempts = 16;
constexpr double kOutcomeLeft = 830, kOutcomeWidth = kWidth - 2 * kMargin - kOutcomeLeft;

void chart(PaperColumn& page, double left, double width, const ui::ChartContents& picture) {
  const QRectF place(left, page.y(), width - 20, kChartHeight);
  if (!picture.isEmpty()) return ui::paintChart(page.painter, place, kChartUnit, picture);
  page.painter.setPen(page.ink.quiet);
  page.painter.drawText(place, Qt::AlignCenter | Qt::TextWordWrap,
                        picture.title + QStringLiteral("\n") + picture.words);
}

void charts(PaperColumn& page, const PersonFacts& facts, const HeatMap& heat) {
  const MetricMeaning& points = MetricCatalog::instance().all().front();
  const std::string level = facts.history.empty() ? std::string() : facts.history.back().level;
  const double width = kWidth - 2 * kMargin;
  const Curriculum* curriculum = facts.curriculum ? &*facts.curriculum : nullptr;
  page.heading(tr("Learning curve: %1").arg(level.empty() ? tr("all attempts") : levelTitle(curriculum, level)));
  // The ratio of their widths is that on the page of the person.
  constexpr double kLearning = 9 / 22.0, kCusum = 8 / 22.0;
  chart(page, kMargin, width * kLearning, learningOf(facts, level, points));
  chart(page, kMargin + width * kLearning, width * kCusum, cusumOf(facts, level));
  const double left = width * (kLearning + kCusum);
  chart(page, kMargin + left, width - left, placeInClass(facts, heat, points));
  page.skip(kChartHeight);
}

void levels(PaperColumn& page, const PersonFacts& facts) {
  page.heading(tr("Levels"));
  if (!facts.curriculum) page.paragraph(tr("The class has no curriculum yet."), page.ink.quiet);
  for (const LevelProgress& one : facts.progress) {
    page.cell(kMargin, 200, nameOf(one.state), one.state == LevelState::Lapsed ? page.ink.danger : page.ink.quiet);
    page.cell(kMargin + 200, 420, levelTitle(&*facts.curriculum, one.level), page.ink.text);
    const QString why = QString::fromStdString(one.why);
    page.lines(kMargin + 620, kWidth - 2 * kMargin - 620, why, page.ink.quiet);
    page.skip(page.heightOf(kWidth - 2 * kMargin - 620, why));
    if (!page.hasRoom(6 * kRow)) return;
  }
}

void attempts(PaperColumn& page, const PersonFacts& facts) {
  page.heading(tr("Latest attempts"));
  if (facts.newest.empty()) page.paragraph(tr("None yet."), page.ink.quiet);
  const Curriculum* curriculum = facts.curriculum ? &*facts.curriculum : nullptr;
  int told = 0;
  for (const StoredAttempt& one : facts.newest) {
    const QString outcome = outcomeOf(one.facts, curriculum);
    const double height = page.heightOf(kOutcomeWidth, outcome);
    if (told++ == kMaxAttempts || !page.hasRoom(height)) return;
    page.cell(kMargin, 330, ui::dayAndTimeOf(one.facts.begun_us), page.ink.text);
    page.cell(kMargin + 330, 390, levelTitle(curriculum, one.facts.level), page.ink.text);
    page.cell(kMargin + 720, 80, pointsOf(one.facts) ? QString::number(std::lround(*pointsOf(one.facts))) : tr("n/a"),
              page.ink.text, Qt::AlignRight);
    page.lines(kMargin + kOutcomeLeft, kOutcomeWidth, outcome, page.ink.quiet);
    page.skip(height);
  }
}

}  // namespace

void paintPersonReport(QPainter& painter, const PersonFacts& facts, const HeatMap& heat) {
  PaperColumn page(painter);
  page.head(QString::fromStdString(facts.person.fullName),
            {facts.curriculum ? QString::fromStdString(facts.curriculum->title) : tr("no curriculum yet"),
             countOf(int(facts.history.size()), tr("attempt"), tr("attempts"))});
  if (facts.standing) {
    painter.setFont(paperFont(kText, true));
    page.paragraph(QString::fromStdString(facts.standing->sentence), page.ink.text);
  }
  charts(page, facts, heat);
  levels(page, facts);
  attempts(page, facts);
  page.foot();
}

}  // namespace insonate::review
