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

/// The user's choices that determine the image: probe, settings, single effect, tissue and blood. Each change can be
/// undone.
class ImagingModel : public QObject {
  Q_OBJECT

 public:
  /// Value of effect() that stands for all effects together.
  static constexpr const char* kWholeModel = "";

  ImagingModel(DisclosureModel& disclosure, History& history, StatusLine& status, QObject* parent = nullptr);

  const Probe& probe() const { return probe_; }
  const ImagingSettings& settings() const { return settings_; }
  /// Sets a preset probe. Depth, frequency and focus become the probe's defaults; other settings stay. Returns false
  /// for an unknown name.
  bool setProbe(const std::string& name);
  /// Uses a probe that is being edited. Consecutive changes of one kind (`what`) are undone together. If the probe's
  /// default depth, frequency or focus has changed, the image uses the new default. Fails for a probe that is out of
  /// range.
  Result<void> useProbe(const Probe& probe, const std::string& what);
  /// Applies settings; values outside the probe's range are set to the nearest permitted ones.
  void setSettings(ImagingSettings settings);

  /// Settings of color Doppler; they are kept while color is off.
  const ColorSettings& color() const { return color_; }
  bool isColorOn() const { return colorOn_; }
  /// Switches color Doppler on or off, and applies its settings; values that probe and depth do not permit are set to
  /// the nearest permitted ones.
  void setColor(bool isOn, const ColorSettings& color);

  /// Shows a single effect of EffectLayers.h. Refused while anatomy is not disclosed.
  void setEffect(const std::string& name);
  const std::string& effect() const { return effect_; }
  /// Shows the effect that is `by` places further in the order of effectLayers(). The whole model comes after the last
  /// and before the first effect.
  void stepEffect(int by);

  const TissueChoice& tissue() const { return tissue_; }
  /// Applies the choice. If values are out of range, nothing changes and a sentence is shown.
  void setTissue(const TissueChoice& choice);
  /// Tilts the table; the head is down for values above 0.
  void setTilt(double tilt_deg);

  /// Returns all choices as a setup for the simulator.
  ImagingSetup setup() const;

 Q_SIGNALS:
  void setupChanged();
  void physiologyChanged();  ///< emitted before setupChanged() if blood pressure, tilt or the tissue model has changed
  void tissueChanged();

 private:
  struct Chosen {
    Probe probe;
    ImagingSettings settings;
    std::string effect;
    ColorSettings color;
    bool colorOn;
  };
  Chosen choices() const { return {probe_, settings_, effect_, color_, colorOn_}; }
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
  ColorSettings color_;
  bool colorOn_ = false;
  TissueChoice tissue_;
  Chosen chosen_;         ///< the choices when setupChanged() was emitted last
  std::string editKind_;  ///< kind of the present probe edit, for history_; empty outside useProbe()
};

/// Returns the settings, limited to what validate() accepts for this probe.
ImagingSettings fitted(ImagingSettings settings, const Probe& probe);
/// Returns the color settings, limited to what validate() accepts for this probe and these settings.
ColorSettings fitted(ColorSettings color, const Probe& probe, const ImagingSettings& settings);

}  // namespace insonate::train
