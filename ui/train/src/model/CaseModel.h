#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ProbePlacement.h>
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

/// The open case, and the results that a background thread computes from it: tissues, structures, start pose and
/// surfaces.
class CaseModel : public QObject {
  Q_OBJECT

 public:
  explicit CaseModel(StatusLine& status, QObject* parent = nullptr);
  ~CaseModel() override;

  /// Sets the case and stops all work on the former case; null: no case. `origin`: the case's origin.
  void setCase(std::shared_ptr<const PatientCase> patient, const ui::CaseOrigin& origin);
  const ui::CaseOrigin& origin() const { return origin_; }
  const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
  /// The patient's labels as tissues (cases/TissueLabels.h), on which the user trains. Null until tissuesKnown().
  const std::shared_ptr<const LabelMap>& tissueLabels() const { return tissueLabels_; }
  /// Ends the background threads of the case and of its live images, within a second.
  void stop();

  /// The case's labels; empty until the background thread has read them.
  const std::optional<std::vector<std::uint8_t>>& structures() const { return structures_; }
  /// Tells whether structures() is known and includes neither vein nor artery.
  bool lacksVessels() const;

  /// Start pose of the probe; known before the first image.
  const StartPose& start() const { return start_; }
  /// Sets the start pose, at which live imaging begins.
  void setStart(StartPose pose);

  /// Requests the surfaces. They are computed after the first image or, if there will be no image, at once.
  void wantSurfaces();
  /// Tells whether all visible surfaces have been computed.
  bool surfacesThere() const { return surfacesThere_; }
  /// Reports that there will be no image of this case; `why` is a sentence.
  void fail(const QString& why);

 Q_SIGNALS:
  void stopping();  ///< emitted when the threads of the case are about to end
  void emptied();   ///< emitted before caseChanged(); data of the former case must not be used any more
  void caseChanged();
  void caseShown();     ///< emitted after all receivers have handled caseChanged()
  void tissuesKnown();  ///< emitted when tissueLabels() is set
  void startKnown();    ///< emitted when start() is set
  void handMade(const insonate::ProbePlacement& hand);
  void startMissing(
      const insonate::ProbePlacement& hand);  ///< emitted when the case has no start pose, and none was found
  void structuresKnown();                     ///< emitted when structures() is set
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
  bool surfacesRequested_ = false, surfacesThere_ = false;
  std::unique_ptr<ui::CaseWorker> worker_;
};

}  // namespace insonate::train
