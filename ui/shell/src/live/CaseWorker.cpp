#include <insonate/cases/StartPose.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/CaseWorker.h>

#include <algorithm>
#include <utility>

namespace insonate::ui {

CaseWorker::CaseWorker(std::shared_ptr<const PatientCase> patient, CaseWork work, std::vector<SurfaceWish> wishes)
    : patient_(std::move(patient)),
      work_(std::move(work)),
      wishes_(wishes.begin(), wishes.end()),
      thread_([this] { run(); }) {}

CaseWorker::~CaseWorker() {
  {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
  }
  wanted_.notify_all();
  thread_.join();
}

void CaseWorker::want(const std::vector<SurfaceWish>& wishes) {
  {
    const std::lock_guard lock(mutex_);
    wishes_.insert(wishes_.end(), wishes.begin(), wishes.end());
  }
  wanted_.notify_all();
}

void CaseWorker::deliver(std::function<void()> call) {
  // Queued to this object: gone with it, if it goes first.
  QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
}

void CaseWorker::run() {
  if (work_.start || work_.hand) placeProbe();
  makeSurfaces();
}

void CaseWorker::placeProbe() {
  const auto failed = [this](const Error& error) {
    deliver([this, text = QString::fromStdString(error.message)] {
      if (work_.failed) work_.failed(text);
    });
  };
  const auto start = autoStartPose(*patient_);
  if (!start) return failed(start.error());
  if (work_.start) deliver([this, pose = *start] { work_.start(pose); });
  const auto pose = patientFromProbe(start->position_mm, start->axial, start->lateral);
  if (!pose) return failed(pose.error());
  if (cancelled() || !work_.hand) return;
  auto hand = ProbeHand::make(patient_->labels, *pose);
  if (!hand) return failed(hand.error());
  if (!cancelled()) deliver([this, made = std::move(*hand)] { work_.hand(made); });
}

void CaseWorker::makeSurfaces() {
  const auto present = structuresIn(patient_->labels);
  std::unique_lock lock(mutex_);
  while (!cancelled()) {
    if (wishes_.empty()) {
      if (work_.surfacesDone) deliver([this] { work_.surfacesDone(); });
      wanted_.wait(lock, [this] { return cancelled() || !wishes_.empty(); });
      continue;
    }
    const SurfaceWish wish = wishes_.front();
    wishes_.pop_front();
    lock.unlock();
    const bool there = wish.label == kSkin ? !present.empty() : std::ranges::find(present, wish.label) != present.end();
    if (there && work_.surface) makeSurface(wish);
    lock.lock();
  }
}

void CaseWorker::makeSurface(const SurfaceWish& wish) {
  const Progress asked = [this](std::string_view, double) { return !cancelled(); };
  auto mesh = wish.label == kSkin ? extractBody(patient_->labels, wish.options, asked)
                                  : extractSurface(patient_->labels, wish.label, wish.options, asked);
  // A structure that has no surface is not shown; nothing else depends on it.
  if (!mesh || cancelled()) return;
  deliver([this, label = wish.label, made = std::make_shared<const Mesh>(std::move(*mesh))] {
    work_.surface(label, made);
  });
}

}  // namespace insonate::ui
