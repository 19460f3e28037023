#include "JobThreads.h"

#include <insonate/cases/CaseView.h>
#include <insonate/cases/StartPose.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/CaseWorker.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

namespace insonate::ui {

/// The work of the thread, which may outlive the worker; it accesses the worker only while the worker exists.
class CaseWorker::Job {
 public:
  /// A requested result; defined here, so that it has no dependence on the worker.
  struct Wanted {
    bool tissues, start, hand, unplaced, structures, surface, surfacesDone, failed;
  };

  Job(CaseWorker& worker, std::shared_ptr<const PatientCase> patient, Wanted wanted,
      std::vector<SurfaceRequest> requests)
      : worker_(&worker),
        patient_(std::move(patient)),
        labels_(CaseVolumes(patient_).labels),
        wanted_(wanted),
        requests_(requests.begin(), requests.end()) {}

  void place(std::shared_ptr<const LabelMap> labels) {
    {
      const std::lock_guard lock(mutex_);
      skin_ = std::move(labels);
    }
    changed_.notify_all();
  }
  void requestSurfaces(const std::vector<SurfaceRequest>& requests) {
    {
      const std::lock_guard lock(mutex_);
      for (const SurfaceRequest& request : requests)
        if (request.labels)
          std::erase_if(requests_, [&](const SurfaceRequest& old) { return old.label == request.label; });
      requests_.insert(requests_.end(), requests.begin(), requests.end());
    }
    changed_.notify_all();
  }
  void leave() {
    {
      const std::lock_guard lock(mutex_);
      left_ = true;
    }
    changed_.notify_all();
  }
  void run() {
    if (wanted_.tissues) replaceOwnLabels();
    if (wanted_.start || wanted_.hand) placeProbe(*labels_);
    makeSurfaces();
  }

 private:
  using Call = std::function<void(CaseCallbacks&)>;

  bool left() const { return left_.load(std::memory_order_relaxed); }
  void deliver(Call call) {
    const std::lock_guard lock(mutex_);
    post(std::move(call));
  }
  void post(Call call);  ///< call it with the mutex held
  void replaceOwnLabels();
  void placeProbe(const LabelMap& labels);
  bool offerSkin(const LabelMap& labels, const Error& why);
  void makeSurfaces();
  void makeSurface(const SurfaceRequest& request);

