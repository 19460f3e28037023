#include <insonate/ui/AreaWords.h>
#include <insonate/ui/Text.h>

namespace insonate::ui {
namespace {

QString whole(double value) {
  return QString::number(value, 'f', 0);
}

double percentOf(const LumenArea& lumen) {
  return 100 * lumen.area_mm2 / lumen.rest_mm2;
}

}  // namespace

QString areaOf(const LumenArea& lumen, AreaForm form) {
  if (lumen.rest_mm2 <= 0) return tr("n/a");
  const QString share = whole(percentOf(lumen)), area = whole(lumen.area_mm2);
  switch (form) {
    case AreaForm::Full:
      return tr("%1\u00a0mm² · %2\u00a0% of the area in the CT").arg(area, share);
    case AreaForm::Short:
      return tr("%1\u00a0mm² · %2\u00a0% of CT area").arg(area, share);
    case AreaForm::Share:
      break;
  }
  return tr("%1\u00a0% of CT").arg(share);
}

QString spokenAreaOf(const LumenArea& lumen) {
  if (lumen.rest_mm2 <= 0) return tr("n/a");
  return tr("%1 square millimeters, %2 percent of the area in the CT")
      .arg(whole(lumen.area_mm2), whole(percentOf(lumen)));
}

}  // namespace insonate::ui
