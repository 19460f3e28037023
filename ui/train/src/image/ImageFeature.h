#pragma once

#include "../feature/Feature.h"

#include <QString>
#include <memory>

class QAction;
class QLabel;

namespace insonate {
struct ImagingSetup;
}

namespace insonate::train {

class CineBar;
class CtBeside;
class EqualPanes;
class ImageExports;
class ImagePanel;
class Measurements;
class StructureNames;

/// The feature for the ultrasound image: settings, measurements, the images of the last seconds, the CT beside the
/// image, and export.
class ImageFeature final : public Feature {
  Q_OBJECT

 public:
  /// `probeChooser`: shown in the section of image settings.
  ImageFeature(TrainModel& model, TrainLayout& layout, QWidget& probeChooser);

  ImageExports& exports() { return *exports_; }

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;
  void setOpeningText(const QString& what) override;
  void setCompact(bool isCompact) override;

 private:
  void addCommands();
  void addMeasuring();
  void listGestures();
  void buildNames();
  void buildColumn();
  void buildInput();
  void connectModel();
  void showCase();
  void showPlacing();
  void showImage();
  void showNotice();
  void showFrozen();
  void showStale();
  void setCtBeside(bool isShown);

  ImagePanel* panel_ = nullptr;
  QAction* besideAction_ = nullptr;
  QLabel *empty_ = nullptr, *vesselNote_ = nullptr;
  EqualPanes* panes_ = nullptr;  ///< contains the image and the CT beside it
  CtBeside* beside_ = nullptr;
  CineBar* cine_ = nullptr;
  StructureNames* names_ = nullptr;
  Measurements* measurements_ = nullptr;
  ImageExports* exports_ = nullptr;
  std::shared_ptr<const ImagingSetup> shape_;  ///< setup for which the image was laid out
  bool isOneEffect_ = false, isImageThere_ = false, isCoarse_ = false;
};

}  // namespace insonate::train
