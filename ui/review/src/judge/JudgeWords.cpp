#include "JudgeWords.h"

#include "../class/ClassWords.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/ui/Text.h>

#include <cmath>

namespace insonate::review {
QString coefficientOf(const std::optional<double>& value) {
  if (!value) return tr("n/a");
  const double rounded = std::round(*value * 100) / 100;
  return QString::number(rounded == 0 ? 0 : rounded, 'f', 2);  // avoids "-0.00"
}

QString coefficientOf(const std::optional<Estimate>& value) {
  if (!value || !value->interval) return coefficientOf(value ? std::optional(value->value) : std::nullopt);
  return tr("%1 (%2 to %3)")
      .arg(coefficientOf(std::optional(value->value)), coefficientOf(std::optional(value->interval->low)),
           coefficientOf(std::optional(value->interval->high)));
}

QString percentOf(const std::optional<double>& share) {
  return share ? tr("%1 %").arg(std::lround(*share * 100)) : tr("n/a");
}

QString displayText(const RaterPair& pair) {
  const RaterComparison& comparison = pair.comparison;
  return tr("%1 and %2: %3 of %4 answers equal, kappa %5, ICC of the scores %6")
      .arg(QString::fromStdString(pair.first), QString::fromStdString(pair.second), percentOf(comparison.agreement),
           QString::number(comparison.pairs), coefficientOf(comparison.kappa), coefficientOf(comparison.scores));
}

QString scoreWords(const FormScore& score) {
  if (!score.percent) return tr("n/a");
  return tr("%1 % (%2 of %3 points)")
      .arg(QString::number(std::lround(*score.percent)), QString::fromStdString(numberOf(score.points)),
           QString::fromStdString(numberOf(score.maxPoints)));
}

}  // namespace insonate::review
