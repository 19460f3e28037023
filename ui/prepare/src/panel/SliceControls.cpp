#include "SliceControls.h"

#include "../PrepareSession.h"

#include <insonate/ui/QuietWheel.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr double kPercent = 100;

QString presetText(const views::WindowLevelPreset& preset) {
  return QStringLiteral("%1   %2 / %3")
      .arg(QString::fromUtf8(preset.name.data(), int(preset.name.size())))
      .arg(preset.value.window_HU, 0, 'f', 0)
      .arg(preset.value.level_HU, 0, 'f', 0);
}

}  // namespace

SliceControls::SliceControls(PrepareSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      preset_(new QComboBox),
      window_(new ui::ValueSlider(tr("window"), tr("HU"), {1, 3000, 350, 10, 0},
                                  tr("range of Hounsfield units from black to white; right drag across a slice"))),
      level_(new ui::ValueSlider(tr("level"), tr("HU"), {-1000, 1500, 50, 10, 0},
                                 tr("Hounsfield units that are mid grey; right drag along a slice"))),
      opacity_(new ui::ValueSlider(tr("label opacity"), QStringLiteral("%"), {0, kPercent, 25, 5, 0},
                                   tr("how strongly labels colour the slices (A, D)"))),
      labels_(new QCheckBox(tr("labels on slices"))) {
  new ui::QuietWheel(preset_);
  preset_->setObjectName(QStringLiteral("windowPreset"));
  preset_->setAccessibleName(tr("Window and level of the CT"));
  preset_->setToolTip(tr("Window and level that radiologists know, in Hounsfield units"));
  for (const auto& preset : views::windowLevelPresets()) preset_->addItem(presetText(preset));
  preset_->addItem(tr("own"));
  window_->setObjectName(QStringLiteral("window"));
  level_->setObjectName(QStringLiteral("level"));
  opacity_->setObjectName(QStringLiteral("labelOpacity"));
  labels_->setObjectName(QStringLiteral("labelsShown"));
  labels_->setToolTip(tr("Show or hide the labels over the slices (G)"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(preset_);
  for (QWidget* part : {static_cast<QWidget*>(window_), static_cast<QWidget*>(level_), static_cast<QWidget*>(opacity_),
                        static_cast<QWidget*>(labels_)})
    box->addWidget(part);

  connect(preset_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    const auto presets = views::windowLevelPresets();
    if (index < int(presets.size())) session_.setWindowLevel(presets[std::size_t(index)].value);
  });
  const auto typed = [this] {
    if (!showing_) session_.setWindowLevel({window_->value(), level_->value()});
  };
  connect(window_, &ui::ValueSlider::valueChanged, this, typed);
  connect(level_, &ui::ValueSlider::valueChanged, this, typed);
  connect(opacity_, &ui::ValueSlider::valueChanged, this, [this](double percent) {
    if (!showing_) session_.setLabelOpacity(percent / kPercent);
  });
  connect(labels_, &QCheckBox::toggled, this, [this](bool on) { session_.setLabelsShown(on); });
  connect(&session_, &PrepareSession::slicesChanged, this, [this] { refresh(); });
  refresh();
}

void SliceControls::refresh() {
  showing_ = true;
  const views::WindowLevel& value = session_.windowLevel();
  const auto presets = views::windowLevelPresets();
  int index = 0;
  while (index < int(presets.size()) && presets[std::size_t(index)].value != value) ++index;
  preset_->setCurrentIndex(index);
  window_->setValue(value.window_HU);
  level_->setValue(value.level_HU);
  opacity_->setValue(kPercent * session_.labelOpacity());
  labels_->setChecked(session_.labelsShown());
  showing_ = false;
}

}  // namespace insonate::prepare
