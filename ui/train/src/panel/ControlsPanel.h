#pragma once

#include "../layout/ScrollingColumn.h"

#include <array>
#include <vector>

class QComboBox;
class QPushButton;
class QSettings;
class QVBoxLayout;

namespace insonate {
struct ImagingSettings;
}
namespace insonate::ui {
class ValueSlider;
}

namespace insonate::train {

class GainSliders;
class NeedleControls;
class Positions;
class ProbeChooser;
class ProbeLibrary;
class ProbeNumbers;
struct TrainModel;

/// The narrow panel: where the probe is, and how the image is made, the most used first; freeze at its foot.
class ControlsPanel : public ScrollingColumn {
 public:
  ControlsPanel(TrainModel& model, ProbeLibrary& library, QWidget* parent = nullptr);

  Positions& positions() { return *positions_; }
  ProbeChooser& probes() { return *probe_; }
  NeedleControls& needle() { return *needle_; }
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  struct Slider {
    double ImagingSettings::*field = nullptr;
    ui::ValueSlider* widget = nullptr;
  };
  QWidget* buildPositionSection();
  QWidget* buildPicture();
  void buildProcessing(QVBoxLayout& box);
  GainSliders* gains(std::array<double, 8> ImagingSettings::*field, GainSliders* sliders);
  QWidget* buildFreeze();
  void addSliders(QVBoxLayout& box, std::size_t first, std::size_t last);
  QWidget* labelled(const QString& name, QWidget* widget);
  void refresh();
  void refreshFreeze();
  void change(double ImagingSettings::*field, double value);

  TrainModel& model_;
  ProbeLibrary& library_;
  Positions* positions_ = nullptr;
  ProbeNumbers* numbers_ = nullptr;
  NeedleControls* needle_ = nullptr;
  ProbeChooser* probe_ = nullptr;
  std::vector<Slider> sliders_;
  GainSliders* tgc_ = nullptr;
  GainSliders* lateral_ = nullptr;
  QComboBox* grayMap_ = nullptr;
  QComboBox* compounding_ = nullptr;
  QComboBox* look_ = nullptr;
  QComboBox* effect_ = nullptr;
  std::vector<QWidget*> anatomy_;  ///< not shown where anatomy is not disclosed
  QPushButton* freeze_ = nullptr;
  bool refreshing_ = false;
};

}  // namespace insonate::train
