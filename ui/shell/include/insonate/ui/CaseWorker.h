#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ProbeHand.h>
#include <insonate/surface/ExtractSurface.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace insonate::ui {

/// Results that a case needs before a hand can move over it and 3D can show it, in the order in which they arrive. All
/// callbacks run on the window's thread; results whose callback is empty are not computed.
struct CaseWork {
  /// The labels as tissues (cases/TissueLabels.h), of which all that follows is made then; where this is left empty,
  /// all is made of the author's own.
  std::function<void(std::shared_ptr<const LabelMap>)> tissues;
  std::function<void(StartPose)> start;  ///< where the probe begins
  std::function<void(ProbeHand)> hand;
  /// Called in place of both if the case has no start pose and none is found: a hand on the skin nearest to the front,
  /// and the reason. If this is empty, or there is no skin, failed() is called.
  std::function<void(ProbeHand, QString)> unplaced;
  std::function<void(std::vector<std::uint8_t>)> structures;                     ///< the labels that occur
  std::function<void(std::uint8_t label, std::shared_ptr<const Mesh>)> surface;  ///< kSkin is the whole body's outside
  std::function<void()> surfacesDone;   ///< all that were wanted so far have come
  std::function<void(QString)> failed;  ///< a sentence; what comes after it in the order may still come
};

/// A surface that is wanted. Structures that the patient does not have are left out.
struct SurfaceWish {
  std::uint8_t label = 0;
  SurfaceOptions options;
  /// Labels in place of the patient's, for example while they are edited: a structure that is gone arrives as an empty
  /// mesh, and of waiting requests for a label the last counts.
  std::shared_ptr<const LabelMap> labels{};
};

/// Computes on a thread of its own. The destructor asks it to stop and drops undelivered results, without waiting: the
/// running step ends in the background (see waitForJobs).
class CaseWorker : public QObject {
 public:
  CaseWorker(std::shared_ptr<const PatientCase> patient, CaseWork work, std::vector<SurfaceWish> wishes);
  ~CaseWorker() override;

  /// The probe is put on these labels in place of the patient's, e.g. when there is skin at last: what comes is as in
  /// the beginning. Of several that wait, the last counts.
  void place(std::shared_ptr<const LabelMap> labels);
  /// Requests further surfaces, after those requested before.
  void want(const std::vector<SurfaceWish>& wishes);

 private:
  class Job;

  CaseWork work_;
  std::shared_ptr<Job> job_;
  std::thread thread_;
};

}  // namespace insonate::ui
