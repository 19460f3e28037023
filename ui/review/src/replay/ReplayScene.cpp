#include "ReplayScene.h"

#include <insonate/simulator/AttemptSettings.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/views/RodPaths.h>
#include <insonate/views/VtkCase.h>

#include <QScrollArea>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace insonate::review {
namespace {

/// Minimum interval between updates of 3D, which is drawn in full detail at rest.
constexpr int kFollow_ms = 80, kRest_ms = 400;
constexpr double kAcross_deg = 10, kUp_deg = 42, kNearer = 1.8, kSkinOpacity = 0.25;
/// Minimum length of a visible step of a path.
constexpr double kStep_mm = 0.2;
constexpr double kSign_mm = 1.5;

/// Outline of the place's sign, in the coronal plane: a circle in the vein, a triangle in a wrong place, a square once
/// used. Empty in other places.
views::ScenePath signAt(Vec3 middle_mm, NeedlePlace place) {
  const int corners = place == NeedlePlace::Vein         ? 24
                      : place == NeedlePlace::WrongPlace ? 3
                      : place == NeedlePlace::Used       ? 4
                                                         : 0;
  views::ScenePath outline{{}, ui::colorOf(place)};
  for (int i = 0; corners > 0 && i <= corners; ++i) {
    // The triangle points up, the square stands on its side.
    const double angle = (2.0 * i + (corners == 4 ? 1 : 0)) * std::numbers::pi / corners;
    outline.points_mm.push_back(middle_mm + kSign_mm * Vec3{std::sin(angle), 0, std::cos(angle)});
  }
  return outline;
}

}  // namespace

std::vector<views::ScenePath> pathOf(const AttemptDigest& attempt) {
  std::vector<views::ScenePath> paths;
  bool broken = true;
  for (const TrackPoint& point : attempt.track) {
    if (!point.needleDepth_mm || !point.tip_mm) {
      broken = true;
      continue;
    }
    const views::Color color = ui::colorOf(point.place);
    if (broken || paths.back().color != color) {
      // Pieces of one path share their end points.
      const auto join = broken ? std::vector<Vec3>{} : std::vector<Vec3>{paths.back().points_mm.back()};
      paths.push_back({join, color});
      broken = false;
    }
    auto& points = paths.back().points_mm;
    if (points.empty() || norm(points.back() - *point.tip_mm) >= kStep_mm) points.push_back(*point.tip_mm);
  }
  return paths;
}

std::vector<views::ScenePath> signsOf(const AttemptDigest& attempt) {
  std::vector<views::ScenePath> signs;
  auto before = NeedlePlace::Clean;
  for (const TrackPoint& point : attempt.track) {
    if (point.needleDepth_mm && point.tip_mm && point.place != before) {
      if (auto sign = signAt(*point.tip_mm, point.place); !sign.points_mm.empty()) signs.push_back(std::move(sign));
    }
    before = point.place;
  }
  return signs;
}

ReplayScene::ReplayScene(ReviewSession& session, QObject* parent)
    : QObject(parent),
      session_(session),
      view_(std::make_shared<views::SceneView>()),
      widget_(new ui::ViewWidget(view_, tr("Patient, probe and needle in three dimensions"))) {
  widget_->setObjectName(QStringLiteral("replayScene"));
  view_->setSkinOpacity(kSkinOpacity);
  panel_ = new ui::ScenePanel(view_);
  panelArea_ = new QScrollArea;
  panelArea_->setWidget(panel_);
  panelArea_->setWidgetResizable(true);
  panelArea_->setFrameShape(QFrame::NoFrame);
  panelArea_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  panelArea_->setFocusPolicy(Qt::NoFocus);
  follow_.setSingleShot(true);
  rest_.setSingleShot(true);
  rest_.setInterval(kRest_ms);
  connect(&follow_, &QTimer::timeout, this, [this] { showHands(); });
  connect(&rest_, &QTimer::timeout, this, [this] {
    view_->setMoving(false);
    if (rested_) rested_();
  });
  const auto want = [this] {
    if (!follow_.isActive()) follow_.start(kFollow_ms);
  };
  connect(&session_, &ReviewSession::caseChanged, this, [this] { showCase(); });
  connect(&session_, &ReviewSession::attemptChanged, this, [this] {
    cameraDue_ = true;
    rods_ = nullptr;
    showPath();
  });
  connect(&session_, &ReviewSession::timeChanged, this, want);
  connect(&session_, &ReviewSession::pictureShown, this, want);
  connect(&session_, &ReviewSession::surfacesDone, this, [this] {
    cameraDue_ = true;
    placeCamera();
  });
  connect(&session_, &ReviewSession::surfaceMade, this, [this](int label, const std::shared_ptr<const Mesh>& mesh) {
    view_->setSurface(std::uint8_t(label), {mesh->points_mm, mesh->normals, mesh->triangles});
  });
}