  CaseWorker* worker_;  ///< valid until the worker leaves; guarded by the mutex
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> labels_;  ///< input of all results
  Wanted wanted_;
  std::atomic<bool> left_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<SurfaceRequest> requests_;   ///< guarded by the mutex
  std::shared_ptr<const LabelMap> skin_;  ///< to place the probe on; guarded by the mutex
};

CaseWorker::CaseWorker(std::shared_ptr<const PatientCase> patient, CaseCallbacks callbacks,
                       std::vector<SurfaceRequest> requests)
    : callbacks_(std::move(callbacks)),
      job_(std::make_shared<Job>(
          *this, std::move(patient),
          Job::Wanted{callbacks_.tissues != nullptr, callbacks_.start != nullptr, callbacks_.hand != nullptr,
                      callbacks_.unplaced != nullptr, callbacks_.structures != nullptr, callbacks_.surface != nullptr,
                      callbacks_.surfacesDone != nullptr, callbacks_.failed != nullptr},
          std::move(requests))),
      thread_([job = job_] { job->run(); }) {}

CaseWorker::~CaseWorker() {
  job_->leave();
  runInBackground([thread = std::make_shared<std::thread>(std::move(thread_))] { thread->join(); });
}

void CaseWorker::place(std::shared_ptr<const LabelMap> labels) {
  job_->place(std::move(labels));
}

void CaseWorker::requestSurfaces(const std::vector<SurfaceRequest>& requests) {
  job_->requestSurfaces(requests);
}

void CaseWorker::Job::post(Call call) {
  if (left_) return;
  // Queued to the worker, and discarded if the worker is deleted first.
  QMetaObject::invokeMethod(
      worker_, [worker = worker_, call = std::move(call)] { call(worker->callbacks_); }, Qt::QueuedConnection);
}

void CaseWorker::Job::replaceOwnLabels() {
  labels_ = withTissueLabels(patient_->manifest.ownLabels, labels_);
  deliver([labels = labels_](CaseCallbacks& callbacks) { callbacks.tissues(labels); });
}

void CaseWorker::Job::placeProbe(const LabelMap& labels) {
  const auto failed = [this](const Error& error) {
    if (wanted_.failed)
      deliver([text = QString::fromStdString(error.message)](CaseCallbacks& callbacks) { callbacks.failed(text); });
  };
  const auto start = autoStartPose(CaseView(*patient_, labels));
  if (!start) {
    if (!offerSkin(labels, start.error())) failed(start.error());
    return;
  }
  if (wanted_.start) deliver([pose = *start](CaseCallbacks& callbacks) { callbacks.start(pose); });
  const auto pose = patientFromProbe(start->position_mm, start->axial, start->lateral);
  if (!pose) return failed(pose.error());
  if (left() || !wanted_.hand) return;
  auto hand = ProbePlacement::make(labels, *pose);
  if (!hand) return failed(hand.error());
  deliver([made = std::move(*hand)](CaseCallbacks& callbacks) { callbacks.hand(made); });
}

/// From a point in front of the patient, the nearest skin is that of the front, wherever the scan ends.
bool CaseWorker::Job::offerSkin(const LabelMap& labels, const Error& why) {
  if (!wanted_.unplaced) return false;
  const VolumeGeometry& grid = labels.geometry;
  const Vec3 center_mm = grid.center_mm();
  const auto pose = patientFromProbe(center_mm, {0, 1, 0}, {1, 0, 0});
  auto hand = pose ? ProbePlacement::make(labels, *pose) : Result<ProbePlacement>(tl::unexpected(pose.error()));
  if (!hand) return false;
  const double ahead_mm = 0.5 * grid.size[1] * grid.spacing_mm.y;
  hand->moveTo(center_mm - Vec3{0, ahead_mm, 0});
  // Perpendicular to the skin there, whatever its former orientation was.
  hand->tilt(-hand->state().tilt_deg);
  hand->rock(-hand->state().rock_deg);
  deliver([made = std::move(*hand), text = QString::fromStdString(why.message)](CaseCallbacks& callbacks) {
    callbacks.unplaced(made, text);
  });
  return true;
}

void CaseWorker::Job::makeSurfaces() {
  const auto present = structuresIn(*labels_);
  if (wanted_.structures)
    deliver([labels = std::vector<std::uint8_t>(present.begin(), present.end())](CaseCallbacks& callbacks) {
      callbacks.structures(labels);
    });
  std::unique_lock lock(mutex_);
  while (!left()) {
    if (const auto skin = std::exchange(skin_, nullptr)) {
      lock.unlock();
      placeProbe(*skin);
      lock.lock();
      continue;
    }
    if (requests_.empty()) {
      if (wanted_.surfacesDone) post([](CaseCallbacks& callbacks) { callbacks.surfacesDone(); });
      changed_.wait(lock, [this] { return left() || skin_ || !requests_.empty(); });
      continue;
    }
    const SurfaceRequest request = requests_.front();
    requests_.pop_front();
    lock.unlock();
    const bool there =
        request.labels ||
        (request.label == kSkin ? !present.empty() : std::ranges::find(present, request.label) != present.end());
    if (there && wanted_.surface) makeSurface(request);
    lock.lock();
  }
}

void CaseWorker::Job::makeSurface(const SurfaceRequest& request) {
  const Progress asked = [this](std::string_view, double) { return !left(); };
  const LabelMap& labels = request.labels ? *request.labels : *labels_;
  auto mesh = request.label == kSkin ? extractBody(labels, request.options, asked)
                                     : extractSurface(labels, request.label, request.options, asked);
  // A structure without a surface is not shown; this has no other effect.
  if (!mesh && !request.labels) return;
  deliver([label = request.label, made = std::make_shared<const Mesh>(mesh ? std::move(*mesh) : Mesh())](
              CaseCallbacks& callbacks) { callbacks.surface(label, made); });
}

}  // namespace insonate::ui
