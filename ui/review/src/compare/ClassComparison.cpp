#include "ClassComparison.h"

#include "../class/ClassWords.h"

#include <insonate/curriculum/Comparison.h>
#include <insonate/curriculum/Statistics.h>

#include <QCoreApplication>
#include <vector>

namespace insonate::review {
namespace {

constexpr std::size_t kLeastPeople = 4;

QString tr(const char* text) {
  return QCoreApplication::translate("Review", text);
}

std::vector<double> valuesOf(const HeatMap& heat, std::size_t metric) {
  std::vector<double> values;
  for (const auto& [person, row] : heat)
    if (row[metric].value) values.push_back(*row[metric].value);
  return values;
}

QString meanWords(const QString& name, std::span<const double> values) {
  const auto mean = meanOf(values);
  return tr("%1: n = %2, mean %3, 95 % interval %4 to %5")
      .arg(name, QString::number(values.size()), numberOf(mean->value), numberOf(mean->interval->low),
           numberOf(mean->interval->high));
}

}  // namespace

ClassComparison compareClasses(const ComparedClass& first, const ComparedClass& second, std::size_t metric) {
  ClassComparison result;
  result.picture.title = titleWithUnit(MetricBook::here().all()[metric]);
  const auto a = valuesOf(first.heat, metric), b = valuesOf(second.heat, metric);
  const auto ranks = a.size() < kLeastPeople || b.size() < kLeastPeople ? std::nullopt : compareRanks(a, b);
  if (!ranks) {
    result.picture.words =
        tr("n/a: of %1 there are %2 people with attempts that tell it, of %3 %4; at least %5 of each "
           "are needed.")
            .arg(first.name, QString::number(a.size()), second.name, QString::number(b.size()),
                 QString::number(kLeastPeople));
    result.words = result.picture.words;
    return result;
  }
  result.picture.categories = QStringList{first.name, second.name};
  result.picture.boxes.push_back({0, *boxPlotOf(a), ui::ChartPicture::Tone::Accent});
  result.picture.boxes.push_back({1, *boxPlotOf(b), ui::ChartPicture::Tone::Caution});
  result.words =
      QStringList{meanWords(first.name, a), meanWords(second.name, b),
                  tr("Effect size (Cliff's delta) %1: someone of %2 is above someone of %3 in %4 % of pairs; p = %5 "
                     "(Mann-Whitney, %6).")
                      .arg(QString::number(ranks->effect, 'f', 2), first.name, second.name,
                           QString::number(100 * ranks->superiority, 'f', 0), QString::number(ranks->p, 'g', 2),
                           ranks->exact ? tr("exact") : tr("approximate"))}
          .join(QLatin1Char('\n'));
  return result;
}

}  // namespace insonate::review
