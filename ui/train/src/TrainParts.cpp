#include "TrainParts.h"

#include "hand/KeyTable.h"
#include "image/CineBar.h"
#include "image/ImageInput.h"
#include "panel/ControlsPanel.h"
#include "panel/Positions.h"
#include "scene/PatientViews.h"

#include <insonate/simulator/PictureFiles.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <span>

namespace insonate::train {
namespace {

constexpr int kRate_ms = 250;  // often enough to be true, seldom enough to be read

}  // namespace

TrainWorkspace::Parts::Parts(TrainWorkspace& workspace)
    : session(*new TrainSession(&workspace)), workspace_(workspace) {
  columns = new QSplitter(Qt::Horizontal, &workspace);
  columns->setObjectName("trainColumns");
  columns->setChildrenCollapsible(false);
  panel = new ControlsPanel(session, columns);
  columns->addWidget(panel);
  columns->addWidget(buildCentre());
  patient = new PatientViews(session, columns);
  columns->addWidget(patient);
  columns->setStretchFactor(0, 0);
  columns->setStretchFactor(1, 3);
  columns->setStretchFactor(2, 1);
  columns->setSizes({250, 900, 420});
  auto* box = new QVBoxLayout(&workspace);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(columns);
  ui::markViewRoom(columns);
  input_ = new ImageInput(session, *image_, *imageWidget_->focusProxy(), this);
  connectParts();
}

TrainWorkspace::Parts::~Parts() {
  clip_ = nullptr;
  session.stop();
}

QWidget* TrainWorkspace::Parts::buildCentre() {
  auto* centre = new QWidget;
  image_ = std::make_shared<views::UltrasoundView>();
  imageWidget_ = new ui::ViewWidget(image_, tr("Ultrasound picture"), centre);
  imageWidget_->setObjectName("ultrasoundView");
  imageWidget_->setMaximiseOnDoubleClick(false);
  empty_ = new QLabel(centre);
  empty_->setObjectName("emptyState");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  cine_ = new CineBar(session, centre);
  auto* box = new QVBoxLayout(centre);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  box->addWidget(empty_, 1);
  box->addWidget(imageWidget_, 1);
  box->addWidget(cine_);
  return centre;
}

void TrainWorkspace::Parts::connectParts() {
  for (ui::ViewWidget* view : {imageWidget_, &patient->sceneWidget(), &patient->mprWidget()})
    view->focusProxy()->installEventFilter(&workspace_);
  connect(&session, &TrainSession::caseChanged, this, [this] { showCase(); });
  connect(&session, &TrainSession::pictureShown, this, [this] { showPicture(); });
  connect(&session, &TrainSession::messageChanged, this, [this] { Q_EMIT workspace_.statusChanged(); });
  connect(&session, &TrainSession::failed, this, [this](const QString& what) {
    Q_EMIT workspace_.failed(what, tr("Check the case in Prepare, or open another one."), {});
  });
  connect(&session, &TrainSession::frozenChanged, this, [this] {
    image_->setFrozen(session.isFrozen());
    if (!session.isFrozen()) {
      // What was measured lay on another picture.
      input_->callipers().clear();
      showCallipers();
    }
  });
  input_->setMeasured([this] { showCallipers(); });
  connect(cine_, &CineBar::calliperChosen, this, [this](int kind) { chooseCalliper(kind); });
  connect(cine_, &CineBar::clearCallipers, this, [this] {
    input_->callipers().clear();
    showCallipers();
  });
  connect(cine_, &CineBar::savePicture, this, [this] { askPicture(); });
  connect(cine_, &CineBar::saveClip, this, [this] { askClip(); });
  connect(&rate_, &QTimer::timeout, this, [this] { showRate(); });
  showCase();
}

void TrainWorkspace::Parts::showCase() {
  shape_ = nullptr;
  image_->setImage({});
  image_->setFrozen(false);
  input_->callipers().clear();
  showCallipers();
  empty_->setVisible(!session.patient());
  imageWidget_->setVisible(session.patient() != nullptr);
  empty_->setText(tr("No case is open.\n\nOpen one from the library, or make one in Prepare."));
  if (session.patient())
    rate_.start(kRate_ms);
  else
    rate_.stop();
  engineText.clear();
  if (std::exchange(ready, false)) Q_EMIT workspace_.readyChanged();
  Q_EMIT workspace_.statusChanged();
}

void TrainWorkspace::Parts::showPicture() {
  const LiveFrame& frame = *session.shown();
  image_->setImage(frame.image);
  if (frame.setup != shape_) {
    shape_ = frame.setup;
    const BeamGrid grid(shape_->probe, shape_->settings);
    image_->setBounds(
        views::PictureBounds{grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()});
    image_->setFocus(shape_->settings.focus_mm);
    const auto& tgc_dB = shape_->settings.tgc_dB;
    const bool flat = std::ranges::all_of(tgc_dB, [](double dB) { return dB == 0; });
    image_->setTgc(flat ? std::span<const double>() : std::span<const double>(tgc_dB));
  }
  if (ready) return;
  ready = true;
  Q_EMIT workspace_.readyChanged();
}

void TrainWorkspace::Parts::showRate() {
  QString text = tr("cpu engine");
  const LiveStatus status = session.status();
  if (session.isFrozen())
    text += tr("   frozen");
  else if (status.state == LiveState::Starting || status.state == LiveState::WaitingForScene)
    text += tr("   building the scene");
  else if (status.state == LiveState::Outside)
    text += tr("   outside the patient");
  else if (session.shown())
    text += tr("   %1 images/s   %2 ms")
                .arg(session.imagesPerSecond(), 3, 'f', 0)
                .arg(session.shown()->frame_ms, 4, 'f', 1);
  if (text == engineText) return;
  engineText = text;
  Q_EMIT workspace_.statusChanged();
}

void TrainWorkspace::Parts::showCallipers() {
  image_->setCallipers(input_->callipers().callipers());
}

void TrainWorkspace::Parts::chooseCalliper(int kind) {
  const auto chosen = input_->callipers().kind();
  const bool off = kind < 0 || (chosen && int(*chosen) == kind);
  input_->callipers().setKind(off ? std::nullopt : std::optional(views::CalliperKind(kind)));
  cine_->setCalliper(off ? -1 : kind);
  imageWidget_->focusProxy()->setCursor(off ? Qt::ArrowCursor : Qt::CrossCursor);
  showCallipers();
  session.say(off ? tr("Drag on the image to slide the probe. Keys: ?")
                  : tr("Click on the image from point to point, or drag."));
}

bool TrainWorkspace::Parts::key(const QKeyEvent& event, bool doIt) {
  const KeyRow* row = rowFor(event);
  if (!row || !session.patient()) return false;
  if (doIt) act(*row, event.modifiers() & Qt::ShiftModifier, event.isAutoRepeat());
  return true;
}

void TrainWorkspace::Parts::act(const KeyRow& row, bool wide, bool repeated) {
  switch (row.command) {
    case Command::Move:
      if (!repeated) session.beginGesture();
      return session.move(row.axis, wide ? row.wide : row.step);
    case Command::Freeze:
      if (!repeated) session.setFrozen(!session.isFrozen());
      return;
    case Command::Home:
      return session.home();
    case Command::Recall:
      return panel->positions().recall(row.place);
    case Command::Undo:
      return session.undo();
    case Command::Redo:
      return session.redo();
    case Command::EarlierPicture:
      return session.showCine(session.cineIndex() - 1);
    case Command::LaterPicture:
      return session.showCine(session.cineIndex() + 1);
    case Command::SavePicture:
      return askPicture();
    case Command::MeasureDistance:
      return chooseCalliper(int(views::CalliperKind::Distance));
    case Command::MeasureEllipse:
      return chooseCalliper(int(views::CalliperKind::Ellipse));
    case Command::MeasureAngle:
      return chooseCalliper(int(views::CalliperKind::Angle));
    case Command::ClearMeasures:
      input_->callipers().clear();
      return showCallipers();
  }
}

void TrainWorkspace::Parts::takeKeyboard(QObject* canvas) {
  // Who types a number keeps the keyboard.
  QWidget* holder = QApplication::focusWidget();
  const bool typing = qobject_cast<QLineEdit*>(holder) || qobject_cast<QAbstractSpinBox*>(holder);
  if (canvas == imageWidget_->focusProxy() && workspace_.isActiveWindow() && !typing)
    imageWidget_->setFocus(Qt::MouseFocusReason);
}

bool TrainWorkspace::Parts::canvasEvent(QObject* canvas, QEvent* event) {
  switch (event->type()) {
    case QEvent::Enter:
      takeKeyboard(canvas);
      return false;
    case QEvent::ShortcutOverride:
      if (!key(*static_cast<QKeyEvent*>(event), false)) return false;
      event->accept();
      return true;
    case QEvent::KeyPress:
      return key(*static_cast<QKeyEvent*>(event), true);
    default:
      return false;
  }
}

bool TrainWorkspace::Parts::savePicture(const std::filesystem::path& file) {
  if (!session.shown()) {
    session.say(tr("There is no picture yet."));
    return false;
  }
  const auto written = writePng(session.shown()->image, file);
  session.say(written ? tr("Picture saved as %1.").arg(QString::fromStdString(file.filename().string()))
                      : QString::fromStdString(written.error().message));
  return written.has_value();
}

void TrainWorkspace::Parts::saveClip(const std::filesystem::path& folder) {
  session.setFrozen(true);
  if (session.cine().empty()) return session.say(tr("There is no picture yet."));
  clip_ = std::make_unique<ClipWriter>(
      session.cine(), folder, [this](double share) { session.say(tr("Saving the clip, %1 %.").arg(int(share * 100))); },
      [this](const Result<int>& result) {
        session.say(result ? tr("%1 pictures saved.").arg(*result) : QString::fromStdString(result.error().message));
      });
}

void TrainWorkspace::Parts::askPicture() {
  if (!session.shown()) return session.say(tr("There is no picture yet."));
  session.setFrozen(true);  // The picture that the user saw, whatever the dialog takes.
  const QString name = exportName(QString::fromStdString(session.patient()->manifest.title)) + ".png";
  const QString file = QFileDialog::getSaveFileName(&workspace_, tr("Save the picture"),
                                                    QDir(lastFolder_).filePath(name), tr("PNG picture (*.png)"));
  if (file.isEmpty()) return;
  lastFolder_ = QFileInfo(file).path();
  savePicture(file.toStdString());
}

void TrainWorkspace::Parts::askClip() {
  session.setFrozen(true);
  const QString folder = QFileDialog::getExistingDirectory(&workspace_, tr("Save the clip into"), lastFolder_);
  if (folder.isEmpty() || !session.patient()) return;
  lastFolder_ = folder;
  const QString name = exportName(QString::fromStdString(session.patient()->manifest.title));
  saveClip(QDir(folder).filePath(name).toStdString());
}

}  // namespace insonate::train
