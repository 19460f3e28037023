#include <insonate/procedure/MetricTitle.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <QDateTime>
#include <QLocale>
#include <cmath>

namespace insonate::ui {

PlaceWords wordsOf(NeedlePlace place, const QString& vessel) {
  switch (place) {
    case NeedlePlace::Clean:
      return {QStringLiteral("○"), tr("needle is new")};
    case NeedlePlace::Underway:
      return {QStringLiteral("◐"), tr("needle is inserted")};
    case NeedlePlace::Vein:
      return {QStringLiteral("●"), vessel.isEmpty() ? tr("in the vein") : tr("in the %1").arg(vessel)};
    case NeedlePlace::WrongPlace:
      return {QStringLiteral("▲"), vessel.isEmpty() ? tr("wrong place") : tr("wrong place: %1").arg(vessel)};
    case NeedlePlace::Used:
      break;
  }
  return {QStringLiteral("■"), tr("needle is already used")};
}

QString wordOf(Severity severity) {
  return severity == Severity::Minor ? tr("minor") : severity == Severity::Major ? tr("major") : tr("critical");
}

QString titleOf(Metric metric) {
  return qt(metricTitle(metric));
}

QString valueOf(Metric metric, const std::optional<double>& value) {
  if (!value) return tr("n/a");
  const QString unit = qt(definitionOf(metric).unit);
  const bool isCount = unit.isEmpty() && *value == std::round(*value);
  const QString number = QString::number(*value, 'f', isCount ? 0 : unit.isEmpty() ? 2 : 1);
  return unit.isEmpty() ? number : unit == QLatin1String("deg") ? number + QStringLiteral("°") : number + ' ' + unit;
}

QString dayAndTimeOf(std::int64_t time_us) {
  return QLocale(QLocale::English)
      .toString(QDateTime::fromMSecsSinceEpoch(time_us / 1000), QStringLiteral("d MMM yyyy, HH:mm"));
}

}  // namespace insonate::ui
