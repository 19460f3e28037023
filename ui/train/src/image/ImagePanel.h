#pragma once

#include <QWidget>
#include <array>
#include <vector>

class QCheckBox;
class QComboBox;
class QSettings;
class QVBoxLayout;

namespace insonate {
struct ImagingSettings;
}
namespace insonate::ui {
class Commands;
class ValueSlider;
}  // namespace insonate::ui

namespace insonate::train {

class DisclosureModel;
class GainSliders;
class ImagingModel;

/// Section with the image settings, the most used first.
class ImagePanel final : public QWidget {
 public:
  /// `probeChooser` is shown first.
  ImagePanel(DisclosureModel& disclosure, ImagingModel& imaging, QWidget& probeChooser, const ui::Commands& commands,
             QWidget* parent = nullptr);

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  struct Slider {
    double ImagingSettings::*field = nullptr;
    ui::ValueSlider* widget = nullptr;
  };
  void buildProcessing(QVBoxLayout& box);
  GainSliders* gains(std::array<double, 8> ImagingSettings::*field, GainSliders* sliders);
  void buildModel(QVBoxLayout& box, const ui::Commands& commands);
  void addSliders(QVBoxLayout& box, std::size_t first, std::size_t last);
  QWidget* labeled(const QString& name, QWidget* widget);
  void refresh();
  void change(double ImagingSettings::*field, double value);

  ImagingModel& imaging_;
  std::vector<Slider> sliders_;
  GainSliders* tgc_ = nullptr;
  GainSliders* lateral_ = nullptr;
  QComboBox* grayMap_ = nullptr;
  QComboBox* compounding_ = nullptr;
  QCheckBox* harmonic_ = nullptr;
  QComboBox* look_ = nullptr;
  QComboBox* effect_ = nullptr;
  bool refreshing_ = false;
};

}  // namespace insonate::train
