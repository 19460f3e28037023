#include "Structures.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QPainter>
#include <algorithm>

namespace insonate::prepare {

double defaultOpacity(std::uint8_t label) {
  constexpr double kSkinOpacity = 0.25;
  switch (label) {
    case kSkin:
      return kSkinOpacity;
    case kFat:
    case kMuscle:
    case kSoftTissue:
      return 0;
    default:
      return 1;
  }
}

double defaultShareOnSlices(std::uint8_t label) {
  constexpr double kFillingShare = 0.4;
  return label == kFat || label == kMuscle || label == kSoftTissue ? kFillingShare : 1;
}

StructureLooks defaultLooks(const LabelColors& colors) {
  StructureLooks looks;
  for (int label = 0; label < 256; ++label) {
    const auto value = std::uint8_t(label);
    looks[value] = {viewColor(caseLabelColor(colors, value)), defaultOpacity(value), true, defaultShareOnSlices(value)};
  }
  return looks;
}

bool colorsDiffer(const StructureLooks& looks, const std::vector<std::uint8_t>& structures, const LabelColors& colors) {
  return std::ranges::any_of(
      structures, [&](std::uint8_t label) { return labelColor(looks[label].color) != caseLabelColor(colors, label); });
}

void putColors(const StructureLooks& looks, const std::vector<std::uint8_t>& structures, LabelColors& colors) {
  for (const std::uint8_t label : structures) {
    const LabelColor color = labelColor(looks[label].color);
    if (color == caseLabelColor({}, label))
      colors.erase(label);
    else
      colors[label] = color;
  }
}

void takeShown(const ShownStructures& shown, StructureLooks& looks) {
  for (const auto& [label, how] : shown) looks[label].opacity = how.opacity, looks[label].visible = how.visible;
}

bool shownDiffers(const StructureLooks& a, const StructureLooks& b, const std::vector<std::uint8_t>& structures) {
  return std::ranges::any_of(structures, [&](std::uint8_t label) {
    return a[label].opacity != b[label].opacity || a[label].visible != b[label].visible;
  });
}

void putShown(const StructureLooks& looks, const std::vector<std::uint8_t>& structures, ShownStructures& shown) {
  for (const std::uint8_t label : structures) shown[label] = {looks[label].opacity, looks[label].visible};
}

QString structureName(std::uint8_t label) {
  if (label >= kLabelCount) return QStringLiteral("label %1").arg(int(label));
  const std::string_view name = labelTable()[label].name;
  return ui::qt(name);
}

QString volumeText(double volume_ml) {
  return QString::number(volume_ml, 'f', volume_ml < 10 ? 2 : volume_ml < 100 ? 1 : 0);
}

QPixmap swatch(views::Color color) {
  constexpr int kSwatch_px = 16, kSharp = 3;
  QPixmap pixmap(kSwatch_px * kSharp, kSwatch_px * kSharp);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ui::toQColor(views::theme::kQuiet), kSharp));
  painter.setBrush(ui::toQColor(color));
  painter.drawRoundedRect(QRectF(pixmap.rect()).adjusted(2, 2, -2, -2), 3 * kSharp, 3 * kSharp);
  painter.end();
  pixmap.setDevicePixelRatio(kSharp);
  return pixmap;
}

}  // namespace insonate::prepare
