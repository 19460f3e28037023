#include "CaseViews.h"

#include "../labels/LabelSession.h"
#include "../model/CaseMeasuring.h"
#include "../model/Crosshair.h"
#include "../model/LivePatient.h"
#include "../model/OpenCase.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"
#include "../model/SliceSettings.h"
#include "../model/StructureAppearance.h"
#include "../model/StructureList.h"
#include "MarkedPlaces.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Widgets.h>

#include <QApplication>
#include <QDataStream>
#include <QLabel>
#include <QMouseEvent>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

/// Minimum interval at which 3D follows the probe; at rest it is drawn in full detail.
constexpr int kFollow_ms = 80, kRest_ms = 400;
constexpr double kAcross_deg = 15, kUp_deg = 25;

struct Slice {
  views::SliceKind kind;
  const char* name;
};
constexpr std::array<Slice, CaseViews::kSlices> kKinds{
    {{views::SliceKind::Axial, QT_TRANSLATE_NOOP("insonate::prepare::CaseViews", "Axial slice")},
     {views::SliceKind::Coronal, QT_TRANSLATE_NOOP("insonate::prepare::CaseViews", "Coronal slice")},
     {views::SliceKind::Sagittal, QT_TRANSLATE_NOOP("insonate::prepare::CaseViews", "Sagittal slice")}}};

}  // namespace

CaseViews::CaseViews(PrepareModel& shared, QWidget* parent)
    : QWidget(parent),
      shared_(shared),
      previewSurface_(shared.labeling.preview(), this),
      scene_(std::make_shared<views::SceneView>()) {
  scene_->lowerThreadPriority();
  setObjectName(QStringLiteral("caseViews"));
  arrange();
  buildEmpty();
  connectSlices();
  ui::CanvasInput::of(*widgets_[kSlices]->focusProxy()).add(ui::InputRank::Pointer, *this);
  follow_.setSingleShot(true);
  connect(&follow_, &QTimer::timeout, this, [this] { followProbe(); });
  rest_.setSingleShot(true);
  rest_.setInterval(kRest_ms);
  connect(&rest_, &QTimer::timeout, this, [this] {
    scene_->setMoving(false);
    if (rested_) rested_();
  });
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] { showCase(); });
  connect(&shared_.openCase, &OpenCase::saved, this, [this] { replaceCase(); });
  connect(&shared_.appearance, &StructureAppearance::lookChanged, this, [this](int label) { showLook(label); });
  connect(&shared_.slices, &SliceSettings::changed, this, [this] { showSlices(); });
  connect(&shared_.crosshair, &Crosshair::moved, this, [this] { showCrosshair(); });
  connect(&shared_.places, &PlacesEditor::changed, this, [this] { showPlaces(); });
  connect(&previewSurface_, &PreviewSurface::made, this,
          [this](const std::shared_ptr<const Mesh>& mesh) { showPreview(mesh.get()); });
  connect(&shared_.labeling, &LabelSession::seenChanged, this, [this] { showSeen(); });
  connect(&shared_.labeling, &LabelSession::changed, this, [this](const LabelChange& change) {
    if (case_) case_->labelsChanged(change.box);
    for (const auto& slice : slices_) slice->requestRender();
  });
  const LivePatient& live = shared_.live;
  connect(&live, &LivePatient::surfaceMade, this,
          [this](int label, const std::shared_ptr<const Mesh>& mesh) { showSurface(label, *mesh); });
  const auto want = [this] {
    if (!follow_.isActive()) follow_.start(kFollow_ms);
  };
  connect(&live, &LivePatient::poseChanged, this, want);
  connect(&live, &LivePatient::pictureShown, this, want);
  showCase();
}

CaseViews::~CaseViews() = default;

void CaseViews::arrange() {
  ui::setMaximizeArea(this);
  rows_ = new QSplitter(Qt::Vertical, this);
  for (QSplitter*& row : columns_) row = new QSplitter(Qt::Horizontal);
  for (std::size_t i = 0; i < widgets_.size(); ++i) {
    if (i < kKinds.size()) {
      slices_[i] = std::make_shared<views::MprView>(kKinds[i].kind);
      widgets_[i] = new ui::ViewWidget(slices_[i], tr(kKinds[i].name));
      widgets_[i]->setObjectName(QLatin1String(kKinds[i].name));
    } else {
      widgets_[i] = new ui::ViewWidget(scene_, tr("Patient in three dimensions"));
      widgets_[i]->setObjectName(QStringLiteral("Scene"));
    }
    columns_[i / 2]->addWidget(widgets_[i]);
  }
  for (QSplitter* row : columns_) {
    row->setSizes({1000, 1000});
    row->setChildrenCollapsible(false);
    row->setHandleWidth(ui::kSmallGap);
    // Both rows have the same column widths.
    connect(row, &QSplitter::splitterMoved, this, [this, row] {
      QSplitter* other = row == columns_[0] ? columns_[1] : columns_[0];
      other->setSizes(row->sizes());
    });
  }
  lower_ = new QStackedWidget;
  lower_->addWidget(columns_[1]);
  rows_->addWidget(columns_[0]);
  rows_->addWidget(lower_);
  rows_->setSizes({1000, 1000});
  rows_->setChildrenCollapsible(false);
  rows_->setHandleWidth(ui::kSmallGap);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(rows_);
}

