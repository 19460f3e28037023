#include "ClassComparison.h"

#include "../class/ClassWords.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Comparison.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/ui/Text.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace insonate::review {
namespace {

std::vector<double> valuesOf(const HeatMap& heat, std::size_t metric) {
  std::vector<double> values;
  for (const auto& [person, row] : heat)
    if (row[metric].value) values.push_back(*row[metric].value);
  return values;
}

/// A person's mean of counts is not a count.
ValueKind kindOfMeans(const MetricMeaning& meaning) {
  return meaning.kind == ValueKind::Count ? ValueKind::NotNegative : meaning.kind;
}

QString meanWords(const QString& name, std::span<const double> values, ValueKind kind) {
  const auto mean = meanOf(values, kind);
  const QString words = tr("%1: n = %2, mean %3")
                            .arg(name, QString::number(values.size()), QString::fromStdString(numberOf(mean->value)));
  const QString basis = QString::fromUtf8(mean->basis.data(), int(mean->basis.size()));
  if (!mean->interval) return tr("%1, no interval: %2").arg(words, basis);
  return tr("%1, 95 % interval %2 to %3 (%4)")
      .arg(words, QString::fromStdString(numberOf(mean->interval->low)),
           QString::fromStdString(numberOf(mean->interval->high)), basis);
}

/// A dot for each person, beside the box at x; dots of similar height are spread sideways.
ui::ChartContents::Line peopleBeside(double x, std::span<const double> values, ui::ChartContents::Tone tone) {
  constexpr double kNear = 0.14, kWide = 0.12, kGolden = 0.618034;
  ui::ChartContents::Line dots{.name = {}, .points = {}, .tone = tone, .pen = Qt::NoPen, .dots = true};
  for (std::size_t i = 0; i < values.size(); ++i)
    dots.points.emplace_back(x + kNear + kWide * std::fmod(double(i) * kGolden, 1), values[i]);
  return dots;
}

/// Number of people in both classes; the p value treats them as different people.
std::size_t inBoth(const ComparedClass& first, const ComparedClass& second) {
  return std::size_t(
      std::ranges::count_if(first.heat, [&](const auto& one) { return second.heat.contains(one.first); }));
}

}  // namespace

ClassComparison compareClasses(const ComparedClass& first, const ComparedClass& second, std::size_t metric) {
  ClassComparison result;
  result.picture.title =
      tr("%1: each person's mean of the last %2 attempts at levels")
          .arg(titleWithUnit(MetricCatalog::instance().all()[metric]), QString::number(kLastAttempts));
  const auto a = valuesOf(first.heat, metric), b = valuesOf(second.heat, metric);
  const ValueKind kind = kindOfMeans(MetricCatalog::instance().all()[metric]);
  const auto ranks = compareRanks(a, b);
  if (!ranks) {
    result.picture.words = tr("n/a: %2 people of %1 and %4 people of %3 have data; each class needs at least %5.")
                               .arg(first.name, QString::number(a.size()), second.name, QString::number(b.size()),
                                    QString::number(kFewestCompared));
    result.words = result.picture.words;
    return result;
  }
  result.picture.categories = QStringList{first.name, second.name};
  result.picture.boxes.push_back({0, *boxPlotOf(a), ui::ChartContents::Tone::Accent});
  result.picture.boxes.push_back({1, *boxPlotOf(b), ui::ChartContents::Tone::Caution});
  result.picture.lines.push_back(peopleBeside(0, a, ui::ChartContents::Tone::Accent));
  result.picture.lines.push_back(peopleBeside(1, b, ui::ChartContents::Tone::Caution));
  result.words =
      QStringList{meanWords(first.name, a, kind), meanWords(second.name, b, kind),
                  tr("Effect size (Cliff's delta) %1: in %4 % of pairs the person of %2 has a higher value than the "
                     "person of %3; p = %5 "
                     "(Mann-Whitney, %6).")
                      .arg(QString::number(ranks->effect, 'f', 2), first.name, second.name,
                           QString::number(100 * ranks->superiority, 'f', 0), QString::number(ranks->p, 'g', 2),
                           ranks->exact ? tr("exact") : tr("approximate"))}
          .join(QLatin1Char('\n'));
  if (const std::size_t both = inBoth(first, second); both > 0)
    result.words +=
        QLatin1Char(' ') + tr("%1 are in both classes; the interval and the p-value count them as different people.")
                               .arg(countOf(both, tr("person"), tr("people")));
  return result;
}

}  // namespace insonate::review
