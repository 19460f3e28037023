#include "TrainParts.h"

#include "attempt/AttemptControl.h"
#include "attempt/AttemptStrip.h"
#include "feature/KeyTable.h"
#include "image/CineBar.h"
#include "image/CtBeside.h"
#include "image/EffectWords.h"
#include "image/EqualPanes.h"
#include "image/ImageInput.h"
#include "image/LinkedPointer.h"
#include "image/SliceMeasure.h"
#include "image/export/ImageExports.h"
#include "measure/LiveMeasure.h"
#include "measure/SceneMeasure.h"
#include "needle/NeedleControls.h"
#include "panel/ControlsPanel.h"
#include "patient3d/FourSlices.h"
#include "patient3d/PatientViews.h"
#include "probe/FovHandles.h"
#include "probe/HeldPress.h"
#include "probe/Positions.h"
#include "probe/ProbeLibrary.h"
#include "tissue/TissueShown.h"
#include "tissue/TissueStrip.h"

#include <insonate/ui/KeyOffer.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSplitter>
#include <QStackedLayout>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <span>
#include <utility>

namespace insonate::train {
namespace {

constexpr double kAtRest = 2;  // images/s
constexpr int kRate_ms = 250;  // often enough to be true, seldom enough to be read

}  // namespace

TrainWorkspace::Parts::Parts(TrainWorkspace& workspace) : model(*new TrainModel(&workspace)), workspace_(workspace) {
  columns = new QSplitter(Qt::Horizontal, &workspace);
  columns->setObjectName("trainColumns");
  columns->setChildrenCollapsible(false);
  library_ = new ProbeLibrary({}, this);
  attempt = new AttemptControl(model, {}, &workspace);
  buildCourse();
  columns->addWidget(buildLeft());
  columns->addWidget(buildCentre());
  patient = new PatientViews(model, columns);
  columns->addWidget(patient);
  columns->setStretchFactor(0, 0);
  columns->setStretchFactor(1, 3);
  columns->setStretchFactor(2, 1);
  columns->setSizes({250, 900, 420});
  auto* box = new QVBoxLayout(&workspace);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(columns);
  ui::markViewRoom(columns);
  QWidget &picture = *imageWidget_->focusProxy(), &slice = *patient->mprWidget().focusProxy();
  QWidget& beside = *beside_->widget().focusProxy();
  // Filters see events in the reverse of this order.
  FourSlices& four = patient->allSlices();
  measureSlices_ = {new SliceMeasure(patient->mpr(), slice, this), new SliceMeasure(beside_->view(), beside, this)};
  for (std::size_t n = 0; n < FourSlices::kCount; ++n)
    measureSlices_.push_back(new SliceMeasure(four.slice(n), *four.widget(n).focusProxy(), this));
  input_ = new ImageInput(model.imaging, model.motion, model.needle, *image_, picture, this);
  pointer_ = new LinkedPointer(model.patientCase, model.live, *image_, picture, this);
  pointer_->addSlice(patient->mpr(), slice);
  pointer_->addSlice(beside_->view(), beside);
  for (std::size_t n = 0; n < FourSlices::kCount; ++n) {
    pointer_->addSlice(four.slice(n), *four.widget(n).focusProxy());
    four.widget(n).focusProxy()->installEventFilter(&workspace);
  }
  exports =
      new ImageExports({model.patientCase, model.live, model.status, *cine_, *input_, *pictures_}, workspace, this);
  held_ = new HeldPress(model.motion, this);
  buildActions();
  connectParts();
  connectProbe();
  connectAttempt();
}

TrainWorkspace::Parts::~Parts() {
  delete attempt;  // before the model, which it acts on
  measure_ = nullptr;
  volumeMeasure_ = nullptr;
  model.patientCase.stop();
}

void TrainWorkspace::Parts::releaseCanvases() {
  delete std::exchange(pointer_, nullptr);
  for (SliceMeasure* slice : std::exchange(measureSlices_, {})) delete slice;
  delete std::exchange(input_, nullptr);
  delete std::exchange(fov_, nullptr);
}

QWidget* TrainWorkspace::Parts::buildCentre() {
  auto* centre = new QWidget;
  image_ = std::make_shared<views::UltrasoundView>();
  imageWidget_ = new ui::ViewWidget(image_, tr("Ultrasound image"), centre);
  imageWidget_->setObjectName("ultrasoundView");
  imageWidget_->setMaximiseOnDoubleClick(false);
  empty_ = new QLabel(centre);
  empty_->setObjectName("emptyState");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  cine_ = new CineBar(model.patientCase, model.live, centre);
  auto* box = new QVBoxLayout(centre);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  box->addWidget(empty_, 1);
  beside_ = new CtBeside(model.patientCase, model.live, centre);
  pictures_ = new EqualPanes(centre);
  pictures_->add(imageWidget_);
  pictures_->add(&beside_->widget());
  box->addWidget(pictures_, 1);
  offer_ = buildOffer();
  box->addWidget(offer_, 1);
  box->addWidget(vesselNote_);
  tissue = new TissueShown(model.status, model.disclosure, model.patientCase, model.live, *image_, centre);
  box->addWidget(&tissue->curve());
  box->addWidget(new AttemptStrip(model.disclosure, model.hands, model.patientCase, *attempt, centre));
  box->addWidget(&tissue->strip());
  box->addWidget(cine_);
  return centre;
}

void TrainWorkspace::Parts::buildActions() {
  const auto make = [this](const QString& text, const QString& tip) {
    auto* action = new QAction(text, this);
    action->setCheckable(true);
    action->setToolTip(tip);
    workspace_.addAction(action);
    return action;
  };
  // The key is in the table; it is only told here.
  besideAction_ = make(tr("CT beside the image\tC"), tr("The same plane of the CT at the same scale"));
  leftHanded_ = make(tr("Left-handed layout"), tr("Controls on the right, patient on the left"));
  QAction* panelAction = make(tr("Devices ..."), tr("Haptic devices and pedals: what is there, and what it holds"));
  panelAction->setCheckable(false);
  courseAction_ = make(tr("Levels and attempts\tJ"), tr("Levels, your progress and your attempts"));
  connect(courseAction_, &QAction::triggered, this, [this](bool on) { showCourse(on); });
  connect(panelAction, &QAction::triggered, this, [this] { showDevices(); });
  connect(besideAction_, &QAction::toggled, this, [this](bool on) { setCtBeside(on); });
  connect(leftHanded_, &QAction::toggled, this, [this](bool on) { setLeftHanded(on); });
}

void TrainWorkspace::Parts::reportProblem() {
  if (trouble_.isEmpty() || !workspace_.isVisible()) return;
  Q_EMIT workspace_.failed(std::exchange(trouble_, {}), tr("Check the case in Prepare, or open another one."), {});
}

void TrainWorkspace::Parts::connectParts() {
  for (ui::ViewWidget* view : {imageWidget_, &beside_->widget(), &patient->sceneWidget(), &patient->mprWidget()})
    view->focusProxy()->installEventFilter(&workspace_);
  connect(&model.patientCase, &CaseModel::caseChanged, this, [this] {
    trouble_.clear();
    showCase();
  });
  connect(&model.live, &LiveModel::pictureShown, this, [this] { showPicture(); });
  connect(&model.patientCase, &CaseModel::structuresKnown, this, [this] { showVesselNote(); });
  connect(&model.motion, &ProbeMotion::placingChanged, this, [this] { showOffer(); });
  connect(&model.patientCase, &CaseModel::surfacesDone, this, [this] { Q_EMIT workspace_.readyChanged(); });
  connect(&model.status, &StatusLine::messageChanged, this, [this] { Q_EMIT workspace_.statusChanged(); });
  connect(&model.patientCase, &CaseModel::failed, this, [this](const QString& what) {
    trouble_ = what;
    reportProblem();
  });
  connect(&model.live, &LiveModel::frozenChanged, this, [this] {
    image_->setFrozen(model.live.isFrozen());
    if (!model.live.isFrozen()) {
      // Measurements lay on another image.
      input_->callipers().clear();
      showCallipers();
    }
  });
  input_->setMeasured([this] { showCallipers(); });
  patient->setWindowChanged([this](views::WindowLevel window) { beside_->view().setWindowLevel(window); });
  patient->setRoomWanted([this](bool more) { expandPatientColumn(more); });
  connect(&panel->needle(), &NeedleControls::devicesWanted, this, [this] { showDevices(); });
  connect(cine_, &CineBar::calliperChosen, this, [this](int kind) { chooseCalliper(kind); });
  connect(cine_, &CineBar::clearCallipers, this, [this] { clearCallipers(); });
  connect(cine_, &CineBar::ctBesideChosen, this, [this](bool on) { setCtBeside(on); });
  connect(&model.imaging, &ImagingModel::setupChanged, this, [this] { showNotice(); });
  connect(&rate_, &QTimer::timeout, this, [this] { showRate(); });
  showCase();
}

void TrainWorkspace::Parts::showCase() {
  shape_ = nullptr;
  image_->setImage({});
  image_->setFrozen(false);
  for (ui::ViewWidget* view : {imageWidget_, &beside_->widget()}) view->forget();
  input_->callipers().clear();
  for (SliceMeasure* slice : measureSlices_) slice->setCallipers({});
  showCallipers();
  empty_->setVisible(!model.patientCase.patient());
  showOffer();
  showVesselNote();
  showOpening({});
  showNotice();
  if (model.patientCase.patient())
    rate_.start(kRate_ms);
  else
    rate_.stop();
  engineText.clear();
  if (std::exchange(ready, false)) Q_EMIT workspace_.readyChanged();
  Q_EMIT workspace_.statusChanged();
}

void TrainWorkspace::Parts::showPicture() {
  const LiveFrame& frame = *model.live.shown();
  image_->setImage(frame.image);
  if (frame.setup != shape_ && !(fov_ && fov_->isHeld())) {
    shape_ = frame.setup;
    const BeamGrid grid(shape_->probe, shape_->settings);
    const views::PictureBounds fieldOfView{grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(),
                                           grid.maxAxial_mm()};
    image_->setBounds(fov_ ? fov_->roomFor(fieldOfView) : fieldOfView);
    image_->setFocus(shape_->settings.focus_mm);
    const auto& tgc_dB = shape_->settings.tgc_dB;
    const bool flat = std::ranges::all_of(tgc_dB, [](double dB) { return dB == 0; });
    image_->setTgc(flat ? std::span<const double>() : std::span<const double>(tgc_dB));
  }
  if (ready) return;
  ready = true;
  showNotice();
  Q_EMIT workspace_.readyChanged();
}

void TrainWorkspace::Parts::showRate() {
  const bool onCard = model.live.shown() && model.live.shown()->engine == "glsl";
  QString text = onCard ? tr("graphics card") : tr("processor");
  const LiveStatus status = model.live.status();
  if (model.motion.isUnplaced())
    text.clear();
  else if (model.live.isFrozen())
    text += tr("   frozen");
  else if (status.state == LiveState::Starting || status.state == LiveState::WaitingForScene)
    text += tr("   building the scene");
  else if (status.state == LiveState::Outside)
    text += tr("   outside the patient");
  else if (model.live.shown() && model.live.imagesPerSecond() < kAtRest)
    // A probe at rest needs no images; that is no slow engine.
    text += tr("   image is up to date   %1 ms").arg(model.live.shown()->frame_ms, 4, 'f', 1);
  else if (model.live.shown())
    text += tr("   %1 fps   %2 ms")
                .arg(model.live.imagesPerSecond(), 3, 'f', 0)
                .arg(model.live.shown()->frame_ms, 4, 'f', 1);
  if (text == engineText) return;
  engineText = text;
  Q_EMIT workspace_.statusChanged();
}

void TrainWorkspace::Parts::showNotice() {
  const std::string& effect = model.imaging.effect();
  const bool alone = effect != ImagingModel::kWholeModel;
  QString words = alone ? tr("ONLY %1").arg(effectWords(effect)) : QString();
  if (!model.live.shown()) words = tr("Building the first image ...");
  image_->setNotice(words.toStdString());
  if (std::exchange(effectAlone_, alone) == alone && !alone) return;
  model.status.say(alone ? tr("The image shows one effect only; 0 shows the whole image.")
                         : tr("The whole image is shown."));
}

bool TrainWorkspace::Parts::key(const QKeyEvent& event, bool doIt) {
  const KeyRow* row = rowFor(event);
  // A probe can be edited without a patient.
  const bool always =
      row && (row->command == Command::Undo || row->command == Command::Redo || row->command == Command::ShowCourse);
  if (row && isCourseShown() && row->command != Command::ShowCourse) return false;
  if (!row || (!model.patientCase.patient() && !always)) return false;
  if (row->command == Command::StopMeasuring && !input_->callipers().kind()) return false;
  if (doIt) act(*row, event.modifiers() & Qt::ShiftModifier, event.isAutoRepeat());
  return true;
}

void TrainWorkspace::Parts::act(const KeyRow& row, bool wide, bool repeated) {
  switch (row.command) {
    case Command::Move:
      if (row.axis == HandAxis::Press) return repeated ? void() : held_->begin(row.step);
      if (!repeated) model.motion.beginGesture();
      return model.motion.move(row.axis, wide ? row.wide : row.step);
    case Command::Freeze:
      if (!repeated) model.live.setFrozen(!model.live.isFrozen());
      return;
    case Command::Home:
      return model.motion.home();
    case Command::Recall:
      return panel->positions().recall(row.place);
    case Command::Undo:
      return undoStep(model.history, model.status);
    case Command::Redo:
      return redoStep(model.history, model.status);
    case Command::EarlierPicture:
      return model.live.showCine(model.live.cineIndex() - 1);
    case Command::LaterPicture:
      return model.live.showCine(model.live.cineIndex() + 1);
    case Command::SavePicture:
      return exports->askPicture();
    case Command::MeasureDistance:
      return chooseCalliper(int(views::CalliperKind::Distance));
    case Command::MeasureEllipse:
      return chooseCalliper(int(views::CalliperKind::Ellipse));
    case Command::MeasureAngle:
      return chooseCalliper(int(views::CalliperKind::Angle));
    case Command::StopMeasuring:
      return chooseCalliper(-1);
    case Command::ClearMeasures:
      return clearCallipers();
    case Command::NextEffect:
      return model.imaging.stepEffect(wide ? -1 : 1);
    case Command::WholePicture:
      return model.imaging.setEffect(ImagingModel::kWholeModel);
    case Command::CtBeside:
      return setCtBeside(!isCtBeside());
    case Command::ShowTissue:
      return model.disclosure.mayShowAnatomy() ? tissue->toggle(row.place) : void();
    case Command::AllSlices:
      return model.disclosure.mayShowAnatomy() ? patient->setAllSlices(!patient->showsAllSlices()) : void();
    case Command::SliceWindow:
      return patient->setSliceWindow(row.place);
    case Command::TakeNeedle:
      return repeated ? void() : model.needle.toggle();
    case Command::MoveNeedle:
      return model.needle.move(row.needle, wide ? row.wide : row.step);
    case Command::Attempt:
      return repeated ? void() : attempt->isRunning() ? attempt->finish() : attempt->start();
    case Command::Draw:
      return repeated ? void() : attempt->setAspirating(!attempt->isAspirating());
    case Command::NewNeedle:
      return repeated ? void() : attempt->replaceNeedle();
    case Command::ShowCourse:
      return repeated ? void() : showCourse(!isCourseShown());
    case Command::CutAtNeedle:
      return !repeated && model.disclosure.mayShowAnatomy() ? patient->toggleCutAtNeedle() : void();
  }
}

void TrainWorkspace::Parts::takeKeyboard(QObject* canvas) {
  // A field in which the user types keeps the keyboard focus.
  QWidget* holder = QApplication::focusWidget();
  const bool typing = qobject_cast<QLineEdit*>(holder) || qobject_cast<QAbstractSpinBox*>(holder);
  if (canvas == imageWidget_->focusProxy() && workspace_.isActiveWindow() && !typing)
    imageWidget_->setFocus(Qt::MouseFocusReason);
}

bool TrainWorkspace::Parts::sliceKey(const QObject* canvas, const QKeyEvent& event) const {
  const views::MprView* slice = patient->sliceOf(canvas);
  if (!slice || event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return false;
  switch (event.key()) {
    case Qt::Key_A:
    case Qt::Key_D:
    case Qt::Key_G:
    case Qt::Key_R:
      return true;
    // The probe's plane has no neighbors: there the arrows are the probe's.
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      return slice->kind() != views::SliceKind::Oblique;
    default:
      return false;
  }
}

bool TrainWorkspace::Parts::canvasEvent(QObject* canvas, QEvent* event) {
  if (event->type() == QEvent::Enter) takeKeyboard(canvas);
  return ui::offerKey(*event, [&](const QKeyEvent& pressed, bool act) {
    // The slice's own keys stay with the slice, and away from the window's shortcuts.
    if (sliceKey(canvas, pressed)) return !act;
    return key(pressed, act);
  });
}

}  // namespace insonate::train
