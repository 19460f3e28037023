#pragma once

#include "attempt/Disclosure.h"
#include "hand/History.h"
#include "hand/ProbeControl.h"
#include "hands/HandsControl.h"
#include "tissue/TissueChoice.h"

#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/surface/Mesh.h>
#include <insonate/ui/CaseWorker.h>
#include <insonate/ui/LiveFeed.h>
#include <insonate/ui/Workspace.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate::train {

/// Mediates between the controls and the views: a patient, the probe in the hand, its live images, and the last
/// seconds of them. Knows no widget.
class TrainSession : public QObject {
  Q_OBJECT

 public:
  static constexpr double kCine_s = 12;
  /// Every effect together, in effect().
  static constexpr const char* kWholeModel = "";

  explicit TrainSession(QObject* parent = nullptr);
  ~TrainSession() override;

  /// Sets the case and stops all work on the former one. Null for none. `origin`: its folder.
  void setCase(std::shared_ptr<const PatientCase> patient, const ui::CaseOrigin& origin);
  const ui::CaseOrigin& origin() const { return origin_; }
  const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
  /// The patient's labels as tissues (cases/TissueLabels.h), on which the user trains. Null until tissuesKnown().
  const std::shared_ptr<const LabelMap>& tissueLabels() const { return tissueLabels_; }
  /// Ends the threads; within a second.
  void stop();

  // Probe and settings
  const Probe& probe() const { return probe_; }
  const ImagingSettings& settings() const { return settings_; }
  /// A preset; depth, frequency and focus become the probe's own, the rest stays. False for an unknown name.
  bool setProbe(const std::string& name);
  /// Uses a probe while it is being edited. Consecutive changes of one kind (`what`) are undone together. If the
  /// probe's default depth, frequency or focus differ from before, the image takes them, too. Refuses a probe out of
  /// range.
  Result<void> useProbe(const Probe& probe, const std::string& what);
  /// Applies settings; values outside the probe's range are set to the nearest permitted ones.
  void setSettings(ImagingSettings settings);
  /// All that decides the images now, for an attempt that is recorded. There must be a picture.
  AttemptSettings attemptSettings() const;
  /// Shows one effect of EffectLayers.h by itself; refused where anatomy is not disclosed.
  void setEffect(const std::string& name);
  const std::string& effect() const { return effect_; }
  /// The next in the order of effectLayers(), the whole model between the last and the first.
  void stepEffect(int by);

  // Disclosure of anatomy on the screen
  const Disclosure& disclosure() const { return disclosure_; }
  /// Restores the whole image where anatomy is disclosed no longer; undo does not lead behind it.
  void setDisclosure(const Disclosure& disclosure);
  /// Tells whether anatomy is disclosed; if not, says so to the user.
  bool mayShowAnatomy();

  // Tissue and blood
  const TissueChoice& tissue() const { return tissue_; }
  /// Applies a choice; values out of range are refused with a sentence.
  void setTissue(const TissueChoice& choice);
  /// Live images come with the mesh of the tissue.
  void setMeshWanted(bool wanted);
  /// While unwatched, the vessels do not move: a probe at rest then costs nothing.
  void setWatched(bool watched);
  /// Asleep, the last image stays, and no others are made; their scenes are given back.
  void setAwake(bool awake);

  /// Needle, devices and pedal.
  HandsControl& hands() { return hands_; }
  void takeNeedle(NeedlePlane plane);
  /// Takes up the needle as it was held last, or puts it away.
  void toggleNeedle();
  void moveNeedle(NeedleAxis axis, double mmOrDegrees);
  void typedNeedle(NeedleAxis axis, double value);

  // The probe in the hand. Moves are refused while the image is frozen, and while a device holds the probe.
  bool handReady() const { return control_.ready(); }
  HandNumbers numbers() const { return control_.numbers(); }
  ProbeHandState handState() const;
  Transform pose() const;
  /// The moves up to the next call are undone together.
  void beginGesture() { control_.begin(); }
  void move(HandAxis axis, double mmOrDegrees);
  void slide(double lateral_mm, double elevation_mm);
  void typed(HandAxis axis, double value);
  void moveTo(Vec3 patient_mm);
  /// Moves to the skin nearest to a typed place; says how far that is.
  void placed(Vec3 patient_mm);
  /// Refused in a level and while anatomy is not disclosed: a position reveals the place of vessels.
  void goTo(const StartPose& pose);
  void home();
  /// Undoes moves, settings, and all other steps in history().
  void undo();
  void redo();
  History& history() { return history_; }
  /// Destination of home(); known before the first image.
  const StartPose& start() const { return start_; }
  /// Puts the probe at the start of an attempt at a level; until releaseStart(), home() returns there, undo ends
  /// there, and goTo() refuses. A device's probe stays in place.
  void beginAt(const ProbeHandState& state);
  void releaseStart() { levelStart_.reset(); }
  /// The target of an attempt is the vein nearest to here: the probe, or in a level the case's own start, since beside
  /// the vein another may be nearer.
  Vec3 targetNear_mm() const;
  /// The probe as home() would put it at the case's own start.
  std::optional<ProbeHand> handAtStart() const;

