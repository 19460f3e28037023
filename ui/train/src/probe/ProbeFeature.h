#pragma once

#include "../feature/Feature.h"
#include "../model/ProbeControl.h"

namespace insonate::train {

class FovHandles;
class HeldPress;
class Positions;
class ProbeChooser;
class ProbeEditor;
class ProbeLibrary;

/// The feature for the probe: moves by keys and numbers, positions, the choice of probe, and the editor of its shape.
class ProbeFeature final : public Feature {
  Q_OBJECT

 public:
  ProbeFeature(TrainModel& model, TrainLayout& layout);

  /// The list of probes, for the section of image settings.
  QWidget& chooser();

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  void addCommands();
  void addMoves();
  ui::CommandKey moveKey(int key, HandAxis axis, double step, double wide) const;
  QWidget* buildPositionSection();
  void buildEditor();
  void edit(bool isEdited);
  void fitToImage();

  ProbeLibrary* library_;
  ProbeChooser* chooser_;
  Positions* positions_ = nullptr;
  ProbeEditor* editor_ = nullptr;
  FovHandles* handles_ = nullptr;
  HeldPress* heldPress_;
};

}  // namespace insonate::train
