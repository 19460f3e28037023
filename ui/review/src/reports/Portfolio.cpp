#include "Portfolio.h"

#include "../class/ClassWords.h"
#include "../person/PersonCharts.h"

#include <insonate/ui/Text.h>

#include <QPainter>
#include <algorithm>

namespace insonate::review {
namespace {

constexpr int kAtOnce = 500;
constexpr double kTitle_pt = 9, kTitle_px = 22, kCurvesGap_px = 10;
/// A chart of the screen is reduced to half the width of the text.
constexpr double kCurveUnit = 0.72;

/// Tells whether a form is a judgement by a rater. Forms of later programs are unknown here; raters alone fill in forms
/// about others.
bool isJudgement(const StoredForm& one) {
  const auto form = loadForm(one.filled.form);
  return form ? form->isJudgement() : one.filled.by != one.filled.person;
}

/// Draws the title of a level, with its charts below.
QPicture drawnLevel(const QString& title, const std::vector<ui::ChartContents>& charts) {
  QPicture drawing;
  QPainter painter(&drawing);
  QFont font(QStringLiteral("sans-serif"));
  font.setPointSizeF(kTitle_pt);
  font.setBold(true);
  painter.setFont(font);
  painter.drawText(QRectF(0, 0, kCurves_px.width(), kTitle_px), Qt::AlignLeft | Qt::AlignVCenter, title);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const QRectF place(double(i) * kCurves_px.width() / 2, kTitle_px, kCurves_px.width() / 2 - kCurvesGap_px,
                       kCurves_px.height() - kTitle_px - kCurvesGap_px);
    ui::paintChart(painter, place, kCurveUnit, charts[i]);
  }
  return drawing;
}

}  // namespace

Result<Portfolio> readPortfolio(const SignedIn& by, const std::string& person,
                                const std::optional<Curriculum>& curriculum, std::int64_t now_us) {
  Portfolio portfolio;
  portfolio.reader = by.person().fullName;
  auto facts = readPerson(by, person, curriculum, now_us);
  if (!facts) return tl::unexpected(facts.error());
  portfolio.person = std::move(*facts);
  // Only instructors see flags.
  if (by.person().role == Role::Trainee) portfolio.person.notes.implausible.clear();
  for (std::int64_t before = 0;;) {
    const auto page = AttemptStore(by).page(person, kAtOnce, before);
    if (!page) return tl::unexpected(page.error());
    portfolio.attempts.insert(portfolio.attempts.end(), page->begin(), page->end());
    if (int(page->size()) < kAtOnce) break;
    before = page->back().arrival;
  }
  std::ranges::reverse(portfolio.attempts);
  for (const auto& [attempt, count] : portfolio.person.notes.comments) {
    const auto comments = CommentStore(by).listByAttempt(attempt);
    if (!comments) return tl::unexpected(comments.error());
    portfolio.comments.insert(portfolio.comments.end(), comments->begin(), comments->end());
  }
  auto forms = FormStore(by).listByPerson(person);
  if (!forms) return tl::unexpected(forms.error());
  std::erase_if(*forms, [](const StoredForm& one) { return !isJudgement(one); });
  portfolio.judgements = std::move(*forms);
  return portfolio;
}

std::vector<QPicture> curvesOf(const Portfolio& portfolio) {
  std::vector<QPicture> curves;
  const PersonFacts& facts = portfolio.person;
  if (!facts.curriculum) return curves;
  const MetricMeaning& points = MetricCatalog::instance().all().front();
  for (const Level& level : facts.curriculum->levels) {
    std::vector charts{learningOf(facts, level.name, points)};
    if (level.mastery.cusum) charts.push_back(cusumOf(facts, level.name));
    std::erase_if(charts, [](const ui::ChartContents& one) { return one.isEmpty(); });
    if (!charts.empty()) curves.push_back(drawnLevel(QString::fromStdString(level.title), charts));
  }
  return curves;
}

}  // namespace insonate::review
