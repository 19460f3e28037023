#include "TissueStrip.h"

#include "../TrainSession.h"
#include "VesselAreas.h"

#include <insonate/ui/Theme.h>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

namespace insonate::train {
namespace {

constexpr double kMostUnsettled_N = 6;

constexpr int kReadable_ms = 150;
constexpr int kSpace = 12, kSmallSpace = 4;
const QString kShort = QStringLiteral("...");

struct Row {
  const char* object;
  const char* text;
  const char* says;
};
constexpr Row kRows[] = {
    {"tissueGrid", "Displaced grid\tT", "Lines of the tissue's mesh over the picture, as it lies now"},
    {"tissuePressure", "Pressure in the tissue\tP",
     "How hard the tissue is squeezed, in kPa, in colours over the picture"},
    {"tissuePlot", "Areas against force\tK", "Curve of the areas of vein and artery against the probe's force"},
};

QLabel* number(const char* object, const QString& says, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(object));
  label->setToolTip(says);
  return label;
}

}  // namespace

TissueStrip::TissueStrip(TrainSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      force_(number("pressForce", tr("Force with which the tissue presses back on the probe, in N"), this)),
      indentation_(number("pressIndentation", tr("How far the probe is in, from where it first touches, in mm"), this)),
      vein_(
          number("veinArea", tr("Area of the vein in the picture's plane: in % of that in the CT, and in cm²"), this)),
      artery_(number("arteryArea", tr("Area of the artery in the picture's plane: in % of that in the CT, and in cm²"),
                     this)),
      menu_(new QPushButton(tr("Tissue"), this)) {
  setObjectName("tissueStrip");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 0);
  row->setSpacing(kSpace);
  for (QLabel* label : {force_, indentation_, vein_, artery_}) row->addWidget(label);
  row->addStretch(1);
  row->addWidget(menu_);
  buildMenu();
  for (const auto& [label, vessel] : {std::pair{vein_, kVein}, {artery_, kArtery}})
    label->setStyleSheet(QStringLiteral("color: %1").arg(vesselColour(vessel).name()));
  soon_.setSingleShot(true);
  soon_.setInterval(kReadable_ms);
  connect(&soon_, &QTimer::timeout, this, [this] { refresh(); });
  connect(&session_, &TrainSession::pictureShown, this, [this] { follow(); });
  connect(&session_, &TrainSession::caseChanged, this, [this] { refresh(); });
  reserve();
  refresh();
}

void TissueStrip::buildMenu() {
  menu_->setObjectName("tissueMenu");
  menu_->setAccessibleName(tr("What is shown of the tissue"));
  menu_->setToolTip(tr("Show the displaced grid (T), the pressure in the tissue (P), areas against force (K)"));
  menu_->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(menu_);
  menu->setToolTipsVisible(true);
  for (int k = 0; k < kShows; ++k) {
    auto* action = menu->addAction(tr(kRows[k].text));
    action->setObjectName(QLatin1String(kRows[k].object));
    action->setToolTip(tr(kRows[k].says));
    action->setCheckable(true);
    connect(action, &QAction::toggled, this, &TissueStrip::shownChanged);
    shows_[k] = action;
  }
  menu_->setMenu(menu);
}

bool TissueStrip::shows(Show what) const {
  return shows_[what]->isChecked();
}

void TissueStrip::setShown(Show what, bool on) {
  shows_[what]->setChecked(on);
}

/// Room for the widest numbers, so that the next one does not move when digits come and go; and for less of them where
/// there is less.
void TissueStrip::reserve() {
  const auto width = [&](const QString& words) { return fontMetrics().horizontalAdvance(words) + 2; };
  const QString area = QStringLiteral(" 888 %"), cm2 = QStringLiteral(" · 8.88 cm²");
  force_->setMinimumWidth(width("88.8 N"));
  indentation_->setMinimumWidth(width("88.8 mm"));
  const int vein_px = width(tr("vein") + area), artery_px = width(tr("artery") + area);
  const int least_px = force_->minimumWidth() + vein_px + artery_px + width(kShort) + 24 + 4 * kSmallSpace + 16;
  // The wide one must not keep its column wide.
  setMinimumWidth(least_px);
  const int usual_px = least_px + indentation_->minimumWidth() + width(tr("Tissue"));
  tight_ = QWidget::width() < usual_px;
  compact_ = QWidget::width() < usual_px + 2 * width(cm2) + 5 * kSpace;
  // The panel says how far the probe is in, too.
  indentation_->setVisible(!tight_);
  menu_->setText(tight_ ? kShort : tr("Tissue"));
  layout()->setSpacing(compact_ ? kSmallSpace : kSpace);
  vein_->setMinimumWidth(vein_px + (compact_ ? 0 : width(cm2)));
  artery_->setMinimumWidth(artery_px + (compact_ ? 0 : width(cm2)));
}

void TissueStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool before = compact_;
  reserve();
  if (compact_ != before) refresh();
}

void TissueStrip::follow() {
  if (!soon_.isActive()) soon_.start();
}

void TissueStrip::refresh() {
  setVisible(session_.patient() != nullptr);
  const LivePress* press = session_.shown() ? &session_.shown()->press : nullptr;
  if (press && !presses(*press)) press = nullptr;
  // A model that does not come to rest has no force to tell: what it gives then may be many times too much.
  const bool known = press && (press->settled || press->force_N <= kMostUnsettled_N);
  const QString newtons = known ? QString::number(press->force_N, 'f', 1) : tr("over %1").arg(kMostUnsettled_N);
  force_->setText(press ? tr("%1 N").arg(newtons) : QString());
  force_->setAccessibleName(press ? tr("Force %1 newtons").arg(newtons) : tr("No force"));
  const bool inside = press && press->indentation_mm > 0;
  indentation_->setText(inside ? tr("%1 mm").arg(press->indentation_mm, 0, 'f', 1) : QString());
  indentation_->setAccessibleName(inside ? tr("Indentation %1 millimetres").arg(press->indentation_mm, 0, 'f', 1)
                                         : tr("No indentation"));
  showVessel(*vein_, press, kVein, tr("vein"));
  showVessel(*artery_, press, kArtery, tr("artery"));
}

void TissueStrip::showVessel(QLabel& label, const LivePress* press, int vessel, const QString& name) const {
  const LumenArea* area = press ? lumenOf(*press, Label(vessel)) : nullptr;
  if (!area) {
    label.clear();
    label.setAccessibleName(tr("No area of the %1").arg(name));
    return;
  }
  const QString share = QString::number(100 * area->area_mm2 / area->rest_mm2, 'f', 0);
  const QString cm2 = QString::number(area->area_mm2 / 100, 'f', 2);
  label.setText(compact_ ? tr("%1 %2 %").arg(name, share) : tr("%1 %2 % · %3 cm²").arg(name, share, cm2));
  label.setAccessibleName(tr("Area of the %1: %2 percent, %3 square centimetres").arg(name, share, cm2));
}

}  // namespace insonate::train
