#include "CaseModel.h"

#include "StatusLine.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <utility>

namespace insonate::train {

namespace {

/// Few enough triangles that 3D follows the probe without a graphics card.
const std::vector<ui::SurfaceRequest> kSurfaces = {{kVein, {4, 1}}, {kArtery, {4, 1}}, {kSkin, {8, 3}},
                                                   {kBone, {5, 2}}, {kAirway, {5, 2}}, {kThyroid, {5, 1.5}}};

}  // namespace

CaseModel::CaseModel(StatusLine& status, QObject* parent) : QObject(parent), status_(status) {}

CaseModel::~CaseModel() = default;

void CaseModel::stop() {
  worker_ = nullptr;
  Q_EMIT stopping();
}

void CaseModel::setCase(std::shared_ptr<const PatientCase> patient, const ui::CaseOrigin& origin) {
  stop();
  patient_ = std::move(patient);
  tissueLabels_ = nullptr;
  origin_ = origin;
  start_ = {};
  structures_.reset();
  Q_EMIT emptied();
  status_.showMessage(patient_ ? tr("Building the first image.") : QString());
  Q_EMIT caseChanged();
  Q_EMIT caseShown();
  if (patient_) startWorker();
}

bool CaseModel::lacksVessels() const {
  return structures_ && std::ranges::none_of(*structures_, [](auto one) { return one == kVein || one == kArtery; });
}

void CaseModel::setStart(StartPose pose) {
  start_ = std::move(pose);
  Q_EMIT startKnown();
}

void CaseModel::fail(const QString& why) {
  status_.showMessage(why);
  wantSurfaces();
  Q_EMIT failed(why);
}

void CaseModel::startWorker() {
  ui::CaseCallbacks work;
  work.tissues = [this](std::shared_ptr<const LabelMap> labels) {
    tissueLabels_ = std::move(labels);
    Q_EMIT tissuesKnown();
  };
  work.start = [this](StartPose pose) { setStart(std::move(pose)); };
  work.hand = [this](const ProbePlacement& hand) { Q_EMIT handMade(hand); };
  work.unplaced = [this](const ProbePlacement& hand, const QString& why) {
    status_.showMessage(why);
    wantSurfaces();
    Q_EMIT startMissing(hand);
  };
  work.structures = [this](const std::vector<std::uint8_t>& labels) {
    structures_ = labels;
    Q_EMIT structuresKnown();
  };
  work.surface = [this](std::uint8_t label, std::shared_ptr<const Mesh> mesh) { Q_EMIT surfaceMade(label, mesh); };
  work.surfacesDone = [this] {
    surfacesThere_ = surfacesRequested_;
    if (surfacesThere_) Q_EMIT surfacesDone();
  };
  work.failed = [this](const QString& text) { fail(text); };
  worker_ = std::make_unique<ui::CaseWorker>(patient_, std::move(work), std::vector<ui::SurfaceRequest>{});
  surfacesRequested_ = surfacesThere_ = false;
}

void CaseModel::wantSurfaces() {
  if (!worker_ || std::exchange(surfacesRequested_, true)) return;
  std::vector<ui::SurfaceRequest> wishes = kSurfaces;
  for (const auto& [label, shown] : patient_->manifest.shown)
    if (shown.visible && shown.opacity > 0 &&
        std::ranges::find(wishes, label, &ui::SurfaceRequest::label) == wishes.end())
      wishes.push_back({label, {5, 2}});
  worker_->requestSurfaces(wishes);
}

}  // namespace insonate::train
