#include "PatientViews.h"

#include "../model/TrainModel.h"
#include "FourSlices.h"
#include "SceneInput.h"
#include "SceneNeedle.h"
#include "SliceMenu.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/HistogramEditor.h>
#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/views/RodPaths.h>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::train {
namespace {

/// Renderings of both views together may take this share of the time; the rest is the image's. Each also makes Qt put
/// the whole window together again, which a processor without a graphics card feels.
constexpr double kPatientShare = 0.2;
/// But the CT cast in 3D would follow a few times a second only, and who shows it wants to see it move.
constexpr int kSoonest_ms = 50, kLatest_ms = 800, kLatestWithCt_ms = 70;
/// After this long without a move, 3D is drawn in full detail.
constexpr int kRest_ms = 400;
/// Room for the tabs.
constexpr int kRoomyWidth_px = 446, kCompactWidth_px = 292;
constexpr int kSceneShare = 35;  // of the height, beside four slices, in percent
/// The tabs beside those of the slices.
constexpr int kScenePanel = 100, kAllSlices = 101;
constexpr double kAcross_deg = 10, kUp_deg = 42, kRoomForProbe = 0.8;

struct SliceEntry {
  views::SliceKind kind;
  const char* name;
  const char* briefly;
  const char* says;
};
constexpr SliceEntry kSliceEntries[] = {
    {views::SliceKind::Oblique, "Probe", "Probe", "CT in the image plane, oriented like the ultrasound image"},
    {views::SliceKind::Axial, "Axial", "Ax", "seen from the feet"},
    {views::SliceKind::Coronal, "Coronal", "Cor", "seen from the front"},
    {views::SliceKind::Sagittal, "Sagittal", "Sag", "the front on the left"},
};

}  // namespace

PatientViews::PatientViews(TrainModel& model, const ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      model_(model),
      scene_(std::make_shared<views::SceneView>()),
      mpr_(std::make_shared<views::MprView>(views::SliceKind::Oblique)) {
  mpr_->setLabelOpacity(0);
  sceneWidget_ = new ui::ViewWidget(scene_, tr("Patient and probe in three dimensions"), this);
  sceneWidget_->setObjectName(QStringLiteral("sceneView"));
  mprWidget_ = new ui::ViewWidget(mpr_, tr("CT slice"), this);
  splitter_ = new QSplitter(Qt::Vertical, this);
  splitter_->setObjectName(QStringLiteral("patientSplitter"));
  splitter_->addWidget(sceneWidget_);
  below_ = new QStackedWidget(splitter_);
  below_->addWidget(buildMpr(commands));
  below_->addWidget(buildSilence());
  splitter_->setSizes({500, 500});
  splitter_->setChildrenCollapsible(false);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(splitter_);
  input_ = new SceneInput(model_.hands, model_.motion, model_.needle, *scene_, *sceneWidget_->focusProxy(), this);

  needle_ = new SceneNeedle(model_.hands, model_.patientCase, model_.status, *scene_, this);
  connect(needle_, &SceneNeedle::changed, this, [this] { showMoving(); });

  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { follow(); });
  rest_.setSingleShot(true);
  rest_.setInterval(kRest_ms);
  connect(&rest_, &QTimer::timeout, this, [this] { scene_->setMoving(false); });
  connect(&model_.patientCase, &CaseModel::caseChanged, this, [this] { showCase(); });
  connect(&model_.patientCase, &CaseModel::tissuesKnown, this,
          [this] { case_->setLabels(model_.patientCase.tissueLabels()); });
  connect(&model_.patientCase, &CaseModel::surfaceMade, this,
          [this](int label, const std::shared_ptr<const Mesh>& mesh) { showSurface(label, *mesh); });
  connect(&model_.live, &LiveModel::pictureShown, this, [this] { want(); });
  connect(&model_.motion, &ProbeMotion::handMoved, this, [this] { want(); });
  connect(&model_.hands, &HapticControl::needleChanged, this, [this] { want(); });
  connect(&model_.disclosure, &DisclosureModel::changed, this, [this] { applyDisclosure(); });
}

PatientViews::~PatientViews() = default;