void CaseViews::buildEmpty() {
  empty_ = ui::paragraph("sceneEmpty", "quiet",
                         tr("Nothing is labeled yet. Run the first step of the guide on the left. Skin, bone and "
                            "airway then appear here."));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* box = new QVBoxLayout(widgets_[kSlices]->focusProxy());
  box->addWidget(empty_);
  empty_->hide();
  const auto refresh = [this] {
    if (isUnlabeled() == !empty_->isHidden()) return;
    empty_->setVisible(isUnlabeled());
    followProbe();
  };
  connect(&shared_.measuring, &CaseMeasuring::changed, this, refresh);
  connect(&shared_.structures, &StructureList::changed, this, refresh);
}

bool CaseViews::isUnlabeled() const {
  return shared_.measuring.measures() && shared_.structures.labels().empty();
}

void CaseViews::connectSlices() {
  for (const auto& slice : slices_) {
    slice->setCrosshairMoved([this](Vec3 position_mm) { shared_.crosshair.moveTo(position_mm); });
    slice->setWindowLevelChanged([this](views::WindowLevel value) { shared_.slices.setWindowLevel(value); });
  }
}

void CaseViews::showCase() {
  case_ = shared_.openCase.patient() ? std::make_shared<views::VtkCase>(shared_.openCase.patient()) : nullptr;
  cameraPlaced_ = false;
  for (int label = 1; label < 256; ++label) scene_->setSurface(std::uint8_t(label), {});
  scene_->setCase(case_);
  scene_->setProbe(std::nullopt);
  scene_->setImage({});
  for (const auto& slice : slices_) slice->setCase(case_);
  for (int label = 1; label < 256; ++label) showLook(label);
  showSlices();
  showCrosshair();
  for (ui::ViewWidget* view : widgets()) view->forget();
}

void CaseViews::showSeen() {
  if (!case_ || case_->shared() != shared_.openCase.patient()) return;
  case_->setLabels(shared_.labeling.seen());
}

void CaseViews::replaceCase() {
  if (!case_) return;
  case_->setPatient(shared_.openCase.patient());
  showSeen();
}

void CaseViews::showLook(int label) {
  const auto value = std::uint8_t(label);
  const StructureLook& look = shared_.appearance.look(value);
  scene_->setColor(value, look.color);
  scene_->setOpacity(value, look.opacity);
  scene_->setVisible(value, look.visible && look.opacity > 0);
  for (const auto& slice : slices_) {
    slice->setLabelColor(value, look.color);
    slice->setLabelVisible(value, look.visible);
    slice->setRelativeLabelOpacity(value, look.onSlices);
  }
}

void CaseViews::showSlices() {
  for (const auto& slice : slices_) {
    if (slice->windowLevel() != shared_.slices.windowLevel()) slice->setWindowLevel(shared_.slices.windowLevel());
    slice->setLabelOpacity(shared_.slices.labelOpacity());
    slice->setLabelsVisible(shared_.slices.labelsShown());
    slice->setLabelStyle(shared_.slices.labelStyle());
  }
  showPlaces();
}

void CaseViews::showCrosshair() {
  for (const auto& slice : slices_) slice->setCrosshair(shared_.crosshair.position_mm());
}

void CaseViews::showSurface(int label, const Mesh& mesh) {
  scene_->setSurface(std::uint8_t(label), {mesh.points_mm, mesh.normals, mesh.triangles});
  if (label == kSkin || !cameraPlaced_) placeCamera();
}