  /// The case has no start pose and none was found: the probe waits for placeOnSkin().
  bool isUnplaced() const { return unplaced_.has_value(); }
  /// Moves to the skin nearest to the front; further moves start there.
  void placeOnSkin();
  /// The labels of the case; none until they have been looked through.
  const std::optional<std::vector<std::uint8_t>>& structures() const { return structures_; }
  /// They have been, and no vein or artery is among them.
  bool lacksVessels() const;

  // Images
  bool isFrozen() const { return frozen_; }
  void setFrozen(bool frozen);
  /// The image on display: live, or one of the past; null before the first.
  const std::shared_ptr<const LiveFrame>& shown() const { return shown_; }
  /// The last seconds of a frozen image, oldest first.
  const std::vector<std::shared_ptr<const LiveFrame>>& cine() const { return cine_; }
  int cineIndex() const { return cineIndex_; }
  void showCine(int index);

  /// All surfaces that are shown have been made.
  bool surfacesThere() const { return surfacesThere_; }
  LiveStatus status() const;
  double imagesPerSecond() const;
  /// Sentence about the last event, or the next thing to do.
  QString message() const { return message_; }
  /// Shows a sentence about an event for some seconds.
  void say(const QString& sentence);
  /// The next thing to do while nothing has happened; empty for the usual.
  void setHint(const QString& hint);
  static constexpr int kSaid_ms = 7000;

 Q_SIGNALS:
  void caseChanged();
  void tissuesKnown();  ///< tissueLabels()
  void pictureShown();
  void handMoved();  ///< also when it is there for the first time
  void setupChanged();
  void tissueChanged();
  void frozenChanged();
  void placingChanged();  ///< isUnplaced()
  void disclosureChanged();
  void structuresKnown();  ///< structures()
  void messageChanged();
  void surfaceMade(int label, std::shared_ptr<const insonate::Mesh> mesh);
  void surfacesDone();
  void failed(const QString& what);

 private:
  void startLive();
  void startWorker();
  QString standing() const;
  void wantSurfaces();
  void news();
  void show(std::shared_ptr<const LiveFrame> frame);
  void sendSetup();
  bool pulsates() const;
  LiveOptions liveOptions() const;
  void useTissue(const TissueChoice& choice);
  void updateTissueRequest();
  void moved(HandMove result);
  bool mayMove();
  bool isLive();
  void connectHands();
  void giveHands();
  void giveProbe();
  ImagingSetup setup() const;
  void rememberMove(const ProbeHandState& before);
  void rememberSetup();
  void showHistoryOutcome(History::Outcome outcome, const QString& done, const QString& nothing);

  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> tissueLabels_;
  ui::CaseOrigin origin_;
  Probe probe_;
  ImagingSettings settings_;
  AcousticTable tissues_;
  std::string effect_ = kWholeModel;
  TissueChoice tissue_;
  Disclosure disclosure_;
  bool meshWanted_ = false, watched_ = true, awake_ = true;
  ProbeControl control_;
  History history_;
  struct Chosen {
    Probe probe;
    ImagingSettings settings;
    std::string effect;
  };
  Chosen chosen_;         ///< as last sent
  std::string editKind_;  ///< of the probe, for history_; empty outside useProbe()
  StartPose start_;
  std::optional<ProbeHandState> levelStart_;
  bool frozen_ = false;
  std::shared_ptr<const LiveFrame> shown_;
  std::vector<std::shared_ptr<const LiveFrame>> cine_;
  int cineIndex_ = 0;
  std::optional<ProbeHand> unplaced_;
  std::optional<std::vector<std::uint8_t>> structures_;
  QString message_, hint_;
  QTimer said_;
  std::string failure_;  ///< of the live probe, as last said
  HandsControl hands_;
  ui::LiveFeed feed_;
  bool surfacesWanted_ = false, surfacesThere_ = false;
  std::unique_ptr<ui::CaseWorker> worker_;
};

/// Within what validate() accepts for this probe.
ImagingSettings fitted(ImagingSettings settings, const Probe& probe);

}  // namespace insonate::train
