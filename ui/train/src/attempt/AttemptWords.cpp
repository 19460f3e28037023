#include "AttemptWords.h"

#include <insonate/ui/Text.h>

#include <cmath>

namespace insonate::train {
NeedlePlace disclosed(NeedlePlace place, const Disclosure& disclosure) {
  const bool inside = !disclosure.anatomy && (place == NeedlePlace::Vein || place == NeedlePlace::WrongPlace);
  return inside ? NeedlePlace::UnderSkin : place;
}

QString assistanceText(Assistance assistance) {
  return assistance == Assistance::Guided ? tr("guided") : assistance == Assistance::Hints ? tr("hints") : tr("test");
}

QString capital(const QString& words) {
  return words.left(1).toUpper() + words.mid(1);
}

QString clockOf(double time_s) {
  const int whole = int(time_s);
  return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString headlineOf(const AttemptScore& score, AttemptStatus status) {
  if (status == AttemptStatus::Abandoned) return tr("Abandoned");
  const QString end = score.succeeded ? tr("the attempt succeeded") : tr("the attempt did not succeed");
  return score.points ? tr("%1 of 100 points: %2").arg(std::lround(*score.points)).arg(end)
                      : tr("No score: %1").arg(end);
}

}  // namespace insonate::train