QWidget* PatientViews::buildMpr(const ui::Commands& commands) {
  auto* pane = new QWidget(this);
  auto* box = new QVBoxLayout(pane);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  kinds_ = new QButtonGroup(this);
  const auto addTab = [&](int id, const QString& text, const QString& name, const QString& tip) {
    auto* button = new QToolButton(pane);
    button->setText(text);
    button->setToolTip(tip);
    button->setAccessibleName(name);
    button->setCheckable(true);
    ui::setRole(button, "narrowTab");
    button->setFocusPolicy(Qt::TabFocus);
    kinds_->addButton(button, id);
    row->addWidget(button);
    return button;
  };
  for (const SliceEntry& kind : kSliceEntries)
    addTab(int(kind.kind), tr(kind.name), tr("%1 slice").arg(tr(kind.name)), tr(kind.says));
  kinds_->button(int(views::SliceKind::Oblique))->setChecked(true);
  addTab(kAllSlices, tr("All"), tr("All slices"), commands.toolTip("train.patient3d.allSlices"))
      ->setObjectName(QStringLiteral("allSlicesTab"));
  row->addStretch();
  addTab(kScenePanel, tr("3D"), tr("Contents of the 3D view"),
         tr("Contents of the 3D view above: skin, structures, CT volume, clipping plane, stereo"))
      ->setObjectName(QStringLiteral("sceneTab"));
  sliceMenu_ = new SliceMenu(*mpr_, commands, pane);
  auto* how = howSliced_ = new QToolButton(pane);
  how->setObjectName(QStringLiteral("sliceMenu"));
  how->setIcon(ui::icon(QStringLiteral("view")));
  how->setAccessibleName(tr("Display of the CT slice"));
  how->setToolTip(tr("Display of the CT slice: window and level in HU, opacity of the structures in %"));
  how->setPopupMode(QToolButton::InstantPopup);
  how->setMenu(sliceMenu_);
  how->setFocusPolicy(Qt::TabFocus);
  QSizePolicy kept = how->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  how->setSizePolicy(kept);
  row->addWidget(how);
  connect(kinds_, &QButtonGroup::idClicked, this, [this](int id) {
    if (id == kScenePanel) return showBelow(sceneScroll_);
    id == kAllSlices ? setAllSlices(true) : setSliceKind(views::SliceKind(id));
  });
  box->addLayout(row);
  box->addWidget(mprWidget_, 1);
  four_ = new FourSlices(pane);
  four_->hide();
  for (std::size_t n = 0; n < FourSlices::kCount; ++n) sliceMenu_->addSlice(four_->slice(n));
  box->addWidget(four_, 1);
  box->addWidget(buildScenePanel(pane), 1);
  return pane;
}

QWidget* PatientViews::buildScenePanel(QWidget* parent) {
  scenePanel_ = new ui::ScenePanel(scene_);
  connect(scenePanel_, &ui::ScenePanel::colorsChanged, this, [this] {
    for (const LabelInfo& info : labelTable()) {
      mpr_->setLabelColor(info.label, scene_->color(info.label));
      four_->setLabelColor(info.label, scene_->color(info.label));
    }
  });
  sceneScroll_ = new QScrollArea(parent);
  sceneScroll_->setWidget(scenePanel_);
  sceneScroll_->setWidgetResizable(true);
  sceneScroll_->setFrameShape(QFrame::NoFrame);
  sceneScroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  sceneScroll_->setFocusPolicy(Qt::NoFocus);
  // The column keeps its width, whichever tab is chosen.
  sceneScroll_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
  sceneScroll_->hide();
  return sceneScroll_;
}

void PatientViews::setCompact(bool compact) {
  for (const SliceEntry& kind : kSliceEntries)
    kinds_->button(int(kind.kind))->setText(tr(compact ? kind.briefly : kind.name));
  for (QAbstractButton* tab : kinds_->buttons()) {
    ui::setRole(tab, compact ? "shortTab" : "narrowTab");
    tab->style()->unpolish(tab);
    tab->style()->polish(tab);
  }
  // Said, since it would change with the chosen tab's bold letters.
  setMinimumWidth(compact ? kCompactWidth_px : kRoomyWidth_px);
}

void PatientViews::showBelow(QWidget* shown) {
  if ((shown == four_) != showsAllSlices()) expandPatientColumn(shown == four_);
  for (QWidget* one :
       {static_cast<QWidget*>(mprWidget_), static_cast<QWidget*>(four_), static_cast<QWidget*>(sceneScroll_)})
    one->setVisible(one == shown);
  howSliced_->setVisible(shown != sceneScroll_);
  scenePanel_->histogram().setWindowLevel(mpr_->windowLevel());
}

