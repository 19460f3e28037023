#include "ClassComparison.h"

#include "../class/ClassWords.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/teaching/MetricCatalog.h>
#include <insonate/teaching/MetricComparison.h>
#include <insonate/ui/Text.h>

#include <cmath>
#include <span>

namespace insonate::review {
namespace {

QString meanWords(const QString& name, std::size_t count, const Estimate& mean) {
  const QString words =
      tr("%1: n = %2, mean %3").arg(name, QString::number(count), QString::fromStdString(numberOf(mean.value)));
  const QString basis = QString::fromUtf8(mean.basis.data(), int(mean.basis.size()));
  if (!mean.interval) return tr("%1, no interval: %2").arg(words, basis);
  return tr("%1, 95 % interval %2 to %3 (%4)")
      .arg(words, QString::fromStdString(numberOf(mean.interval->low)),
           QString::fromStdString(numberOf(mean.interval->high)), basis);
}

/// A dot for each person, beside the box at x. The dots are spread sideways, so that those of similar height do not
/// hide each other.
ui::ChartContents::Line peopleBeside(double x, std::span<const double> values, ui::ChartContents::Tone tone) {
  constexpr double kNear = 0.14, kWide = 0.12, kGolden = 0.618034;
  ui::ChartContents::Line dots{.name = {}, .points = {}, .tone = tone, .pen = Qt::NoPen, .dots = true};
  for (std::size_t i = 0; i < values.size(); ++i)
    dots.points.emplace_back(x + kNear + kWide * std::fmod(double(i) * kGolden, 1), values[i]);
  return dots;
}

}  // namespace

ClassComparison compareClasses(const ComparedClass& first, const ComparedClass& second, std::size_t metric) {
  ClassComparison result;
  result.picture.title =
      tr("%1: each person's mean of the last %2 attempts at levels")
          .arg(titleWithUnit(MetricCatalog::instance().all()[metric]), QString::number(kLastAttempts));
  const MetricComparison compared = compareInMetric(first.heat, second.heat, metric);
  const auto& [a, b, meanOfFirst, meanOfSecond, ranks, inBoth] = compared;
  if (!ranks || !meanOfFirst || !meanOfSecond) {
    result.picture.words =
        tr("n/a: %2 people in %1 and %4 people in %3 have data; the comparison needs at least %5 in each class.")
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
      QStringList{meanWords(first.name, a.size(), *meanOfFirst), meanWords(second.name, b.size(), *meanOfSecond),
                  tr("Effect size (Cliff's delta) %1: in %4 % of pairs the person of %2 has a higher value than the "
                     "person of %3 (equal values count half); p = %5 (Mann-Whitney, %6).")
                      .arg(QString::number(ranks->effect, 'f', 2), first.name, second.name,
                           QString::number(100 * ranks->superiority, 'f', 0), QString::number(ranks->p, 'g', 2),
                           ranks->exact ? tr("exact") : tr("approximate"))}
          .join(QLatin1Char('\n'));
  if (inBoth > 0)
    result.words +=
        QLatin1Char(' ') + tr("In both classes: %1. The p-value counts a person in both classes as two people.")
                               .arg(countOf(inBoth, tr("person"), tr("people")));
  return result;
}

}  // namespace insonate::review
