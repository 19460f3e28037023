#pragma once

#include "TissueChoice.h"

#include <insonate/simulator/Imager.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/ultrasound/Probe.h>

#include <QObject>
#include <string>

namespace insonate::train {

class DisclosureModel;
class History;
class StatusLine;

/// The user's choices that decide the image: probe, settings, single effect, tissue and blood. Each change can be
/// undone.
class ImagingModel : public QObject {
  Q_OBJECT

 public:
  /// Every effect together, in effect().
  static constexpr const char* kWholeModel = "";

  ImagingModel(DisclosureModel& disclosure, History& history, StatusLine& status, QObject* parent = nullptr);

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

  /// Shows one effect of EffectLayers.h by itself; refused where anatomy is not disclosed.
  void setEffect(const std::string& name);
  const std::string& effect() const { return effect_; }
  /// The next in the order of effectLayers(), the whole model between the last and the first.
  void stepEffect(int by);

  const TissueChoice& tissue() const { return tissue_; }
  /// Applies a choice; values out of range are refused with a sentence.
  void setTissue(const TissueChoice& choice);
  /// Tilts the table; above 0 the head is down.
  void setTilt(double tilt_deg);

  /// All of it, for the simulator.
  ImagingSetup setup() const;

 Q_SIGNALS:
  void setupChanged();
  void physiologyChanged();  ///< before setupChanged() of another model of the tissue
  void tissueChanged();

 private:
  struct Chosen {
    Probe probe;
    ImagingSettings settings;
    std::string effect;
  };
  void hideAnatomy();
  void announceSetup();
  void rememberSetup();
  void useTissue(const TissueChoice& choice);

  DisclosureModel& disclosure_;
  History& history_;
  StatusLine& status_;
  Probe probe_;
  ImagingSettings settings_;
  AcousticTable tissues_;
  std::string effect_ = kWholeModel;
  TissueChoice tissue_;
  Chosen chosen_;         ///< as last announced
  std::string editKind_;  ///< of the probe, for history_; empty outside useProbe()
};

/// Within what validate() accepts for this probe.
ImagingSettings fitted(ImagingSettings settings, const Probe& probe);

}  // namespace insonate::train
