#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ProbePlacement.h>
#include <insonate/surface/ExtractSurface.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace insonate::ui {

/// Callbacks for the results that the live image and the 3D scene need of a case, in the order in which the results
/// arrive. All callbacks run on the window's thread. A result is not computed if its callback is empty.
struct CaseCallbacks {
  /// Receives the case's label map after the labels that the author defined are replaced by the labels of their tissues
  /// (cases/TissueLabels.h). All later results are computed from this map. If this callback is empty, they are computed
  /// from the unchanged label map of the case.
  std::function<void(std::shared_ptr<const LabelMap>)> tissues;
  std::function<void(StartPose)> start;  ///< initial pose of the probe
  std::function<void(ProbePlacement)> hand;
  /// Called in place of `start` and `hand` if the case has no start pose and none can be proposed. Receives a
  /// ProbePlacement on the frontmost skin, and a sentence that says why no start pose could be proposed. If this
  /// callback is empty, or if there is no skin, `failed` is called.
  std::function<void(ProbePlacement, QString)> unplaced;
  std::function<void(std::vector<std::uint8_t>)> structures;  ///< the labels that occur in the patient
  /// receives a surface; the surface with the label kSkin is the surface of the whole body
  std::function<void(std::uint8_t label, std::shared_ptr<const Mesh>)> surface;
  std::function<void()> surfacesDone;   ///< called when all surfaces that were requested so far have arrived
  std::function<void(QString)> failed;  ///< receives an error message; other results may still arrive after it
};

/// Request for the surface of a structure. A structure that the patient does not have gives no result.
struct SurfaceRequest {
  std::uint8_t label = 0;
  SurfaceOptions options;
  /// Label map to use in place of the patient's, for example during editing. A structure that this map does not contain
  /// gives an empty mesh. Of several waiting requests for one label, only the last is computed.
  std::shared_ptr<const LabelMap> labels{};
};

/// Computes the results of CaseCallbacks on a background thread. The destructor does not wait: it asks the thread to
/// stop, and discards results that have not been passed to the callbacks. The step in progress ends in the background
/// (see waitForJobs()).
class CaseWorker : public QObject {
 public:
  CaseWorker(std::shared_ptr<const PatientCase> patient, CaseCallbacks callbacks, std::vector<SurfaceRequest> requests);
  ~CaseWorker() override;

  /// Computes the initial pose of the probe (callbacks `start`, `hand` or `unplaced` of CaseCallbacks) again, on these
  /// labels in place of the patient's, for example after skin was labeled. Of several waiting requests, only the last
  /// is computed.
  void place(std::shared_ptr<const LabelMap> labels);
  /// Requests further surfaces. They are computed after those that were requested before.
  void requestSurfaces(const std::vector<SurfaceRequest>& requests);

 private:
  class Job;

  CaseCallbacks callbacks_;
  std::shared_ptr<Job> job_;
  std::thread thread_;
};

}  // namespace insonate::ui
