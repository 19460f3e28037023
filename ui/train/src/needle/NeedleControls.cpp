#include "NeedleControls.h"

#include "../layout/NumberField.h"
#include "../model/Disclosure.h"
#include "../model/HapticControl.h"
#include "../model/NeedleMotion.h"
#include "../model/NeedleWords.h"
#include "../model/ProbeMotion.h"
#include "../model/StatusLine.h"
#include "NeedlePlaneButtons.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::train {
namespace {

struct NeedleRow {
  NeedleAxis axis;
  const char* object;  ///< after "needle_"
  const char* name;
  const char* unit;
  double low, high, step;
  const char* says;
  const char* command;  ///< command whose keys change the number
};
/// The longer names in one column: the panel is narrow.
constexpr NeedleRow kNeedleRows[] = {
    {NeedleAxis::Angle, "angle", "angle", "°", NeedlePlacement::kMinAngle_deg, NeedlePlacement::kMaxAngle_deg, 1,
     "Angle between needle and skin, in degrees; 90: perpendicular to the skin", "train.needle.angle"},
    {NeedleAxis::Heading, "heading", "heading", "°", -180, 180, 2,
     "Direction of the needle along the skin, in degrees; 0: to the patient's head, 90: to the left",
     "train.needle.heading"},
    {NeedleAxis::Bevel, "bevel", "bevel", "°", -180, 180, 10,
     "Rotation of the needle about its shaft, in degrees; 0: the bevel faces up", "train.needle.bevel"},
    {NeedleAxis::Advance, "depth", "advance", " mm", -NeedlePlacement::kMaxOff_mm, NeedlePlacement::kLength_mm, 1,
     "Length by which the hand has advanced the needle from the skin, in mm; negative: the needle is off the skin",
     "train.needle.advance"},
};

}  // namespace

NeedleControls::NeedleControls(StatusLine& status, DisclosureModel& disclosure, HapticControl& hands,
                               ProbeMotion& motion, NeedleMotion& needle, const ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      status_(status),
      disclosure_(disclosure),
      hands_(hands),
      motion_(motion),
      needle_(needle),
      devices_(new QPushButton(tr("Devices"))) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  auto* head = new QHBoxLayout;
  auto* heading = new QLabel(tr("Needle"), this);
  ui::setRole(heading, "heading");
  devices_->setObjectName("showDevices");
  devices_->setFocusPolicy(Qt::TabFocus);
  head->addWidget(heading, 1);
  head->addWidget(devices_);
  box->addLayout(head);
  box->addWidget(new NeedlePlaneButtons("needle", hands_, needle_, commands, this));
  numbers_ = buildNumbers(commands);
  box->addWidget(numbers_);
  words_ = new QLabel(this);
  words_->setObjectName("needleWords");
  words_->setWordWrap(true);
  box->addWidget(words_);
  connect(&hands_, &HapticControl::needleChanged, this, [this] { refresh(); });
  refresh();
}

void NeedleControls::setShowDevices(QAction& action) {
  devices_->setToolTip(action.toolTip());
  connect(devices_, &QPushButton::clicked, &action, &QAction::trigger);
}

QWidget* NeedleControls::buildNumbers(const ui::Commands& commands) {
  auto* all = new QWidget(this);
  auto* grid = new QGridLayout(all);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const NeedleRow& row = kNeedleRows[i];
    auto* field =
        new NumberField(QLatin1String(row.name), QString::fromUtf8(row.unit), {row.low, row.high, row.step}, all);
    field->setObjectName(QStringLiteral("needle_") + QLatin1String(row.object));
    field->setAccessibleName(tr("Needle, %1").arg(tr(row.name)));
    field->setToolTip(commands.toolTip(tr(row.says), row.command) +
                      tr("\nEnter applies the number; arrow keys and wheel change it in steps."));
    field->setTyped([this, axis = row.axis](double value) { needle_.set(axis, value); });
    field->setRefused([this](const QString& sentence) { status_.showMessage(sentence); });
    fields_[i] = field;
    auto* name = new QLabel(tr(row.name), all);
    ui::setRole(name, "quiet");
    const int column = int(i % 2) * 2, line = int(i / 2);
    grid->addWidget(name, line, column);
    grid->addWidget(field, line, column + 1);
  }
  return all;
}

void NeedleControls::refresh() {
  const HapticControl& hands = hands_;
  const NeedlePlacement* held = hands.needleHand();
  numbers_->setVisible(held);
  words_->setVisible(hands.needle().has_value());
  words_->setToolTip(disclosure_.current().anatomy
                         ? tr("Tissue at the tip; insertion length along the shaft from the skin, in mm; depth of the "
                              "tip on the image's scale, in mm; resistance in N")
                         : tr("Insertion length along the shaft from the skin, in mm; resistance in N"));
  if (hands.needle()) words_->setText(wordsNow(*hands.needle()));
  if (!held) return;
  const NeedlePlacementState& state = held->state();
  const double values[] = {state.angle_deg, held->heading_deg(), state.bevel_deg, hands.wantedAdvance_mm()};
  for (std::size_t i = 0; i < fields_.size(); ++i) fields_[i]->show(values[i]);
}

QString NeedleControls::wordsNow(const NeedleShown& needle) const {
  if (!disclosure_.current().anatomy) return plainWordsOf(needle.state);
  const Vec3 tip_mm = needle.patientFromNeedle.offset;
  return displayText(needle.state, vesselAt(hands_.session(), needle.state.in, tip_mm),
                     (inverted(motion_.pose()) * tip_mm).z);
}

}  // namespace insonate::train
