#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/simulator/ProbeHand.h>
#include <insonate/surface/Mesh.h>

#include <QObject>
#include <QString>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>

namespace insonate::train {

/// What a case needs before a hand can move over it and 3D can show it, in the order in which it comes. All are called
/// on the window's thread.
struct CaseWork {
  std::function<void(StartPose)> start;  ///< where the probe begins
  std::function<void(ProbeHand)> hand;
  std::function<void(std::uint8_t label, std::shared_ptr<const Mesh>)> surface;  ///< kSkin is the whole body's outside
  std::function<void(QString)> failed;  ///< a sentence; what comes after it in the order may still come
};

/// Computes on a thread of its own. The destructor cancels, drops what was not delivered yet, and takes no longer than
/// the step in work (a fraction of a second).
class CaseWorker : public QObject {
 public:
  CaseWorker(std::shared_ptr<const PatientCase> patient, CaseWork work);
  ~CaseWorker() override;

 private:
  void run();
  void surfaces();
  void deliver(std::function<void()> call);
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  std::shared_ptr<const PatientCase> patient_;
  CaseWork work_;
  std::atomic<bool> cancelled_{false};
  std::thread thread_;
};

}  // namespace insonate::train
