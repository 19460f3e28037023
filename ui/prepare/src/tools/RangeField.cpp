#include "RangeField.h"

#include <insonate/segmentation/HistogramThreshold.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <span>

namespace insonate::prepare {
namespace {

constexpr int kMin_HU = -1024, kMax_HU = 3071, kStep_HU = 5, kNumber_px = 88;

QSpinBox* number(const QString& objectName, const QString& name, const QString& tip) {
  auto* made = new QSpinBox;
  made->setObjectName(objectName);
  made->setAccessibleName(name);
  made->setToolTip(tip);
  made->setRange(kMin_HU, kMax_HU);
  made->setSingleStep(kStep_HU);
  made->setSuffix(RangeField::tr(" HU"));
  made->setKeyboardTracking(false);
  made->setFixedWidth(kNumber_px);
  return made;
}

}  // namespace

RangeField::RangeField(const QString& name, QWidget* parent)
    : QWidget(parent),
      strip_(new RangeStrip),
      from_(number(name + QStringLiteral("-from"), tr("from"), tr("Lower limit of the range of CT values"))),
      to_(number(name + QStringLiteral("-to"), tr("to"), tr("Upper limit of the range of CT values"))) {
  strip_->setObjectName(name + QStringLiteral("-strip"));
  auto* numbers = new QHBoxLayout;
  numbers->addWidget(from_);
  numbers->addWidget(new QLabel(QStringLiteral("\u2013")), 1, Qt::AlignCenter);
  numbers->addWidget(to_);
  auto* parts = new QHBoxLayout;
  const auto button = [&name](const char* what, const QString& words, const QString& tip) {
    return ui::pushButton((name + QLatin1String(what)).toUtf8(), words, tip);
  };
  auto* darker =
      button("-darker", tr("Darker"), tr("Narrows the range to its darker part, which is found by Otsu's method"));
  auto* brighter = button(
      "-brighter", tr("Brighter"),
      tr("Narrows the range to its brighter part, which is found by Otsu's method; click again to narrow it further"));
  auto* whole = button("-all", tr("All"), tr("Selects the full range of CT values"));
  for (QPushButton* one : {darker, brighter, whole}) parts->addWidget(one, 1);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(strip_);
  box->addLayout(numbers);
  box->addLayout(parts);
  connect(strip_, &RangeStrip::dragged, this, &RangeField::edit);
  // The typed end stays; the other end moves.
  connect(from_, qOverload<int>(&QSpinBox::valueChanged), this, [this](int low) {
    if (!showing_) edit({low, std::max(low, to_->value())});
  });
  connect(to_, qOverload<int>(&QSpinBox::valueChanged), this, [this](int high) {
    if (!showing_) edit({std::min(high, from_->value()), high});
  });
  connect(darker, &QPushButton::clicked, this, [this] { part(false); });
  connect(brighter, &QPushButton::clicked, this, [this] { part(true); });
  connect(whole, &QPushButton::clicked, this, [this] { edit({kMin_HU, kMax_HU}); });
}

void RangeField::setHistogram(const views::HuHistogram& histogram) {
  histogram_ = histogram;
  strip_->setHistogram(histogram);
}

void RangeField::setRange(HuRange range) {
  range_ = range;
  showing_ = true;
  strip_->setRange(range);
  from_->setValue(range.low);
  to_->setValue(range.high);
  showing_ = false;
}

void RangeField::edit(HuRange range) {
  setRange(range);
  Q_EMIT edited(range);
}

/// Enter ends the input of the number only, and the window has its keys again.
void RangeField::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!enter || !(from_->hasFocus() || to_->hasFocus())) return QWidget::keyPressEvent(event);
  setFocus();
}

void RangeField::part(bool brighter) {
  if (histogram_.counts.empty()) return;
  const double bin_HU = histogram_.binWidth_HU();
  const auto bins = double(histogram_.counts.size());
  const auto binOf = [&](double hu) {
    return std::size_t(std::clamp(std::floor((hu - histogram_.min_HU) / bin_HU), 0.0, bins - 1));
  };
  const std::size_t first = binOf(range_.low), last = binOf(range_.high);
  const auto parted = otsuBin(std::span(histogram_.counts).subspan(first, last - first + 1));
  if (!parted) return;
  const int edge_HU = int(std::lround(histogram_.min_HU + double(first + *parted) * bin_HU));
  edit(brighter ? HuRange{std::min(edge_HU, range_.high), range_.high}
                : HuRange{range_.low, std::max(edge_HU - 1, range_.low)});
}

}  // namespace insonate::prepare
