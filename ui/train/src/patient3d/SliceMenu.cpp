#include "SliceMenu.h"

#include "../feature/CommandWords.h"

#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QActionGroup>
#include <QVBoxLayout>
#include <QWidgetAction>

namespace insonate::train {
namespace {

constexpr int kOpacitySlider_px = 220;

QString words(const views::WindowLevelPreset& preset) {
  return ui::qt(preset.name);
}

}  // namespace

SliceMenu::SliceMenu(views::MprView& slice, const ui::Commands& commands, QWidget* parent)
    : QMenu(parent), slice_(slice), presets_(new QActionGroup(this)) {
  setToolTipsVisible(true);
  int number = 0;
  for (const views::WindowLevelPreset& preset : views::windowLevelPresets()) {
    QAction* action = addAction(
        QStringLiteral("%1\t%2").arg(words(preset), keyText(commands, "train.patient3d.window", std::size_t(number))));
    action->setToolTip(tr("Window %1 HU, level %2 HU").arg(preset.value.window_HU).arg(preset.value.level_HU));
    action->setCheckable(true);
    presets_->addAction(action);
    connect(action, &QAction::triggered, this, [this, number] { choose(number); });
    ++number;
  }
  addSeparator();
  addStructures();
  addSeparator();
  connect(addAction(tr("Fit slice\tR")), &QAction::triggered, this,
          [this] { forAll([](views::MprView& one) { one.fit(); }); });
  connect(this, &QMenu::aboutToShow, this, [this] { refresh(); });
}

void SliceMenu::addStructures() {
  opacity_ = new ui::ValueSlider(tr("structures"), QStringLiteral("%"), {0, 100, 0, 5, 0},
                                 tr("opacity of the structures over the CT (G, A, D)"));
  opacity_->setObjectName(QStringLiteral("labelOpacity"));
  opacity_->setMinimumWidth(kOpacitySlider_px);
  connect(opacity_, &ui::ValueSlider::valueChanged, this, [this](double percent) {
    forAll([percent](views::MprView& slice) {
      slice.setLabelOpacity(percent / 100);
      if (percent > 0) slice.setLabelsVisible(true);
    });
  });
  auto* room = new QWidget;
  auto* box = new QVBoxLayout(room);
  box->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kSmallGap);
  box->addWidget(opacity_);
  auto* action = new QWidgetAction(this);
  action->setDefaultWidget(room);
  addAction(action);
}

void SliceMenu::forAll(const std::function<void(views::MprView&)>& act) {
  act(slice_);
  for (views::MprView* other : others_) act(*other);
}

void SliceMenu::choose(int preset) {
  const auto presets = views::windowLevelPresets();
  if (preset < 0 || preset >= int(presets.size())) return;
  slice_.setWindowLevel(presets[std::size_t(preset)].value);
  if (chosen_) chosen_(slice_.windowLevel());
}

void SliceMenu::refresh() {
  const auto presets = views::windowLevelPresets();
  for (int i = 0; i < presets_->actions().size(); ++i)
    presets_->actions()[i]->setChecked(presets[std::size_t(i)].value == slice_.windowLevel());
  opacity_->setValue(100 * slice_.labelOpacity());
}

}  // namespace insonate::train
