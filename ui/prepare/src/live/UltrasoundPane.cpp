#include "UltrasoundPane.h"

#include "../model/Crosshair.h"
#include "../model/LivePatient.h"
#include "../model/OpenCase.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"
#include "../model/Structures.h"

#include <insonate/ui/AreaWords.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr int kMinHeight_px = 150;

}  // namespace

UltrasoundPane::UltrasoundPane(PrepareModel& shared, const ui::Commands& commands)
    : shared_(shared),
      view_(std::make_shared<views::UltrasoundView>()),
      widget_(new ui::ViewWidget(view_, tr("Ultrasound of this label map"), this)),
      press_(new ui::ValueSlider(tr("indentation"), tr("mm"), {0, 15, 0, 0.5, 1},
                                 tr("depth by which the probe indents the tissue"))),
      state_(new QLabel),
      pressed_(new QLabel),
      start_(new QPushButton(tr("Start"))),
      keep_(new QPushButton(tr("Set start pose"))) {
  // Not maximized by double click: in the narrow column a larger image would show no more.
  widget_->setMaximizeOnDoubleClick(false);
  widget_->setObjectName(QStringLiteral("labelUltrasound"));
  widget_->setMinimumHeight(kMinHeight_px);
  view_->setGrayBarVisible(false);
  auto* title = new QLabel(tr("Ultrasound"));
  ui::setRole(title, "heading");
  title->setToolTip(tr("Ultrasound image of these labels; the probe is on the skin nearest to the crosshair"));
  start_->setObjectName(QStringLiteral("toStart"));
  start_->setToolTip(commands.toolTip(QStringLiteral("prepare.live.start")));
  ui::setRole(state_, "quiet");
  state_->setObjectName(QStringLiteral("ultrasoundState"));
  state_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(title, 1);
  keep_->setObjectName(QStringLiteral("keepStart"));
  keep_->setToolTip(tr("Makes the present pose of the probe the start pose of the case; saved with the case"));
  row->addWidget(keep_);
  row->addWidget(start_);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addLayout(row);
  box->addWidget(widget_, 1);
  box->addWidget(press_);
  box->addWidget(pressed_);
  box->addWidget(state_);
  press_->setObjectName(QStringLiteral("press"));
  pressed_->setObjectName(QStringLiteral("pressed"));
  ui::setRole(pressed_, "quiet");
  pressed_->setWordWrap(true);
  connect(press_, &ui::ValueSlider::valueChanged, this, [this](double mm) { shared_.live.setPress(mm); });
  connect(start_, &QPushButton::clicked, this, [this] { shared_.crosshair.goToStart(); });
  connect(keep_, &QPushButton::clicked, this, [this] { shared_.places.keepStart(); });
  connect(&shared_.places, &PlacesEditor::changed, this, [this] { showState(); });
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] {
    shape_ = nullptr;
    press_->reset();
    pressed_->clear();
    view_->setImage({});
    showState();
  });
  connect(&shared_.live, &LivePatient::pictureShown, this, [this] { showPicture(); });
  connect(&shared_.live, &LivePatient::stateChanged, this, [this] { showState(); });
  connect(&shared_.live, &LivePatient::poseChanged, this, [this] { showState(); });
  constexpr int kTick_ms = 1000;
  tick_.setInterval(kTick_ms);
  connect(&tick_, &QTimer::timeout, this, [this] { showNotice(); });
  showState();
}

void UltrasoundPane::showPicture() {
  const LiveFrame& frame = *shared_.live.shown();
  view_->setImage(frame.image);
  view_->setLateral(frame.patientFromProbe.linear.column[0]);
  showPress();
  if (frame.setup == shape_) return;
  shape_ = frame.setup;
  const BeamGrid grid(frame.setup->probe, frame.setup->settings);
  view_->setBounds(
      views::ImageBounds{grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()});
  view_->setFocus(frame.setup->settings.focus_mm);
}

void UltrasoundPane::showPress() {
  const LiveDeformation& press = shared_.live.shown()->press;
  QStringList words;
  if (shared_.live.press_mm() > 0) words << tr("%1 N").arg(press.force_N, 0, 'f', 1);
  for (const LumenArea& lumen : press.lumens)
    if (lumen.rest_mm2 > 0 && shared_.live.press_mm() > 0)
      words << tr("%1 %2").arg(structureName(lumen.label), ui::areaOf(lumen, ui::AreaForm::Short));
  pressed_->setText(words.isEmpty() ? tr("Compress the tissue to see whether the vein collapses.")
                                    : words.join(QStringLiteral("   ")));
}

void UltrasoundPane::showState() {
  const QString state = shared_.live.state();
  state_->setText(state);
  const QString stale = shared_.live.isOfFormerPlace()    ? tr("Image of the previous position")
                        : shared_.live.isOfFormerTissue() ? tr("Image of the previous labels")
                                                          : QString();
  view_->setStaleMark(stale.toStdString());
  // One line is always reserved, so that the image does not move.
  keep_->setVisible(shared_.places.lacksStart());
  start_->setEnabled(shared_.live.start().has_value());
  showNotice();
}

void UltrasoundPane::showNotice() {
  const bool waits = shared_.live.isBuilding() && !shared_.live.shown();
  if (waits && !tick_.isActive()) since_.start(), tick_.start();
  if (!waits) tick_.stop(), since_.invalidate();
  QString notice = shared_.live.shown() ? QString() : shared_.live.state();
  constexpr qint64 kSecond_ms = 1000;
  const qint64 waited_s = since_.isValid() ? since_.elapsed() / kSecond_ms : 0;
  if (waited_s > 1) notice += tr(" %1 s").arg(waited_s);
  // Each notice draws the view anew.
  if (std::string words = notice.toStdString(); words != view_->notice()) view_->setNotice(words);
}

}  // namespace insonate::prepare
