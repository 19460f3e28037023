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

/// Results that the live image and the 3D scene need of a case, in the order in which they arrive. All callbacks run on
/// the window's thread; a result whose callback is empty is not computed.
struct CaseWork {
  /// The labels as tissues (cases/TissueLabels.h), from which all later results are then computed. If this is empty,
  /// they are computed from the author's labels.
  std::function<void(std::shared_ptr<const LabelMap>)> tissues;
  std::function<void(StartPose)> start;  ///< initial pose of the probe
  std::function<void(ProbeHand)> hand;
  /// Called in place of both `start` and `hand` if the case has no start pose and none is found: with a hand on the
  /// skin nearest to the front, and the reason. If this is empty, or there is no skin, failed() is called.
  std::function<void(ProbeHand, QString)> unplaced;
  std::function<void(std::vector<std::uint8_t>)> structures;  ///< the labels that occur in the patient
  std::function<void(std::uint8_t label, std::shared_ptr<const Mesh>)> surface;  ///< kSkin is the whole body's outside
  std::function<void()> surfacesDone;   ///< all surfaces that were requested so far have arrived
  std::function<void(QString)> failed;  ///< an error message; later results may still arrive
};

/// Request for a surface. Structures that the patient does not have are left out.
struct SurfaceWish {
  std::uint8_t label = 0;
  SurfaceOptions options;
  /// Labels to use in place of the patient's, for example during editing. A structure that no longer exists arrives as
  /// an empty mesh. Of several waiting requests for one label, only the last is computed.
  std::shared_ptr<const LabelMap> labels{};
};

/// Computes on a background thread. The destructor asks the thread to stop and drops undelivered results without
/// waiting: the running step ends in the background (see waitForJobs).
class CaseWorker : public QObject {
 public:
  CaseWorker(std::shared_ptr<const PatientCase> patient, CaseWork work, std::vector<SurfaceWish> wishes);
  ~CaseWorker() override;

  /// Places the probe on these labels in place of the patient's, for example when skin has been labeled. The results
  /// arrive as at the beginning. Of several waiting requests, only the last is computed.
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
