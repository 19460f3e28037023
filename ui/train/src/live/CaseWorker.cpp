#include "CaseWorker.h"

#include <insonate/cases/StartPose.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/surface/ExtractSurface.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>

namespace insonate::train {
namespace {

/// Few enough triangles that 3D follows the probe without a graphics card.
struct Detail {
  std::uint8_t label;
  SurfaceOptions options;
};
constexpr Detail kVessels[] = {{kVein, {4, 1}}, {kArtery, {4, 1}}};
constexpr Detail kSlower[] = {{kBone, {5, 2}}, {kAirway, {5, 2}}, {kThyroid, {5, 1.5}}};
constexpr SurfaceOptions kBody{8, 3};

LabelMap bodyOf(const LabelMap& labels) {
  LabelMap body(labels.geometry);
  std::transform(labels.voxels.begin(), labels.voxels.end(), body.voxels.begin(),
                 [](std::uint8_t label) { return std::uint8_t{label != kBackground}; });
  return body;
}

}  // namespace

CaseWorker::CaseWorker(std::shared_ptr<const PatientCase> patient, CaseWork work)
    : patient_(std::move(patient)), work_(std::move(work)), thread_([this] { run(); }) {}

CaseWorker::~CaseWorker() {
  cancelled_ = true;
  thread_.join();
}

void CaseWorker::deliver(std::function<void()> call) {
  // Queued to this object: gone with it, if it goes first.
  QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
}

void CaseWorker::run() {
  const auto start = autoStartPose(*patient_);
  if (!start) return deliver([this, text = QString::fromStdString(start.error().message)] { work_.failed(text); });
  deliver([this, pose = *start] { work_.start(pose); });
  const auto pose = patientFromProbe(start->position_mm, start->axial, start->lateral);
  if (!pose) return deliver([this, text = QString::fromStdString(pose.error().message)] { work_.failed(text); });
  if (cancelled()) return;

  auto hand = ProbeHand::make(patient_->labels, *pose);
  if (cancelled()) return;
  if (hand)
    deliver([this, made = std::move(*hand)] { work_.hand(made); });
  else
    deliver([this, text = QString::fromStdString(hand.error().message)] { work_.failed(text); });
  surfaces();
}

void CaseWorker::surfaces() {
  const auto present = structuresIn(patient_->labels);
  const auto make = [&](const LabelMap& labels, std::uint8_t label, std::uint8_t as, const SurfaceOptions& options) {
    if (cancelled()) return;
    auto mesh = extractSurface(labels, label, options, [this](std::string_view, double) { return !cancelled(); });
    if (!mesh || cancelled()) return;  // A structure that has no surface is not shown; nothing else depends on it.
    deliver([this, as, made = std::make_shared<const Mesh>(std::move(*mesh))] { work_.surface(as, made); });
  };
  const auto makeAll = [&](const auto& details) {
    for (const Detail& detail : details)
      if (std::ranges::find(present, detail.label) != present.end())
        make(patient_->labels, detail.label, detail.label, detail.options);
  };
  if (present.empty()) return;
  makeAll(kVessels);
  make(bodyOf(patient_->labels), 1, kSkin, kBody);
  makeAll(kSlower);
}

}  // namespace insonate::train