/// Gives four slices the larger part of the column's height, and as much width as the image has.
void PatientViews::expandPatientColumn(bool more) {
  if (more) {
    splitBefore_ = splitter_->saveState();
    splitter_->setSizes({kSceneShare, 100 - kSceneShare});
  } else if (!splitBefore_.isEmpty()) {
    splitter_->restoreState(splitBefore_);
  }
  if (roomRequested_) roomRequested_(more);
}

bool PatientViews::showsAllSlices() const {
  return !four_->isHidden();
}

void PatientViews::setAllSlices(bool on) {
  if (!on) return setSliceKind(mpr_->kind());
  kinds_->button(kAllSlices)->setChecked(true);
  four_->setWindowLevel(mpr_->windowLevel());
  four_->setLabelOpacity(mpr_->labelOpacity());
  showBelow(four_);
  want();
}

void PatientViews::setSliceKind(views::SliceKind kind) {
  if (auto* button = kinds_->button(int(kind))) button->setChecked(true);
  showBelow(mprWidget_);
  mpr_->setKind(kind);
  mpr_->setCrosshairVisible(kind != views::SliceKind::Oblique);
  slicedAt_.reset();
  sliceToProbe();
  want();
}

Transform PatientViews::poseNow() const {
  // The image of a moving probe is a moment old; the probe itself is where the hand has it.
  const bool live = !model_.live.isFrozen() && model_.motion.isReady();
  return live ? model_.motion.pose() : model_.live.shown()->patientFromProbe;
}

void PatientViews::sliceToProbe() {
  const auto& frame = model_.live.shown();
  if (!frame || mpr_->kind() == views::SliceKind::Oblique || slicedAt_ == poseNow()) return;
  slicedAt_ = poseNow();
  mpr_->setCrosshair(*slicedAt_ * Vec3{0, 0, frame->setup->settings.depth_mm / 2});
}

void PatientViews::setWindowChanged(const std::function<void(views::WindowLevel)>& listener) {
  const auto all = [this, listener](views::WindowLevel value) {
    mpr_->setWindowLevel(value);
    four_->setWindowLevel(value);
    listener(value);
  };
  mpr_->setWindowLevelChanged(all);
  four_->setWindowChanged(all);
  sliceMenu_->setChosen(all);
}

void PatientViews::setSliceWindow(int preset) {
  sliceMenu_->choose(preset);
}

void PatientViews::showCase() {
  timer_.stop();
  rest_.stop();
  scene_->setMoving(false);
  inPlane_ = nullptr;
  slicedAt_.reset();
  cameraDue_ = false;
  shape_ = nullptr;
  case_ = model_.patientCase.patient() ? std::make_shared<views::VtkCase>(model_.patientCase.patient()) : nullptr;
  for (const LabelInfo& info : labelTable()) scene_->setSurface(info.label, {});
  scene_->setCase(case_);
  setTrayVisible(false);
  needle_->removeCut();
  scenePanel_->setCase(model_.patientCase.patient());
  scene_->setProbe(std::nullopt);
  scene_->setImage({});
  // The slice waits for the probe: before, it has no plane to show.
  mpr_->setCase(nullptr);
  four_->setCase(nullptr);
  sliceShown_ = false;
  mpr_->setFan(std::nullopt);
  mpr_->setCrosshairVisible(mpr_->kind() != views::SliceKind::Oblique);
  for (ui::ViewWidget* view : {sceneWidget_, mprWidget_}) view->forget();
}

void PatientViews::showSurface(int label, const Mesh& mesh) {
  scene_->setSurface(std::uint8_t(label), {mesh.points_mm, mesh.normals, mesh.triangles});
  if (label != kSkin) return;
  cameraDue_ = true;
  want();
}

void PatientViews::placeCamera() {
  // From the probe's side and above, so that its plane is seen, with room for the probe.
  const double side =
      model_.live.shown()->patientFromProbe.offset.x < model_.patientCase.patient()->ct.geometry.center_mm().x ? 1 : -1;
  scene_->setViewpoint(views::Viewpoint::Anterior);
  scene_->orbit(side * kAcross_deg, kUp_deg);
  scene_->zoom(kRoomForProbe);
  cameraDue_ = false;
}

void PatientViews::setFollowing(bool following) {
  following_ = following;
  if (following)
    want();
  else
    timer_.stop();
}

