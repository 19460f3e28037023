#include "Words.h"

#include <insonate/procedure/Procedure.h>
#include <insonate/ui/Text.h>

#include <QDateTime>
#include <QLocale>

namespace insonate::review {
QString clockOf(std::int64_t time_us) {
  const qint64 hundredths = (time_us + 5000) / 10000;
  return QStringLiteral("%1:%2.%3")
      .arg(hundredths / 6000)
      .arg(hundredths / 100 % 60, 2, 10, QLatin1Char('0'))
      .arg(hundredths % 100, 2, 10, QLatin1Char('0'));
}

QString displayText(AttemptStatus status) {
  switch (status) {
    case AttemptStatus::Completed:
      return tr("completed");
    case AttemptStatus::Abandoned:
      return tr("abandoned");
    case AttemptStatus::CutShort:
      break;
  }
  return tr("abandoned: the recording stopped early");
}

QString displayText(const HandKinds& hands) {
  const auto nameOf = [](const std::string& kind) {
    if (kind == "mouse") return tr("mouse and keys");
    if (kind == "simulated") return tr("simulated device");
    if (kind == "force") return tr("haptic device");
    if (kind == "motion") return tr("3D mouse");
    if (kind == "controller") return tr("game controller");
    return QString::fromStdString(kind);  // camera, tracker
  };
  if (hands.probe.empty() && hands.needle.empty()) return {};
  if (hands.probe == hands.needle) return nameOf(hands.probe);
  return tr("probe: %1, needle: %2").arg(nameOf(hands.probe), nameOf(hands.needle));
}

QString dateOf(const std::string& begun) {
  const QString text = QString::fromStdString(begun);
  const QDateTime date = QDateTime::fromString(text, Qt::ISODate);
  return date.isValid() ? QLocale(QLocale::English).toString(date.toLocalTime(), QStringLiteral("d MMM yyyy, HH:mm"))
                        : text;
}

QString titleOf(const AttemptHeader& header) {
  const auto procedure = builtInProcedure(header.procedure);
  return QString::fromStdString(procedure ? procedure->title : header.procedure);
}

}  // namespace insonate::review
