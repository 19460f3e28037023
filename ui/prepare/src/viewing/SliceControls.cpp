#include "SliceControls.h"

#include "../model/PrepareModel.h"
#include "../model/SliceSettings.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>
#include <array>

namespace insonate::prepare {
namespace {

constexpr double kPercent = 100;

QString presetText(const views::WindowLevelPreset& preset) {
  return QStringLiteral("%1   %2 / %3")
      .arg(ui::qt(preset.name))
      .arg(preset.value.window_HU, 0, 'f', 0)
      .arg(preset.value.level_HU, 0, 'f', 0);
}

struct Style {
  QString name;
  bool fill, outline;
};

const std::array<Style, 3>& styles() {
  static const std::array<Style, 3> all{{{SliceControls::tr("fill and outline"), true, true},
                                         {SliceControls::tr("outline"), false, true},
                                         {SliceControls::tr("fill"), true, false}}};
  return all;
}

}  // namespace

SliceControls::SliceControls(PrepareModel& shared, const ui::Commands& commands)
    : shared_(shared),
      preset_(new QComboBox),
      window_(new ui::ValueSlider(tr("window"), tr("HU"), {1, 3000, 350, 10, 0},
                                  tr("range of Hounsfield units from black to white; drag with the right button left "
                                     "or right on a slice to change it"))),
      level_(new ui::ValueSlider(tr("level"), tr("HU"), {-1000, 1500, 50, 10, 0},
                                 tr("CT value shown as mid gray, in Hounsfield units; drag with the right button up or "
                                    "down on a slice to change it"))),
      opacity_(new ui::ValueSlider(tr("label opacity"), QStringLiteral("%"), {0, kPercent, 25, 5, 0},
                                   tr("opacity of labels on the slices (%1)")
                                       .arg(commands.find(QStringLiteral("prepare.slices.opacity"))->listed))),
      style_(new QComboBox),
      width_(new ui::ValueSlider(tr("outline"), tr("px"), {1, 6, 1, 1, 0}, tr("thickness of label outlines"))),
      labels_(new QCheckBox(tr("labels on slices"))),
      places_(new QCheckBox(tr("targets, landmarks, start poses"))) {
  preset_->setObjectName(QStringLiteral("windowPreset"));
  preset_->setAccessibleName(tr("Window and level of the CT"));
  preset_->setToolTip(tr("Radiological presets of window and level, in Hounsfield units"));
  for (const auto& preset : views::windowLevelPresets()) preset_->addItem(presetText(preset));
  preset_->addItem(tr("custom"));
  window_->setObjectName(QStringLiteral("window"));
  level_->setObjectName(QStringLiteral("level"));
  opacity_->setObjectName(QStringLiteral("labelOpacity"));
  style_->setObjectName(QStringLiteral("labelStyle"));
  style_->setAccessibleName(tr("Display of labels on slices"));
  style_->setToolTip(tr("Display of labels on slices"));
  for (const Style& style : styles()) style_->addItem(style.name);
  width_->setObjectName(QStringLiteral("outlineWidth"));
  places_->setObjectName(QStringLiteral("placesShown"));
  places_->setToolTip(tr("Shows targets, landmarks and start poses on the slices and in 3D"));
  labels_->setObjectName(QStringLiteral("labelsShown"));
  labels_->setToolTip(commands.toolTip(QStringLiteral("prepare.slices.labels")));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(preset_);
  for (QWidget* part : {static_cast<QWidget*>(window_), static_cast<QWidget*>(level_), static_cast<QWidget*>(labels_),
                        static_cast<QWidget*>(style_), static_cast<QWidget*>(opacity_), static_cast<QWidget*>(width_),
                        static_cast<QWidget*>(places_)})
    box->addWidget(part);

  connect(preset_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    const auto presets = views::windowLevelPresets();
    if (index < int(presets.size())) shared_.slices.setWindowLevel(presets[std::size_t(index)].value);
  });
  const auto typed = [this] {
    if (!showing_) shared_.slices.setWindowLevel({window_->value(), level_->value()});
  };
  connect(window_, &ui::ValueSlider::valueChanged, this, typed);
  connect(level_, &ui::ValueSlider::valueChanged, this, typed);
  connect(opacity_, &ui::ValueSlider::valueChanged, this, [this](double percent) {
    if (!showing_) shared_.slices.setLabelOpacity(percent / kPercent);
  });
  connect(style_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    const Style& chosen = styles()[std::size_t(index)];
    shared_.slices.setLabelStyle({chosen.fill, chosen.outline, shared_.slices.labelStyle().thickness_px});
  });
  connect(width_, &ui::ValueSlider::valueChanged, this, [this](double px) {
    views::LabelStyle style = shared_.slices.labelStyle();
    style.thickness_px = int(px);
    if (!showing_) shared_.slices.setLabelStyle(style);
  });
  connect(places_, &QCheckBox::toggled, this, [this](bool on) { shared_.slices.setPlacesShown(on); });
  connect(labels_, &QCheckBox::toggled, this, [this](bool on) { shared_.slices.setLabelsShown(on); });
  connect(&shared_.slices, &SliceSettings::changed, this, [this] { refresh(); });
  refresh();
}

void SliceControls::refresh() {
  showing_ = true;
  const views::WindowLevel& value = shared_.slices.windowLevel();
  const auto presets = views::windowLevelPresets();
  int index = 0;
  while (index < int(presets.size()) && presets[std::size_t(index)].value != value) ++index;
  preset_->setCurrentIndex(index);
  window_->setValue(value.window_HU);
  level_->setValue(value.level_HU);
  opacity_->setValue(kPercent * shared_.slices.labelOpacity());
  labels_->setChecked(shared_.slices.labelsShown());
  const views::LabelStyle& style = shared_.slices.labelStyle();
  for (std::size_t n = 0; n < styles().size(); ++n)
    if (styles()[n].fill == style.fill && styles()[n].outline == style.outline) style_->setCurrentIndex(int(n));
  opacity_->setEnabled(style.fill);
  width_->setValue(style.thickness_px);
  width_->setEnabled(style.outline);
  places_->setChecked(shared_.slices.placesShown());
  showing_ = false;
}

}  // namespace insonate::prepare
