#include "CameraDialog.h"

#include "CameraControl.h"
#include "CameraSight.h"

#include <insonate/camera/HandsSheet.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr int kSightLook_ms = 66;
const QString kChooseFolder = QStringLiteral("choose:folder"), kChooseFile = QStringLiteral("choose:file");

}  // namespace

CameraDialog::CameraDialog(CameraControl& camera, QWidget* parent) : QDialog(parent), camera_(camera) {
  setObjectName("cameraDialog");
  setWindowTitle(tr("Camera"));
  setModal(false);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  box->setSpacing(ui::kGap);
  box->addWidget(buildChoice());
  sight_ = new CameraSight(this);
  sight_->setObjectName("cameraSight");
  box->addWidget(sight_, 1);
  for (std::size_t hand = 0; hand < 2; ++hand) {
    advice_[hand] = ui::paragraph(hand == 0 ? "probeAdvice" : "needleAdvice");
    box->addWidget(advice_[hand]);
  }
  state_ = ui::paragraph("cameraState", "quiet");
  box->addWidget(state_);
  task_ = ui::paragraph("cameraTask");
  box->addWidget(task_);
  box->addWidget(buildButtons());
  timer_.setInterval(kSightLook_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
  connect(&camera_, &CameraControl::changed, this, [this] { fillChoice(); });
}

QWidget* CameraDialog::buildChoice() {
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  auto* name = new QLabel(tr("camera"));
  ui::setRole(name, "quiet");
  source_ =
      ui::choiceBox("cameraSource", tr("Camera"),
                    tr("Camera that follows the printed bodies. Images stay on this computer and are not stored"));
  connect(source_, qOverload<int>(&QComboBox::activated), this, [this] { choose(); });
  box->addWidget(name);
  box->addWidget(source_, 1);
  return row;
}

QWidget* CameraDialog::buildButtons() {
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  auto* print =
      ui::pushButton("printBodies", tr("Print the bodies ..."),
                     tr("Saves a PDF with both bodies, the board for the lens, and the outline for the desk"));
  lens_ = ui::pushButton("calibrateLens", tr("Calibrate the lens"),
                         tr("Takes images of the printed board: hold it in view, and tilt it to all sides"));
  desk_ = ui::pushButton("setDesk", tr("Set the desk"),
                         tr("Hold the probe still on the printed outline: the outline is then the probe's present "
                            "place on the patient"));
  for (QPushButton* one : {print, lens_, desk_}) box->addWidget(one, 1);
  connect(print, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Save the sheet of bodies"), "hands.pdf", tr("PDF (*.pdf)"));
    if (!file.isEmpty()) this->print(file);
  });
  connect(lens_, &QPushButton::clicked, this, [this] {
    if (CameraHands* hands = camera_.hands())
      hands->state().task == CameraState::Task::kLens ? hands->cancelTask() : hands->calibrateLens();
  });
  connect(desk_, &QPushButton::clicked, this, [this] {
    if (CameraHands* hands = camera_.hands())
      hands->state().task == CameraState::Task::kDesk ? hands->cancelTask() : hands->registerDesk();
  });
  return row;
}

void CameraDialog::print(const QString& file) {
  const bool isMetric = QLocale().measurementSystem() == QLocale::MetricSystem;
  const auto pages = handsSheet(isMetric ? PaperSize::kA4 : PaperSize::kLetter);
  const auto done = pages ? writeHandsSheet(*pages, file.toStdString()) : Result<void>(tl::unexpected(pages.error()));
  printed_ = done ? tr("The sheet was saved. Print it at 100 % (actual size) on thick paper, check the ruler on each "
                       "page, cut, fold and glue the bodies.")
                  : ui::qt(done.error().message);
  look();
}

void CameraDialog::fillChoice() {
  const QSignalBlocker quiet(source_);
  source_->clear();
  source_->addItem(tr("off"), QString());
  for (const CameraControl::Choice& one : CameraControl::cameras()) source_->addItem(one.name, one.source);
  const QString source = camera_.source();
  if (source_->findData(source) < 0) source_->addItem(source.section(':', 1), source);
  source_->addItem(tr("Folder of recorded frames ..."), kChooseFolder);
  source_->addItem(tr("File of recorded frames ..."), kChooseFile);
  source_->setCurrentIndex(source_->findData(source));
}

void CameraDialog::choose() {
  QString source = source_->currentData().toString();
  if (source == kChooseFolder || source == kChooseFile) {
    const QString path = source == kChooseFolder
                             ? QFileDialog::getExistingDirectory(this, tr("Folder of recorded frames"))
                             : QFileDialog::getOpenFileName(this, tr("File of recorded frames"));
    source = path.isEmpty() ? camera_.source() : CameraControl::sourceOfFile(path);
  }
  camera_.use(source);
  fillChoice();
}

void CameraDialog::showEvent(QShowEvent* event) {
  fillChoice();
  timer_.start();
  look();
  QDialog::showEvent(event);
}

void CameraDialog::hideEvent(QHideEvent* event) {
  timer_.stop();
  if (CameraHands* hands = camera_.hands()) hands->cancelTask();
  QDialog::hideEvent(event);
}

void CameraDialog::look() {
  using Task = CameraState::Task;
  CameraHands* hands = camera_.hands();
  const CameraState now = hands ? hands->state() : CameraState{};
  CameraView view = hands ? hands->view() : CameraView{};
  const QString names[] = {tr("Probe"), tr("Needle")};
  for (std::size_t hand = 0; hand < 2; ++hand) {
    const QString advice = ui::qt(sentenceOf(view.bodies[hand].advice));
    advice_[hand]->setText(!hands ? QString()
                                  : tr("%1: %2").arg(names[hand], advice.isEmpty() ? tr("seen well") : advice));
  }
  sight_->show(std::move(view));
  lens_->setEnabled(hands), desk_->setEnabled(hands);
  lens_->setText(now.task == Task::kLens ? tr("Cancel") : tr("Calibrate the lens"));
  desk_->setText(now.task == Task::kDesk ? tr("Cancel") : tr("Set the desk"));
  if (!hands)
    state_->setText(
        tr("Print the bodies, fold them, and choose a camera. Any webcam will do; put it so that it sees "
           "both hands over the desk."));
  else if (!now.error.empty())
    state_->setText(ui::qt(now.error));
  else if (now.name.empty())
    state_->setText(tr("The camera is being opened."));
  else {
    const CameraCalibration calibration = hands->calibration();
    state_->setText(tr("%1 × %2 pixels, %3 frames per second, %4 ms per frame; lens %5, desk %6")
                        .arg(now.width)
                        .arg(now.height)
                        .arg(now.frames_Hz, 0, 'f', 0)
                        .arg(now.compute_ms, 0, 'f', 1)
                        .arg(calibration.lens ? tr("calibrated") : tr("not calibrated"),
                             calibration.cameraFromDesk ? tr("set") : tr("not set")));
  }
  if (now.task == Task::kLens)
    task_->setText(tr("Hold the printed board in view, and tilt it to all sides: %1 of %2 images.")
                       .arg(now.taken)
                       .arg(std::max(now.needed, now.taken)));
  else if (now.task == Task::kDesk)
    task_->setText(tr("Hold the probe still on the printed outline: %1 of %2 poses.").arg(now.taken).arg(now.needed));
  else
    task_->setText(now.outcome.empty() ? printed_ : ui::qt(now.outcome));
}

}  // namespace insonate::train