void ReplayScene::showCase() {
  const auto patient = session_.fits() ? session_.patient() : nullptr;
  if (patient == shown_) return;
  shown_ = patient;
  case_ = patient ? std::make_shared<views::VtkCase>(patient) : nullptr;
  for (const LabelInfo& info : labelTable()) view_->setSurface(info.label, {});
  view_->setCase(case_);
  panel_->setCase(patient);
  view_->setProbe(std::nullopt);
  settings_.clear();
  widget_->forget();
  showPath();
}

void ReplayScene::showPath() {
  std::vector<views::ScenePath> paths;
  if (const auto& attempt = session_.attempt()) {
    paths = pathOf(*attempt);
    for (auto& sign : signsOf(*attempt)) paths.push_back(std::move(sign));
    if (rods_)
      for (auto& rod : views::pathsOf(*rods_)) paths.push_back(std::move(rod));
  }
  view_->setPaths(std::move(paths));
}

void ReplayScene::showHands() {
  const auto& sample = session_.sample();
  const bool probe = session_.fits() && sample && sample->patientFromProbe;
  view_->setProbeVisible(probe);
  view_->setImagePlaneVisible(probe);
  if (probe) showProbe(*sample);
  const bool needle = sample && sample->patientFromNeedle;
  view_->setNeedle(needle ? std::optional(views::SceneView::Needle{.patientFromNeedle = *sample->patientFromNeedle,
                                                                   .color = ui::colorOf(session_.needle().place)})
                          : std::nullopt);
  if (session_.isPlaying()) view_->setMoving(true);
  rest_.start();
  placeCamera();
}

/// As set in the attempt, even if its image cannot be made.
void ReplayScene::showProbe(const AttemptSample& sample) {
  const auto text = session_.attempt()->recording->settingsAt(sample.time_us);
  if (text && *text != settings_) {
    settings_ = *text;
    if (const auto settings = parseAttemptSettings(settings_))
      view_->setProbe(settings->setup.probe, settings->setup.settings);
  }
  view_->setProbePose(*sample.patientFromProbe);
  // The plane follows the probe, so that an image of another moment has no place in it.
  const auto frame = session_.isImageStale() ? nullptr : session_.picture().shown();
  if (std::exchange(pictured_, frame) == frame) return;
  view_->setImage(frame ? frame->image : BModeImage{});
  if (frame && std::exchange(rods_, frame->rods) != frame->rods) showPath();
}

/// From above the probe, so that needle and image are visible.
void ReplayScene::placeCamera() {
  if (!cameraDue_ || !session_.fits() || !session_.surfacesThere() || !widget_->isVisible()) return;
  const auto& track = session_.attempt()->track;
  const auto first = std::ranges::find_if(track, [](const TrackPoint& p) { return p.tip_mm.has_value(); });
  const double side = first != track.end() && first->tip_mm->x < session_.patient()->ct.geometry.center_mm().x ? 1 : -1;
  view_->setViewpoint(views::Viewpoint::Anterior);
  view_->orbit(side * kAcross_deg, kUp_deg);
  // The place of the puncture is in the middle.
  if (first != track.end()) {
    const auto deepest = std::ranges::max_element(
        track, {}, [](const TrackPoint& p) { return p.tip_mm ? p.needleDepth_mm.value_or(-1) : -2; });
    const views::DisplayPoint at = view_->displayFromPatient(*deepest->tip_mm);
    view_->pan(view_->width_px() / 2.0 - at.x, view_->height_px() / 2.0 - at.y);
  }
  view_->zoom(kNearer);
  cameraDue_ = false;
}

}  // namespace insonate::review
