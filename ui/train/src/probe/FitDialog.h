#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <QDialog>
#include <QImage>
#include <functional>
#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QPushButton;

namespace insonate::ui {
class TaskBar;
class ValueSlider;
}  // namespace insonate::ui

namespace insonate::train {

class FitCanvas;

/// Makes a probe from a photograph or screen capture of a scanner. The image comes from a file, a drop or the
/// clipboard. A background thread fits a field of view to the image, and the dialog shows it over the image; the user
/// corrects the fit. The image is discarded when the dialog closes.
class FitDialog : public QDialog {
  Q_OBJECT

 public:
  /// `base` provides the values that cannot be determined from an image.
  explicit FitDialog(const Probe& base, QWidget* parent = nullptr);
  ~FitDialog() override;

  /// Loads and fits an image; errors are shown in the dialog.
  void openPicture(const QString& file);
  void paste();
  bool isWorking() const;
  QString message() const;

  /// The fitted probe, after Apply.
  const Probe& probe() const { return probe_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Loaded;
  QWidget* buildSide();
  void connectSide(QPushButton* open, QPushButton* pasteButton, QPushButton* cancel);
  void load(const QString& title, std::function<Result<QImage>()> read);
  void fitted(Result<std::shared_ptr<Loaded>> result);
  void placeByHand();
  void showShape();
  void chooseShape(int shape);
  void depthTyped(double depth_mm);
  void marksTyped(double mm);
  void drawLine();
  void lineDrawn();
  void lineTyped(double mm);
  double line_px() const;  ///< returns the length of the drawn line; 0 if there is none
  void takeOver();
  void say(const QString& sentence, bool error);

  Probe base_, probe_;
  QImage picture_;
  QString doubts_;  ///< notes about uncertainties of the fit
  std::optional<DepthRuler> ruler_;
  FitCanvas* canvas_;
  ui::TaskBar* tasks_;
  QComboBox* shape_ = nullptr;
  ui::ValueSlider *depth_ = nullptr, *marks_ = nullptr, *rotation_ = nullptr, *line_ = nullptr;
  QLabel *error_ = nullptr, *notes_ = nullptr, *values_ = nullptr;
  QPushButton *take_ = nullptr, *draw_ = nullptr;
  double mmPerPx_ = 1;
  double typedDepth_mm_ = 0;  ///< depth; above 0, it determines the scale; else the image determines the scale
  bool refreshing_ = false;
};

}  // namespace insonate::train