void PatientViews::want() {
  if (!following_ || timer_.isActive()) return;
  const double cost_ms =
      1000 * (scene_->renderTime_s() +
              (showsAllSlices() ? four_->renderTime_s() : mpr_->renderer()->GetLastRenderTimeInSeconds()));
  const int latest_ms = scene_->isCtVisible() ? kLatestWithCt_ms : kLatest_ms;
  const int gap_ms = std::clamp(int(cost_ms / kPatientShare), kSoonest_ms, latest_ms);
  const int since_ms =
      sinceFollowed_.isValid() ? int(std::min<qint64>(sinceFollowed_.elapsed(), latest_ms)) : latest_ms;
  timer_.start(std::max(0, gap_ms - since_ms));
}

void PatientViews::follow() {
  sinceFollowed_.start();
  const auto& frame = model_.live.shown();
  if (!frame && !model_.motion.isReady()) return;
  if (!std::exchange(sliceShown_, true)) {
    mpr_->setCase(case_);
    four_->setCase(case_);
  }
  if (!frame) {
    mpr_->setFan(model_.imaging.probe(), model_.imaging.settings());
    mpr_->setProbePose(model_.motion.pose());
    return;
  }
  if (frame->setup != shape_) {
    shape_ = frame->setup;
    scene_->setProbe(shape_->probe, shape_->settings);
    mpr_->setFan(shape_->probe, shape_->settings);
  }
  const Transform pose = poseNow();
  if (pose != pose_) showMoving();
  pose_ = pose;
  scene_->setProbePose(pose);
  needle_->follow();
  mpr_->setProbePose(pose);
  // Slices follow the probe when it moves; in between, they are the user's.
  sliceToProbe();
  if (showsAllSlices()) four_->follow(frame->setup, pose);
  showInPlane(frame);
  showRods(frame->rods);
  if (cameraDue_ && sceneWidget_->isVisible()) placeCamera();
}

/// The plane follows the probe, so that an image of another position has no place in it.
void PatientViews::showInPlane(const std::shared_ptr<const LiveFrame>& frame) {
  const auto shown = model_.live.isStale() ? nullptr : frame;
  if (std::exchange(inPlane_, shown) != shown) scene_->setImage(shown ? shown->image : BModeImage{});
}

void PatientViews::showRods(const SharedRods& rods) {
  if (std::exchange(rods_, rods) == rods) return;
  const auto paths = rods ? views::pathsOf(*rods) : std::vector<views::ScenePath>{};
  scene_->setPaths(paths);
  mpr_->setToolMarks({.points_mm = {}, .line_mm = {}, .brush = {}, .paths = paths});
  four_->setPaths(paths);
}

void PatientViews::showMoving() {
  scene_->setMoving(true);
  rest_.start();
}

void PatientViews::turn(double across_deg, double up_deg) {
  scene_->orbit(across_deg, up_deg);
  showMoving();
}

void PatientViews::setTrayVisible(bool visible) {
  needle_->setTray(visible, visible ? poseNow().offset : Vec3{});
  input_->setTray(needle_->tray());
}

void PatientViews::setTrayTaken(std::function<void()> listener) {
  input_->setTrayTaken(std::move(listener));
}

QWidget* PatientViews::buildSilence() {
  auto* words = new QLabel(tr("During a test, CT and anatomy are hidden."));
  words->setObjectName(QStringLiteral("testWords"));
  words->setAlignment(Qt::AlignCenter);
  ui::setRole(words, "quiet");
  return words;
}

void PatientViews::applyDisclosure() {
  const bool hidden = !model_.disclosure.current().anatomy;
  if (hidden == looksBefore_.has_value()) return;
  below_->setCurrentIndex(hidden ? 1 : 0);
  if (hidden) {
    needle_->removeCut();
    looksBefore_ = Looks{scene_->opacity(kSkin), scene_->isCtVisible(), {}, scene_->clipping()};
    // Also those whose surface is still being made.
    for (const LabelInfo& info : labelTable())
      if (info.label != kSkin && scene_->isVisible(info.label)) looksBefore_->shown.push_back(info.label);
    for (const std::uint8_t label : looksBefore_->shown) scene_->setVisible(label, false);
    scene_->setSkinOpacity(1);
    scene_->setCtVisible(false);
    scene_->setClipping({});
  } else {
    for (const std::uint8_t label : looksBefore_->shown) scene_->setVisible(label, true);
    scene_->setSkinOpacity(looksBefore_->skin);
    scene_->setCtVisible(looksBefore_->ct);
    scene_->setClipping(looksBefore_->clipping);
    looksBefore_.reset();
  }
}

}  // namespace insonate::train
