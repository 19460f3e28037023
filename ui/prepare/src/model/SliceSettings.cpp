#include "SliceSettings.h"

#include <QSettings>
#include <algorithm>
#include <cmath>

namespace insonate::prepare {

void SliceSettings::setWindowLevel(views::WindowLevel value) {
  if (value == windowLevel_) return;
  windowLevel_ = value;
  Q_EMIT changed();
}

void SliceSettings::setLabelOpacity(double opacity) {
  opacity = std::clamp(opacity, 0.0, 1.0);
  if (opacity == labelOpacity_) return;
  labelOpacity_ = opacity;
  Q_EMIT changed();
}

void SliceSettings::setLabelsShown(bool shown) {
  if (shown == labelsShown_) return;
  labelsShown_ = shown;
  Q_EMIT changed();
}

void SliceSettings::setLabelStyle(const views::LabelStyle& style) {
  if (style == labelStyle_) return;
  labelStyle_ = style;
  Q_EMIT changed();
}

void SliceSettings::setPlacesShown(bool shown) {
  if (shown == placesShown_) return;
  placesShown_ = shown;
  Q_EMIT changed();
}

void SliceSettings::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("window"), windowLevel_.window_HU);
  settings.setValue(QStringLiteral("level"), windowLevel_.level_HU);
  settings.setValue(QStringLiteral("labelOpacity"), labelOpacity_);
  settings.setValue(QStringLiteral("labelsShown"), labelsShown_);
  settings.setValue(QStringLiteral("labelFill"), labelStyle_.fill);
  settings.setValue(QStringLiteral("labelOutline"), labelStyle_.outline);
  settings.setValue(QStringLiteral("outlineWidth"), labelStyle_.thickness_px);
  settings.setValue(QStringLiteral("placesShown"), placesShown_);
}

void SliceSettings::restore(const QSettings& settings) {
  const auto number = [&settings](const char* key, double otherwise) {
    const double value = settings.value(QLatin1String(key), otherwise).toDouble();
    return std::isfinite(value) ? value : otherwise;
  };
  const views::WindowLevel usual;
  setWindowLevel({std::clamp(number("window", usual.window_HU), 1.0, 10000.0),
                  std::clamp(number("level", usual.level_HU), -5000.0, 10000.0)});
  setLabelOpacity(number("labelOpacity", labelOpacity_));
  setLabelsShown(settings.value(QStringLiteral("labelsShown"), true).toBool());
  setLabelStyle({settings.value(QStringLiteral("labelFill"), true).toBool(),
                 settings.value(QStringLiteral("labelOutline"), true).toBool(),
                 int(std::clamp(number("outlineWidth", 1), 1.0, 8.0))});
  setPlacesShown(settings.value(QStringLiteral("placesShown"), true).toBool());
}

}  // namespace insonate::prepare
