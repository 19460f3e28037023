#include "ControlsColumn.h"

#include <QVBoxLayout>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr int kScrollBar_px = 16;
/// The titles of the procedures that come with Insonate are shown whole.
constexpr int kLeast_px = 310;

}  // namespace

ControlsColumn::ControlsColumn(QWidget* parent)
    : ScrollingColumn(parent), inner_(new QWidget), sections_(new QVBoxLayout(inner_)) {
  setObjectName("trainControls");
  sections_->setContentsMargins(12, 8, 12, 8);
  sections_->setSpacing(12);
  sections_->addStretch();
  auto* foot = new QWidget;
  foot_ = new QVBoxLayout(foot);
  foot_->setContentsMargins(12, 8, 12, 8);
  setParts(inner_, foot);
}

void ControlsColumn::addSection(QWidget* section) {
  sections_->insertWidget(sections_->count() - 1, section);
  setMinimumWidth(std::max(kLeast_px, inner_->minimumSizeHint().width() + kScrollBar_px));
}

void ControlsColumn::setFoot(QWidget* foot) {
  foot_->addWidget(foot);
}

}  // namespace insonate::train
