#include "TissueStrip.h"

#include "../feature/CommandWords.h"
#include "../model/CaseModel.h"
#include "../model/Disclosure.h"
#include "../model/LiveModel.h"
#include "VesselAreas.h"

#include <insonate/ui/Theme.h>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <utility>

namespace insonate::train {
namespace {

constexpr double kMaxUnsettled_N = 6;

constexpr int kReadable_ms = 150;
constexpr int kSpace = 12, kSmallSpace = 4;
const QString kShort = QStringLiteral("...");

/// In the order of TissueStrip::Show.
constexpr const char* kOverlays[] = {"train.tissue.grid", "train.tissue.pressure", "train.tissue.areas"};

QLabel* numberLabel(const char* object, const QString& says, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(object));
  label->setToolTip(says);
  return label;
}

}  // namespace

TissueStrip::TissueStrip(DisclosureModel& disclosure, CaseModel& patientCase, LiveModel& live, ui::Commands& commands,
                         QWidget* parent)
    : QWidget(parent),
      disclosure_(disclosure),
      patientCase_(patientCase),
      live_(live),
      force_(numberLabel("pressForce", tr("Force of the tissue on the probe, in N"), this)),
      vein_(numberLabel(
          "veinArea",
          tr("Current area of all veins in the image plane, in mm² and in % of their uncompressed area in the CT"),
          this)),
      artery_(numberLabel(
          "arteryArea", tr("Current area of all arteries in the image plane, in mm² and in % of their area in the CT"),
          this)),
      menu_(new QPushButton(tr("Tissue"), this)) {
  setObjectName("tissueStrip");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 0);
  row->setSpacing(kSpace);
  for (QLabel* label : {force_, vein_, artery_}) row->addWidget(label);
  row->addStretch(1);
  row->addWidget(menu_);
  buildMenu(commands);
  for (const auto& [label, vessel] : {std::pair{vein_, kVein}, {artery_, kArtery}})
    label->setStyleSheet(QStringLiteral("color: %1").arg(vesselColor(vessel).name()));
  soon_.setSingleShot(true);
  soon_.setInterval(kReadable_ms);
  connect(&soon_, &QTimer::timeout, this, [this] { refresh(); });
  connect(&live_, &LiveModel::pictureShown, this, [this] { follow(); });
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] { refresh(); });
  connect(&disclosure_, &DisclosureModel::changed, this, [this] { refresh(); });
  reserve();
  refresh();
}

void TissueStrip::buildMenu(ui::Commands& commands) {
  menu_->setObjectName("tissueMenu");
  menu_->setAccessibleName(tr("Tissue overlays"));
  menu_->setToolTip(
      tr("Show the grid in the tissue (%1), the pressure in the tissue (%2), vessel areas against force (%3)")
          .arg(keysOf(commands, kOverlays[kGrid]), keysOf(commands, kOverlays[kPressure]),
               keysOf(commands, kOverlays[kPlot])));
  menu_->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(menu_);
  menu->setToolTipsVisible(true);
  for (int what = 0; what < kShows; ++what) {
    QAction* action = actions_[what] = commands.action(kOverlays[what]);
    action->setCheckable(true);
    menu->addAction(action);
    // Qt changes the mark before the command is performed.
    connect(action, &QAction::triggered, this, [this, what] { actions_[what]->setChecked(isShown_[what]); });
  }
  menu_->setMenu(menu);
}

void TissueStrip::setShown(Show what, bool on) {
  actions_[what]->setChecked(on);
  if (std::exchange(isShown_[what], on) != on) Q_EMIT shownChanged();
}

/// Room for the widest numbers, so that the next one does not move when digits come and go; and for less of them where
/// there is less.
void TissueStrip::reserve() {
  const auto width = [&](const QString& words) { return fontMetrics().horizontalAdvance(words) + 2; };
  force_->setMinimumWidth(width("88.8 N"));
  const auto widest = [&](const QString& name, ui::AreaForm form) {
    return width(name + ' ' + ui::areaOf({0, 888, 100}, form));
  };
  const auto both = [&](ui::AreaForm form) { return widest(tr("veins"), form) + widest(tr("arteries"), form); };
  const int usual_px = width(tr("Tissue")) - width(kShort);
  const auto needs_px = [&](ui::AreaForm form, bool tight) {
    const int space_px = form == ui::AreaForm::Share ? kSmallSpace : kSpace;
    return force_->minimumWidth() + both(form) + width(kShort) + 24 + 3 * space_px + 16 + (tight ? 0 : usual_px);
  };
  // The wide one must not keep its column wide.
  setMinimumWidth(needs_px(ui::AreaForm::Share, true));
  form_ = ui::AreaForm::Share, tight_ = true;
  for (const auto& [form, tight] :
       {std::pair{ui::AreaForm::Short, true}, {ui::AreaForm::Short, false}, {ui::AreaForm::Full, false}})
    if (QWidget::width() >= needs_px(form, tight)) form_ = form, tight_ = tight;
  menu_->setText(tight_ ? kShort : tr("Tissue"));
  layout()->setSpacing(form_ == ui::AreaForm::Share ? kSmallSpace : kSpace);
  vein_->setMinimumWidth(widest(tr("veins"), form_));
  artery_->setMinimumWidth(widest(tr("arteries"), form_));
}

void TissueStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const ui::AreaForm before = form_;
  reserve();
  if (form_ != before) refresh();
}

void TissueStrip::follow() {
  if (!soon_.isActive()) soon_.start();
}

void TissueStrip::refresh() {
  setVisible(patientCase_.patient() != nullptr);
  for (QWidget* one : {static_cast<QWidget*>(vein_), static_cast<QWidget*>(artery_), static_cast<QWidget*>(menu_)})
    one->setVisible(disclosure_.current().anatomy);
  const LiveDeformation* press = live_.shown() ? &live_.shown()->press : nullptr;
  if (press && !presses(*press)) press = nullptr;
  // A model that does not come to rest has no force to tell: what it gives then may be many times too much.
  const bool known = press && (press->settled || press->force_N <= kMaxUnsettled_N);
  const QString newtons = known ? QString::number(press->force_N, 'f', 1) : tr("more than %1").arg(kMaxUnsettled_N);
  force_->setText(press ? tr("%1 N").arg(newtons) : QString());
  force_->setAccessibleName(press ? tr("Force %1 newtons").arg(newtons) : tr("No force"));
  showVessel(*vein_, press, kVein, tr("veins"));
  showVessel(*artery_, press, kArtery, tr("arteries"));
}

void TissueStrip::showVessel(QLabel& label, const LiveDeformation* press, int vessel, const QString& name) const {
  const LumenArea* area = press ? lumenOf(*press, Label(vessel)) : nullptr;
  if (!area) {
    label.clear();
    label.setAccessibleName(tr("Area of the %1: no data").arg(name));
    return;
  }
  label.setText(tr("%1 %2").arg(name, ui::areaOf(*area, form_)));
  label.setAccessibleName(tr("Area of the %1: %2").arg(name, ui::spokenAreaOf(*area)));
}

}  // namespace insonate::train
