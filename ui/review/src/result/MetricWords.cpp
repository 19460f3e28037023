#include "MetricWords.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

namespace insonate::review {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Review", text);
}

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), int(text.size()));
}

}  // namespace

const MetricDefinition& definitionOf(Metric metric) {
  return metricTable()[std::size_t(metric)];
}

QString titleOf(const MetricDefinition& metric) {
  QStringList words = qt(metric.id).split(QLatin1Char('_'));
  // The unit stands beside the value.
  static const QStringList units{QStringLiteral("s"), QStringLiteral("mm"), QStringLiteral("percent"),
                                 QStringLiteral("deg"), QStringLiteral("N")};
  if (words.size() > 1 && units.contains(words.last())) words.removeLast();
  return words.join(QLatin1Char(' '));
}

QString valueOf(const MetricDefinition& metric, const std::optional<double>& value) {
  if (!value) return tr("n/a");
  const bool count = metric.unit.empty() && *value == std::round(*value);
  const QString number = QString::number(*value, 'f', count ? 0 : metric.unit.empty() ? 2 : 1);
  return metric.unit.empty() ? number : QStringLiteral("%1 %2").arg(number, qt(metric.unit));
}

QString normOf(const MetricDefinition& metric, double value) {
  const QString number = QString::number(value, 'g', 4);
  return metric.unit.empty() ? number : QStringLiteral("%1 %2").arg(number, qt(metric.unit));
}

QString explanationOf(const MetricScore& score) {
  const MetricDefinition& metric = definitionOf(score.metric);
  QStringList parts{tr("Counted: %1").arg(qt(metric.definition))};
  if (score.norm)
    parts << tr("Novice and expert: %1").arg(QString::fromStdString(score.norm->source));
  else
    parts << tr("Novice and expert: no values are known.");
  if (!metric.evidence.empty()) parts << tr("Evidence: %1").arg(qt(metric.evidence));
  // A paragraph each, so that the tooltip wraps.
  return QStringLiteral("<p>") + parts.join(QStringLiteral("</p><p>")) + QStringLiteral("</p>");
}

}  // namespace insonate::review
