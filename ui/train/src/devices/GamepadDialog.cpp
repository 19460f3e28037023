#include "GamepadDialog.h"

#include "GamepadControl.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace insonate::train {

GamepadDialog::GamepadDialog(GamepadControl& control, QWidget* parent) : QDialog(parent), control_(control) {
  setObjectName("gamepadDialog");
  setWindowTitle(tr("Game controller"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  box->setSpacing(ui::kGap);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(ui::kLargeGap);
  for (int n = 0; n < kGamepadFunctions; ++n) {
    const auto function = GamepadFunction(n);
    auto* choice = ui::choiceBox("", nameOfFunction(function), tr("Stick, trigger or button for this function"));
    choice->setObjectName(QStringLiteral("control") + QString::number(n));
    for (int one = 0; one < kGamepadAxes + kGamepadButtons; ++one) choice->addItem(nameOfControl(one));
    connect(choice, qOverload<int>(&QComboBox::activated), this, [this, function](int one) {
      GamepadMap map = control_.map();
      map.setControl(function, one);
      control_.setMap(map);
    });
    grid->addWidget(new QLabel(nameOfFunction(function)), n, 0);
    grid->addWidget(choice, n, 1);
    controls_.push_back(choice);
  }
  box->addLayout(grid);
  auto* usual = ui::pushButton("usualControls", tr("Restore defaults"), tr("Restores the original assignment"));
  connect(usual, &QPushButton::clicked, this, [this] {
    control_.setMap({});
    refresh();
  });
  box->addWidget(usual, 0, Qt::AlignRight);
  refresh();
}

void GamepadDialog::refresh() {
  for (int n = 0; n < kGamepadFunctions; ++n)
    controls_[std::size_t(n)]->setCurrentIndex(control_.map().controlOf(GamepadFunction(n)));
}

}  // namespace insonate::train
