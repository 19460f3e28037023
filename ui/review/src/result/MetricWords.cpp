#include "MetricWords.h"

#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Text.h>

#include <QStringList>

namespace insonate::review {
QString normOf(Metric metric, double value) {
  const QString number = QString::number(value, 'g', 4);
  const std::string_view unit = definitionOf(metric).unit;
  return unit.empty()    ? number
         : unit == "deg" ? number + QStringLiteral("°")
                         : QStringLiteral("%1 %2").arg(number, ui::qt(unit));
}

QString explanationOf(const MetricScore& score) {
  const MetricDefinition& metric = definitionOf(score.metric);
  QStringList parts{tr("Definition: %1").arg(ui::qt(metric.definition))};
  if (score.norm)
    parts << tr("Novice and expert: %1").arg(QString::fromStdString(score.norm->source));
  else
    parts << tr("Novice and expert: no values are known.");
  if (!metric.evidence.empty()) parts << tr("Evidence: %1").arg(ui::qt(metric.evidence));
  return ui::plainToolTip(parts.join(QStringLiteral("\n\n")));
}

}  // namespace insonate::review
