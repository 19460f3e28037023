#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ProbeHand.h>
#include <insonate/surface/Mesh.h>
#include <insonate/ui/CaseWorker.h>
#include <insonate/ui/Workspace.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::train {

class StatusLine;

/// The open case, and what a worker thread finds in it: tissues, structures, start pose and surfaces.
class CaseModel : public QObject {
  Q_OBJECT

 public:
  explicit CaseModel(StatusLine& status, QObject* parent = nullptr);
  ~CaseModel() override;

  /// Sets the case and stops all work on the former one. Null for none. `origin`: its folder.
  void setCase(std::shared_ptr<const PatientCase> patient, const ui::CaseOrigin& origin);
  const ui::CaseOrigin& origin() const { return origin_; }
  const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
  /// The patient's labels as tissues (cases/TissueLabels.h), on which the user trains. Null until tissuesKnown().
  const std::shared_ptr<const LabelMap>& tissueLabels() const { return tissueLabels_; }
  /// Ends the threads of the case and of its live images; within a second.
  void stop();

  /// The labels of the case; none until the worker has read them.
  const std::optional<std::vector<std::uint8_t>>& structures() const { return structures_; }
  /// Tells whether structures() are known and include neither vein nor artery.
  bool lacksVessels() const;

  /// Pose in which the probe starts; known before the first image.
  const StartPose& start() const { return start_; }
  /// Sets the start pose; live imaging begins there.
  void setStart(StartPose pose);

  /// Makes the surfaces. The image comes first; where there is none, nothing is to be waited for.
  void wantSurfaces();
  /// All surfaces that are shown have been made.
  bool surfacesThere() const { return surfacesThere_; }
  /// Reports that this case will have no image, and why.
  void fail(const QString& why);

 Q_SIGNALS:
  void stopping();  ///< the threads of the case end
  void emptied();   ///< nothing of the former case may be used any more; before caseChanged()
  void caseChanged();
  void caseShown();     ///< after all have received caseChanged()
  void tissuesKnown();  ///< tissueLabels()
  void startKnown();    ///< start()
  void handMade(const insonate::ProbeHand& hand);
  void startMissing(const insonate::ProbeHand& hand);  ///< no start pose is stored, and none was found
  void structuresKnown();                              ///< structures()
  void surfaceMade(int label, std::shared_ptr<const insonate::Mesh> mesh);
  void surfacesDone();
  void failed(const QString& what);

 private:
  void startWorker();

  StatusLine& status_;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> tissueLabels_;
  ui::CaseOrigin origin_;
  std::optional<std::vector<std::uint8_t>> structures_;
  StartPose start_;
  bool surfacesWanted_ = false, surfacesThere_ = false;
  std::unique_ptr<ui::CaseWorker> worker_;
};

}  // namespace insonate::train