void CaseViews::showPreview(const Mesh* mesh) {
  // No label has this number.
  constexpr std::uint8_t kPreview = Proposal::kKeep;
  constexpr double kFaded = 0.35;
  // One surface would hide the other.
  if (faded_ != 0) showLook(faded_);
  faded_ = mesh ? shared_.structures.selected() : std::uint8_t{0};
  if (faded_ != 0) scene_->setOpacity(faded_, kFaded * shared_.appearance.look(faded_).opacity);
  if (!mesh) return scene_->setSurface(kPreview, {});
  scene_->setColor(kPreview, views::theme::kAccent);
  scene_->setOpacity(kPreview, 1);
  scene_->setVisible(kPreview, true);
  scene_->setSurface(kPreview, {mesh->points_mm, mesh->normals, mesh->triangles});
}

void CaseViews::setSceneLine(std::vector<Vec3> line_mm) {
  if (line_mm.empty() && sceneLine_mm_.empty()) return;
  sceneLine_mm_ = std::move(line_mm);
  showPlaces();
}

void CaseViews::setClicks(const std::vector<Vec3>& clicks_mm) {
  if (clicks_mm == clicks_mm_) return;
  clicks_mm_ = clicks_mm;
  for (const auto& slice : slices_) slice->setMarks(clicks_mm_);
  showPlaces();
}

void CaseViews::showPlaces() {
  const MarkedPlaces marked = shared_.slices.placesShown() ? markedPlaces(shared_.places.value()) : MarkedPlaces{};
  for (const auto& slice : slices_) slice->setNamedPoints(marked.places);
  std::vector<views::ScenePath> paths = marked.paths;
  for (const Vec3& click_mm : clicks_mm_) addCross(paths, click_mm, views::theme::kText);
  paths.push_back({sceneLine_mm_, views::theme::kCaution});
  scene_->setPaths(std::move(paths));
}

void CaseViews::placeCamera() {
  scene_->setViewpoint(views::Viewpoint::Anterior);
  // Views from the side of the probe.
  const auto pose = shared_.live.pose();
  const bool right = pose && pose->offset.x < shared_.openCase.patient()->ct.geometry.center_mm().x;
  scene_->orbit(right ? kAcross_deg : -kAcross_deg, kUp_deg);
  cameraPlaced_ = true;
}

void CaseViews::followProbe() {
  const LivePatient& live = shared_.live;
  const auto pose = live.pose();
  if (!shared_.openCase.patient() || !pose) return;
  // There is no skin for the probe.
  if (isUnlabeled()) {
    scene_->setProbe(std::nullopt);
    return rest_.start();
  }
  if (*pose != pose_) scene_->setMoving(true);
  pose_ = *pose;
  rest_.start();
  scene_->setProbe(live.setup().probe, live.setup().settings);
  scene_->setProbePose(*pose);
  if (live.shown()) scene_->setImage(live.shown()->image);
}

void CaseViews::pickAt(QPoint at) {
  const double ratio = widgets_[kSlices]->devicePixelRatioF();
  const views::DisplayPoint point{(at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio};
  // A click on a vein that is visible through the skin selects the vein.
  constexpr double kSeenThrough = 0.5;
  auto picked = scene_->pick(point, kSeenThrough);
  if (!picked) picked = scene_->pick(point);
  if (picked) shared_.crosshair.moveTo(picked->position_mm);
}

bool CaseViews::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease ||
      event->type() == QEvent::MouseButtonDblClick) {
    const auto& mouse = *static_cast<QMouseEvent*>(event);
    if (mouse.button() != Qt::LeftButton) return false;
    if (event->type() == QEvent::MouseButtonPress) {
      pressed_ = mouse.pos();
      click_ = true;
    } else if (event->type() == QEvent::MouseButtonDblClick) {
      click_ = false;
    } else if (std::exchange(click_, false) &&
               (mouse.pos() - pressed_).manhattanLength() < QApplication::startDragDistance()) {
      pickAt(mouse.pos());
    }
  }
  return false;
}

void CaseViews::setLowerPanel(QWidget* panel) {
  lower_->addWidget(panel);
}

void CaseViews::showLowerPanel(bool isShown) {
  for (ui::ViewWidget* view : widgets_) view->setMaximized(false);
  lower_->setCurrentIndex(isShown ? 1 : 0);
}

QByteArray CaseViews::saveState() const {
  QByteArray state;
  QDataStream stream(&state, QIODevice::WriteOnly);
  stream << rows_->saveState() << columns_[0]->saveState();
  return state;
}

void CaseViews::restoreState(const QByteArray& state) {
  QDataStream stream(state);
  QByteArray rows, columns;
  stream >> rows >> columns;
  rows_->restoreState(rows);
  for (QSplitter* row : columns_) row->restoreState(columns);
}

}  // namespace insonate::prepare
