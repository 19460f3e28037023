#include <insonate/procedure/MetricTitle.h>
#include <insonate/procedure/NeedleWords.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <QDateTime>
#include <QLocale>

namespace insonate::ui {

PlaceWords displayText(NeedlePlace place, const QString& vessel) {
  return {qt(needleSymbol(place)), qt(insonate::displayText(place, vessel.toStdString()))};
}

QString nameOf(Severity severity) {
  return severity == Severity::Minor ? tr("minor") : severity == Severity::Major ? tr("major") : tr("critical");
}

QString titleOf(Metric metric) {
  return qt(metricTitle(metric));
}

QString valueOf(Metric metric, const std::optional<double>& value) {
  return qt(metricText(metric, value));
}

QString dayAndTimeOf(std::int64_t time_us) {
  return QLocale(QLocale::English)
      .toString(QDateTime::fromMSecsSinceEpoch(time_us / 1000), QStringLiteral("d MMM yyyy, HH:mm"));
}

}  // namespace insonate::ui
